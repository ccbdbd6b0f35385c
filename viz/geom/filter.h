// SPDX-License-Identifier: GPL-3.0-or-later
// The first stage of every decision: planes and corners in doubles with bounds on their errors. Private to viz/geom.
//
// u is 2^-53. A plane's coefficients carry an absolute error of at most 16 u times `magnitude`: 4 u for n.(x - anchor) + offset;
// (p_i.l) p_j - (p_j.l) p_i adds 8 u for each p.l and 3 u for products and difference. A corner's coordinates are 3x3 minors:
// 3 * 16 u from the planes and 5 u of their own, times the same minors with all signs positive. A side is the sum of
// four products: 16 u + 53 u + 4 u times the sum of magnitudes; 96 u leaves room for higher orders and the bound's own rounding.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "geom/inline_vector.h"
#include "geom/plane.h"

namespace psm {

constexpr double kRoundingUnit = 1.1102230246251565e-16;

/// Scaled by a power of two where products might overflow or sink below the constant in `side_bound`.
struct FilterPlane {
  glm::dvec4 value{0.0}, magnitude{0.0};
  std::uint64_t generators = 0;  // the one or two planes that span this one, as bits
  std::uint64_t points = 0;      // the known points through which it passes exactly, as bits
};

/// The corner x of three planes a, b, c, homogeneous: x.q is the determinant of a, b, c, q, and x.w > 0.
struct FilterCorner {
  glm::dvec4 value{0.0}, magnitude{0.0};
};

/// Without the branches of glm::abs, which cost more than all else here where signs are random.
inline glm::dvec3 absolute(const glm::dvec3& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

glm::dvec4 magnitude_of(const Plane& p);
FilterPlane filter_plane(const Plane& p);

/// 2x2 minors of rows a, b; with `sign` 1 the same with all signs positive.
struct Minors2 {
  double xy, xz, xw, yz, yw, zw;
};
inline Minors2 minors(const glm::dvec4& a, const glm::dvec4& b, double sign) {
  return {a.x * b.y + sign * (a.y * b.x), a.x * b.z + sign * (a.z * b.x), a.x * b.w + sign * (a.w * b.x),
          a.y * b.z + sign * (a.z * b.y), a.y * b.w + sign * (a.w * b.y), a.z * b.w + sign * (a.w * b.z)};
}

inline FilterCorner filter_corner(const FilterPlane& a, const FilterPlane& b, const FilterPlane& c) {
  const Minors2 m = minors(a.value, b.value, -1.0);
  const glm::dvec4& v = c.value;
  FilterCorner out;
  out.value = {(v.z * m.yw - v.y * m.zw) - v.w * m.yz, (v.x * m.zw - v.z * m.xw) + v.w * m.xz,
               (v.y * m.xw - v.x * m.yw) - v.w * m.xy, (v.x * m.yz - v.y * m.xz) + v.z * m.xy};
  const Minors2 p = minors(a.magnitude, b.magnitude, 1.0);
  const glm::dvec4& w = c.magnitude;
  out.magnitude = {(w.z * p.yw + w.y * p.zw) + w.w * p.yz, (w.x * p.zw + w.z * p.xw) + w.w * p.xz,
                   (w.y * p.xw + w.x * p.yw) + w.w * p.xy, (w.x * p.yz + w.y * p.xz) + w.z * p.xy};
  return out;
}

inline double dot4(const glm::dvec4& a, const glm::dvec4& b) { return (a.x * b.x + a.y * b.y) + (a.z * b.z + a.w * b.w); }
inline double side_bound(const FilterPlane& p, const FilterCorner& c) {
  return 96 * kRoundingUnit * dot4(p.magnitude, c.magnitude) + 1e-200;
}

/// Knows which planes share an edge or a point by construction, so that the exact stage need not find it out again.
class SharedParts {
 public:
  /// Fills in `generators` and `points`.
  void annotate(const Plane& plane, FilterPlane& filtered);

 private:
  std::uint64_t generator_bit(const Plane& plane);
  std::uint64_t point_bit(const glm::dvec3& point);
  std::uint64_t points_of(const Plane& plane);

  InlineVector<const Plane*, 64> generators_;
  InlineVector<glm::dvec3, 16> points_;
};

/// True if four planes are known to meet in one point: all pass through one known point, or at most three planes span them.
bool known_to_meet(const FilterPlane& a, const FilterPlane& b, const FilterPlane& c, const FilterPlane& d);

}  // namespace psm
