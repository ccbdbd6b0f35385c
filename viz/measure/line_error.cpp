// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/line_error.h"

#include <algorithm>
#include <cmath>

#include "math/projective.h"
#include "scene/light_angles.h"

namespace psm {
namespace {

constexpr int kDepths = 65;

/// How far the map's image of `p` moves when p moves along `t`, over the width of the window.
double map_speed(const glm::dmat4& map_from_world, const glm::dvec3& p, const glm::dvec3& t) {
  const glm::dvec4 q = map_from_world * glm::dvec4(p, 1), d = map_from_world * glm::dvec4(t, 0);
  return glm::length(glm::dvec2(d) * q.w - glm::dvec2(q) * d.w) / (2 * q.w * q.w);
}

}  // namespace

std::optional<double> largest_line_error(const Analysis& a) {
  if (!a.map_from_world || !a.near || !a.far) return std::nullopt;
  const Experiment& x = a.experiment;
  const glm::dvec3 eye = x.camera.position, forward = view_forward(x.camera);
  double largest = 0;
  for (int i = 0; i < kDepths; ++i) {
    const double z = *a.near * std::pow(*a.far / *a.near, double(i) / (kDepths - 1));
    const glm::dvec3 p = eye + z * forward, to_light = safe_normalize(glm::dvec3(a.light) - a.light.w * p);
    const glm::dvec3 across = forward - glm::dot(forward, to_light) * to_light;
    if (!(glm::length(across) > 1e-12)) return std::nullopt;
    const double tan_phi = std::tan(a.phi.value_or(phi_towards_light(x)));
    largest = std::max(largest, 1 / (z * tan_phi * map_speed(*a.map_from_world, p, glm::normalize(across))));
  }
  return largest;
}

double logarithmic_line_error(double near, double far, double phi, double theta) {
  return std::abs(std::sin(theta)) * std::log(far / near) / std::tan(phi);
}

}  // namespace psm
