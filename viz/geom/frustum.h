// SPDX-License-Identifier: GPL-3.0-or-later
// The planes of a camera's frustum and of a spot light's pyramid. Both pass through the eye (or the light).
#pragma once

#include <cmath>
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

/// Side planes, then depth >= near, then depth <= far unless far is infinite. Inside: p.x >= 0.
inline std::vector<Plane> frustum_planes(const ViewFrame& v, double near, double far) {
  const auto through = [](const glm::dvec3& n, const glm::dvec3& p) { return Plane(n, -glm::dot(n, p)); };
  std::vector<Plane> planes;
  for (const double sign : {1.0, -1.0}) planes.push_back(through(v.tan_x * v.forward + sign * v.right, v.eye));
  for (const double sign : {1.0, -1.0}) planes.push_back(through(v.tan_y * v.forward + sign * v.up, v.eye));
  planes.push_back(through(v.forward, v.eye + near * v.forward));
  if (!std::isinf(far)) planes.push_back(through(-v.forward, v.eye + far * v.forward));
  return planes;
}

/// The half-spaces of hull(V + light) for the whole frustum V, in the plane form of convex_body.h. An infinite far face is the
/// plane at infinity, on which no direction and every position is inside.
inline std::vector<Plane> frustum_hull_with_light(const ViewFrame& v, double near, double far, const glm::dvec4& light) {
  std::vector<Plane> sides = frustum_planes(v, near, far);
  if (std::isinf(far)) sides.push_back(Plane(0, 0, 0, 1));
  std::vector<Plane> hull;
  for (std::size_t i = 0; i < 6; ++i) {
    const double at_i = glm::dot(sides[i], light);
    if (at_i >= 0) hull.push_back(sides[i]);
    for (std::size_t j = 0; j < 6; ++j) {
      if (i / 2 == j / 2) continue;  // opposite sides share no edge
      const double at_j = glm::dot(sides[j], light);
      if (at_i >= 0 && at_j < 0) hull.push_back(at_i * sides[j] - at_j * sides[i]);
    }
  }
  return hull;
}

}  // namespace psm
