// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest cone around a set of directions.
#pragma once

#include <span>
#include <vector>

#include "math/projective.h"

namespace psm {

/// Axis (unit) and cosine of the half angle. cosine <= 0: the directions fit in no half-space, and the axis means nothing.
template <class T>
struct Cone {
  Vec3<T> axis{0};
  T cosine = T(-1);
};

namespace detail {

/// The smallest cap through all of two or three unit directions, as its axis; zero where there is none.
template <class T>
Vec3<T> cap_axis(const Vec3<T>& a, const Vec3<T>& b) {
  return safe_normalize(a + b);
}
template <class T>
Vec3<T> cap_axis(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const Vec3<T> n = safe_normalize(glm::cross(b - a, c - a));
  return glm::dot(n, a) < T(0) ? -n : n;
}

}  // namespace detail

/// Smallest enclosing cone of unit directions, by the incremental construction of smallest enclosing circles (on the sphere):
/// each direction outside the cone so far lies on the boundary of the next.
template <class T>
Cone<T> smallest_enclosing_cone(std::span<const Vec3<T>> d) {
  if (d.empty()) return {};
  const T slack = T(8) * epsilon<T>();
  Vec3<T> g = d[0];
  T cosine = T(1);
  const auto outside = [&](const Vec3<T>& x) { return glm::dot(g, x) < cosine - slack; };
  const auto set = [&](const Vec3<T>& axis, const Vec3<T>& on_boundary) {
    g = axis;
    cosine = glm::dot(axis, on_boundary);
  };
  for (std::size_t i = 1; i < d.size(); ++i) {
    if (!outside(d[i])) continue;
    set(d[i], d[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (!outside(d[j])) continue;
      set(detail::cap_axis(d[i], d[j]), d[i]);
      for (std::size_t k = 0; k < j; ++k)
        if (outside(d[k])) set(detail::cap_axis(d[i], d[j], d[k]), d[i]);
    }
  }
  Cone<T> cone{g, T(1)};
  for (const Vec3<T>& x : d) cone.cosine = std::min(cone.cosine, glm::dot(g, x));
  return cone;
}

}  // namespace psm
