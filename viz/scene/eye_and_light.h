// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment's camera as a frame, and its light as a homogeneous point.
#pragma once

#include "geom/frustum.h"
#include "scene/experiment.h"

namespace psm {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

inline ViewFrame camera_frame(const Experiment& x) {
  const double tan_y = std::tan(x.camera.vertical_fov_deg * kRadiansPerDegree / 2);
  return view_frame(x.camera.position, x.camera.target - x.camera.position, x.camera.up, tan_y * x.image.aspect(), tan_y);
}

/// The square pyramid around a spot's cone.
inline ViewFrame spot_frame(const LightSettings& spot) {
  const double tangent = std::tan(spot.cone_deg * kRadiansPerDegree / 2);
  return view_frame(spot.position, spot.target - spot.position, glm::dvec3(0, 1, 0), tangent, tangent);
}

/// World space, towards the light, as given: (to_light, 0) or (position, 1).
inline glm::dvec4 homogeneous_light(const LightSettings& light) {
  return light.type == LightType::directional ? glm::dvec4(light.to_light, 0) : glm::dvec4(light.position, 1);
}

/// Whether a surface with this unit normal sees the light, by more than vertices in float can account for: a light in the
/// surface's own plane lights neither side.
inline bool faces_light(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec4& light) {
  const glm::dvec3 from = light.w * position, to_light = glm::dvec3(light) - from;
  const double rounding = 16 * epsilon<double>() * (glm::length(glm::dvec3(light)) + glm::length(from));
  return glm::dot(normal, to_light) > rounding + 1e-7 * glm::length(to_light);
}

}  // namespace psm
