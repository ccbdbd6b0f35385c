// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/filter.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace psm {
namespace {

/// A power of two that brings the normal's largest component into [1, 2), where it is far from that.
double scale_of(const glm::dvec4& p) {
  const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (largest > 0x1p-20 && largest < 0x1p20) return 1.0;
  if (!(largest > 0) || !std::isfinite(largest)) return 1.0;
  return std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1000, 1000));
}

}  // namespace

glm::dvec4 magnitude_of(const Plane& p) {
  const glm::dvec3 n = absolute(p);
  if (!p.edge) return {n, std::abs(p.offset) + glm::dot(n, absolute(p.anchor))};
  const auto& [kept, dropped, light] = *p.edge;
  const glm::dvec4 i = magnitude_of(kept), j = magnitude_of(dropped), l(absolute(light), std::abs(light.w));
  // An error of 16 u in i and j makes at most 43 u here.
  const double nested = kept.edge || dropped.edge ? 3.0 : 1.0;
  return nested * (dot4(i, l) * j + dot4(j, l) * i);
}

FilterPlane filter_plane(const Plane& p) {
  const double scale = scale_of(p);
  FilterPlane f{scale * p, scale * magnitude_of(p)};
  const double largest = std::max({f.magnitude.x, f.magnitude.y, f.magnitude.z, f.magnitude.w});
  if (!(largest < 1e100)) f.magnitude = glm::dvec4(std::numeric_limits<double>::infinity());  // everything is decided exactly
  return f;
}

void SharedParts::annotate(const Plane& plane, FilterPlane& filtered) {
  filtered.generators = plane.edge ? generator_bit(plane.edge->kept) | generator_bit(plane.edge->dropped) : generator_bit(plane);
  filtered.points = points_of(plane);
}

// Past 64 entries: all bits, which never count as few generators; no bit, which is never a common point.
std::uint64_t SharedParts::generator_bit(const Plane& plane) {
  const auto known = std::find_if(generators_.begin(), generators_.end(), [&](auto* g) { return same_definition(*g, plane); });
  const std::size_t index = known - generators_.begin();
  if (index >= 64) return ~std::uint64_t(0);
  if (known == generators_.end()) generators_.push_back(&plane);
  return std::uint64_t(1) << index;
}

std::uint64_t SharedParts::point_bit(const glm::dvec3& point) {
  const std::size_t index = std::find(points_.begin(), points_.end(), point) - points_.begin();
  if (index >= 64) return 0;
  if (index == points_.size()) points_.push_back(point);
  return std::uint64_t(1) << index;
}

std::uint64_t SharedParts::points_of(const Plane& plane) {
  if (!plane.edge) return plane.offset == 0 ? point_bit(plane.anchor) : 0;
  const auto& [kept, dropped, light] = *plane.edge;
  return (points_of(kept) & points_of(dropped)) | (light.w == 1 ? point_bit(glm::dvec3(light)) : 0);
}

bool known_to_meet(const FilterPlane& a, const FilterPlane& b, const FilterPlane& c, const FilterPlane& d) {
  if (a.points & b.points & c.points & d.points) return true;
  return std::popcount(a.generators | b.generators | c.generators | d.generators) <= 3;
}

}  // namespace psm
