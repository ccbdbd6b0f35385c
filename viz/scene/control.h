// SPDX-License-Identifier: GPL-3.0-or-later
// A control that moves one number of an experiment: a member of the table, a component of a vector, or an angle that follows from
// members.
#pragma once

#include <functional>
#include <string>

#include "scene/experiment.h"
#include "scene/result.h"

namespace psm {

/// Sets the number; an error in one line where the value or the experiment that it gives is not allowed.
using Control = std::function<std::optional<InputError>(Experiment&, double)>;

/// `path`: a number of the table ("camera.near"), a component ("light.position.x", "light.to_light.2" counts from 0), or
/// "light.theta_deg": the angle between the view direction and a directional light, which turns in the plane of the two as it
/// lies in `start`, so that a sweep through 0 stays in that plane.
Result<Control> find_control(const std::string& path, const Experiment& start);

}  // namespace psm
