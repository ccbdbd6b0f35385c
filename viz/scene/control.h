// SPDX-License-Identifier: GPL-3.0-or-later
// A control that moves one number of an experiment: a member of the table, a component of a vector, or an angle that follows from
// members.
#pragma once

#include <functional>
#include <string>

#include "scene/experiment.h"
#include "scene/result.h"

namespace psm {

class Control {
 public:
  using Read = std::function<double(Experiment&)>;
  using Assign = std::function<void(Experiment&, double)>;
  Control(std::string path, Read read, Assign assign)
      : path_(std::move(path)), read_(std::move(read)), assign_(std::move(assign)) {}

  /// Sets the number; an error in one line where the value or the experiment that it gives is not allowed.
  std::optional<InputError> operator()(Experiment& experiment, double value) const;
  /// The number as it stands; nan where a rule stands in its place.
  double value(Experiment experiment) const { return read_(experiment); }

 private:
  std::string path_;
  Read read_;
  Assign assign_;
};

/// The one derived path: the angle between the view direction and a directional light.
inline constexpr const char* kThetaControl = "light.theta_deg";

/// `path`: a number of the table ("camera.near"), a component ("light.position.x", "light.to_light.2" counts from 0), or
/// light.theta_deg: the light then turns in the plane of the view direction and itself as it lies in `start`, so that a sweep
/// through 0 stays in that plane.
Result<Control> find_control(const std::string& path, const Experiment& start);

/// What such a number may be in some experiment; an error where the path leads to no number in any.
struct ControlRange {
  double lowest, highest;
};
Result<ControlRange> control_range(const std::string& path);

}  // namespace psm
