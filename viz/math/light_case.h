// SPDX-License-Identifier: GPL-3.0-or-later
// What the eye's projection makes of a light (PSM 2002, sections 3.1 and 3.2), with one rule for directions and positions.
#pragma once

#include "math/projective.h"

namespace psm {

/// The light as a homogeneous point: (position, 1), or (direction to the light, 0).
template <class T>
struct PostLightCase {
  T w = T(0);             // v.(l - e) or v.l: the clip w of the light
  int sign = 0;           // of w: 0 directional, 1 point, -1 inverted point, after the projection
  bool reversed = false;  // depth order along rays in post-perspective space, if l is divided by a negative w
};

/// w counts as 0 within four roundings of the vector it was formed from.
template <class T>
PostLightCase<T> classify_light(const Vec4<T>& light, const Vec3<T>& eye, const Vec3<T>& view_forward) {
  const Vec3<T> from_eye = Vec3<T>(light) - light.w * eye;
  PostLightCase<T> c;
  c.w = glm::dot(view_forward, from_eye);
  const T largest = std::max(abs(from_eye.x), std::max(abs(from_eye.y), abs(from_eye.z)));
  const T length = largest > T(0) ? largest * glm::length(from_eye / largest) : T(0);
  const T limit = T(4) * epsilon<T>() * length;
  c.sign = c.w > limit ? 1 : c.w < -limit ? -1 : 0;
  c.reversed = c.sign < 0;
  return c;
}

}  // namespace psm
