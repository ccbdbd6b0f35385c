// SPDX-License-Identifier: GPL-3.0-or-later
// The planes of a camera's frustum and of a spot light's pyramid. Both pass through the eye (or the light).
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geom/convex_body.h"
#include "math/projective.h"

namespace psm {

/// An eye with an orthonormal frame and the tangents of its half angles; depth runs along `forward`.
struct ViewFrame {
  glm::dvec3 eye{0}, forward{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};
  double tan_x = 1, tan_y = 1;

  double depth(const glm::dvec3& p) const { return glm::dot(forward, p - eye); }
  glm::dmat4 view_from_world() const { return look_along(eye, forward, up); }
  /// The point at signed lateral fractions (-1 to 1) and a depth.
  glm::dvec3 at(double x, double y, double z) const { return eye + z * (forward + x * tan_x * right + y * tan_y * up); }
};

inline ViewFrame view_frame(const glm::dvec3& eye, const glm::dvec3& forward, const glm::dvec3& up, double tan_x, double tan_y) {
  const glm::dmat4 view = look_along(eye, forward, up);
  return {eye, -glm::dvec3(row(view, 2)), glm::dvec3(row(view, 0)), glm::dvec3(row(view, 1)), tan_x, tan_y};
}

/// Side planes (left, right, bottom, top), then depth >= near, then depth <= far unless far is infinite. Inside: p.x >= 0.
/// Normals are rounded once; side planes pass through the eye exactly, the others lie at their distance from it exactly.
inline std::vector<Plane> frustum_planes(const ViewFrame& v, double near, double far) {
  const glm::dvec3 x = v.tan_x * v.forward, y = v.tan_y * v.forward;
  const std::pair<glm::dvec3, PlaneId> sides[] = {
      {x + v.right, PlaneId::left}, {x - v.right, PlaneId::right}, {y + v.up, PlaneId::bottom}, {y - v.up, PlaneId::top}};
  std::vector<Plane> planes;
  planes.reserve(6);
  for (const auto& [normal, id] : sides) planes.push_back(Plane::through(normal, v.eye, 0.0, id));
  planes.push_back(Plane::through(v.forward, v.eye, -near, PlaneId::near));
  if (!std::isinf(far)) planes.push_back(Plane::through(-v.forward, v.eye, far, PlaneId::far));
  return planes;
}

/// The square pyramid around a spot light's cone, from depth `near` on (0: the whole pyramid, its apex the light exactly).
inline std::vector<Plane> pyramid_planes(const ViewFrame& spot, double near = 0.0) {
  std::vector<Plane> planes = frustum_planes(spot, near, std::numeric_limits<double>::infinity());
  for (Plane& p : planes) p.of_light = true;
  return planes;
}

/// hull_with_light for a frustum as `frustum_planes` returns it, which may be unbounded (five planes).
std::vector<Plane> frustum_hull_with_light(std::span<const Plane> frustum, const glm::dvec4& light);
inline std::vector<Plane> frustum_hull_with_light(const ViewFrame& v, double near, double far, const glm::dvec4& light) {
  return frustum_hull_with_light(frustum_planes(v, near, far), light);
}

}  // namespace psm
