// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/experiment_between.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

/// By equal factors where both are positive and finite; an infinite one is there at once.
double factor_between(double from, double to, double way) {
  if (!std::isfinite(from) || !std::isfinite(to)) return to;
  return from > 0.0 && to > 0.0 ? from * std::pow(to / from, way) : from + way * (to - from);
}

/// Turns in the plane of the two at a steady speed; its length changes by equal factors. What points the other way has no such
/// plane: it goes by any vector across.
glm::dvec3 direction_between(const glm::dvec3& from, const glm::dvec3& to, double way) {
  const double a = glm::length(from), b = glm::length(to);
  if (!(a > 0.0) || !(b > 0.0)) return to;
  const glm::dvec3 u = from / a, v = to / b;
  glm::dvec3 across = v - glm::dot(u, v) * u;
  const double sine = glm::length(across);
  const double angle = std::atan2(sine, glm::dot(u, v));
  if (!(sine > 1e-9)) {
    if (angle < 1.0) return factor_between(a, b, way) * v;
    across = glm::cross(u, std::abs(u.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
  }
  return factor_between(a, b, way) * (std::cos(way * angle) * u + std::sin(way * angle) * glm::normalize(across));
}

void light_between(const LightSettings& from, LightSettings& e, double way) {
  if (from.type != e.type) return;
  e.to_light = direction_between(from.to_light, e.to_light, way);
  e.position = glm::mix(from.position, e.position, way);
  e.target = glm::mix(from.target, e.target, way);
  e.cone_deg = glm::mix(from.cone_deg, e.cone_deg, way);
  e.radius = glm::mix(from.radius, e.radius, way);
}

void camera_between(const CameraSettings& from, CameraSettings& e, double way) {
  e.position = glm::mix(from.position, e.position, way);
  e.target = glm::mix(from.target, e.target, way);
  e.up = direction_between(from.up, e.up, way);
  e.vertical_fov_deg = glm::mix(from.vertical_fov_deg, e.vertical_fov_deg, way);
  e.near = factor_between(from.near, e.near, way);
  e.far = factor_between(from.far, e.far, way);
}

void shadow_between(const ShadowSettings& from, ShadowSettings& e, double way) {
  e.depth_bias = glm::mix(from.depth_bias, e.depth_bias, way);
  e.slope_bias = glm::mix(from.slope_bias, e.slope_bias, way);
  e.normal_bias = glm::mix(from.normal_bias, e.normal_bias, way);
  const double* shift = std::get_if<double>(&from.camera_shift);
  if (double* to = std::get_if<double>(&e.camera_shift); shift && to) *to = glm::mix(*shift, *to, way);
  if (from.plane && e.plane) e.plane = glm::mix(*from.plane, *e.plane, way);
}

}  // namespace

Experiment between(const Experiment& from, const Experiment& to, double way) {
  if (way >= 1.0 || from.scene != to.scene) return to;
  Experiment e = to;
  light_between(from.light, e.light, way);
  camera_between(from.camera, e.camera, way);
  shadow_between(from.shadow, e.shadow, way);
  e.view.world_to_cube = glm::mix(from.view.world_to_cube, to.view.world_to_cube, way);
  return e;
}

double eased(double part) {
  const double t = std::clamp(part, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace psm
