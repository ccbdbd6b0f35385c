// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment on its way to another one of the same scene.
#pragma once

#include "scene/experiment.h"

namespace psm {

/// `way` 0: `from`, 1: `to`, but for what cannot lie between two values (a technique, a resolution, a light's type, the views),
/// which is that of `to` at once. Directions turn; distances that span decades change by equal factors in equal times.
Experiment between(const Experiment& from, const Experiment& to, double way);

/// How far something that moves has come after this part of its time: 0 at the start, 1 at the end and after, gently at both.
double eased(double part);

}  // namespace psm
