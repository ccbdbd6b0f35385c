// SPDX-License-Identifier: GPL-3.0-or-later
// A number of the experiment on its way: a lesson's animation, the camera shift (key A), the cube view (key W).
#pragma once

#include "lesson/lesson.h"
#include "scene/control.h"

namespace psm {

struct NumberPlay {
  Animation animation;
  Control control;                  // of its path
  double start = 0.0;               // seconds
  std::optional<double> last = {};  // what it set last: anything else means that the user has taken over
};

/// Sets the number for this moment; whether it has. What plays ends at its end, where the user has taken over, and where the
/// experiment does not allow the value.
bool move_number(std::optional<NumberPlay>& play, Experiment& experiment, double now);

}  // namespace psm
