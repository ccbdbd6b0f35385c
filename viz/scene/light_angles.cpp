// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light_angles.h"

#include <cmath>

#include "math/projective.h"

namespace psm {
namespace {

constexpr double half_pi = 1.57079632679489661923;

/// `v` without its part along the unit vector `n`, twice: the second pass removes what rounding left of the first.
glm::dvec3 without(const glm::dvec3& v, const glm::dvec3& n) {
  const glm::dvec3 once = v - glm::dot(v, n) * n;
  return once - glm::dot(once, n) * n;
}

}  // namespace

glm::dvec3 view_forward(const CameraSettings& camera) { return safe_normalize(camera.target - camera.position); }

double light_theta(const Experiment& e) {
  const glm::dvec3 v = view_forward(e.camera), l = safe_normalize(e.light.to_light);
  return std::atan2(glm::length(glm::cross(v, l)), glm::dot(v, l));
}

glm::dvec3 theta_side(const Experiment& e) {
  const glm::dvec3 v = view_forward(e.camera);
  const glm::dvec3 side = without(safe_normalize(e.light.to_light), v);
  if (glm::length(side) > 1e-9) return glm::normalize(without(glm::normalize(side), v));
  const glm::dvec3 up = without(safe_normalize(e.camera.up), v);
  return glm::length(up) > 0.0 ? glm::normalize(up) : perpendicular(v);
}

glm::dvec3 to_light_at(const Experiment& e, double theta, const glm::dvec3& side) {
  const glm::dvec3 v = view_forward(e.camera);
  const double cosine = theta == half_pi ? 0.0 : std::cos(theta);
  return glm::length(e.light.to_light) * (cosine * v + std::sin(theta) * side);
}

Experiment with_light_at(const Experiment& e, double theta, const glm::dvec3& middle) {
  Experiment turned = e;
  const bool is_position = e.light.type != LightType::directional;
  if (is_position) turned.light.to_light = e.light.position - middle;
  const glm::dvec3 to_light = to_light_at(turned, theta, theta_side(turned));
  turned.light = e.light;
  (is_position ? turned.light.position : turned.light.to_light) = is_position ? middle + to_light : to_light;
  return turned;
}

double phi_towards_light(const Experiment& e) {
  const glm::dmat4 view = look_along<double>(e.camera.position, e.camera.target - e.camera.position, e.camera.up);
  const glm::dvec3 l = glm::abs(glm::dvec3(view * glm::dvec4(safe_normalize(e.light.to_light), 0.0)));
  const double tan_y = std::tan(0.5 * glm::radians(e.camera.vertical_fov_deg)), tan_x = tan_y * e.image.aspect();
  const double across = std::hypot(l.x, l.y);
  return std::atan(across > 0.0 ? (l.x * tan_x + l.y * tan_y) / across : tan_y);
}

double light_depth(const Experiment& e) { return glm::dot(view_forward(e.camera), e.light.position - e.camera.position); }

glm::dvec3 position_at_depth(const Experiment& e, double depth) {
  const glm::dvec3 v = view_forward(e.camera);
  return e.camera.position + without(e.light.position - e.camera.position, v) + depth * v;
}

LightSettings with_type(const LightSettings& light, LightType type, const glm::dvec3& middle, double distance) {
  LightSettings out = light;
  out.type = type;
  if (type == light.type) return out;
  if (light.type == LightType::directional) {
    out.position = middle + distance * safe_normalize(light.to_light);
    out.target = middle;
    return out;
  }
  const glm::dvec3 aim = light.type == LightType::spot ? light.target : middle;
  if (aim == light.position) return out;
  if (type == LightType::directional) out.to_light = safe_normalize(light.position - aim);
  if (type == LightType::spot) out.target = middle;
  return out;
}

Bearing bearing_of(const glm::dvec3& to_light) {
  return {std::atan2(to_light.x, to_light.z), std::atan2(to_light.y, std::hypot(to_light.x, to_light.z))};
}

glm::dvec3 direction_of(const Bearing& b) {
  return {std::sin(b.azimuth) * std::cos(b.elevation), std::sin(b.elevation), std::cos(b.azimuth) * std::cos(b.elevation)};
}

}  // namespace psm
