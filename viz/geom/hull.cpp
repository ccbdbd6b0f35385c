// SPDX-License-Identifier: GPL-3.0-or-later
// hull(B + l) in plane form (DESIGN.md, "The one idea").
#include <cassert>

#include "geom/convex_body.h"
#include "geom/exact.h"
#include "geom/frustum.h"
#include "geom/inline_vector.h"

namespace psm {
namespace {

using Sides = InlineVector<int, 64>;

void add_sides(Sides& sides, std::span<const Plane> planes, const glm::dvec4& light) {
  for (const Plane& p : planes) sides.push_back(exact_side(p, light));
}

std::vector<Plane> kept_planes(std::span<const Plane> planes, const Sides& sides) {
  std::vector<Plane> hull;
  hull.reserve(2 * planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (sides[i] >= 0) hull.push_back(planes[i]);
  return hull;
}

/// A kept plane through the light makes no new plane: its combination with a dropped one is itself.
bool makes_silhouette(int i, int j) { return i > 0 && j < 0; }

/// Elimination of t from p_k.(x - t l) >= 0, t >= 0: every pair of a kept and a dropped plane. For a position x - t l must stay a
/// point, which is the plane at infinity's row.
std::vector<Plane> hull_of_flat(const ConvexBody& body, const glm::dvec4& light) {
  std::vector<Plane> planes = body.planes;
  if (light.w > 0) planes.emplace_back(0.0, 0.0, 0.0, 1.0, PlaneId::infinity);
  Sides sides;
  add_sides(sides, planes, light);
  std::vector<Plane> hull = kept_planes({planes.data(), body.planes.size()}, sides);
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = 0; j < planes.size(); ++j) {
      if (!makes_silhouette(sides[i], sides[j])) continue;
      Plane s = Plane::silhouette(planes[i], planes[j], light);
      if (!exactly_without_normal(s)) hull.push_back(std::move(s));
    }
  return hull;
}

}  // namespace

std::vector<Plane> hull_with_light(const ConvexBody& body, const glm::dvec4& light) {
  assert(light.w == 0 || light.w == 1);
  if (body.dimension < 3) return hull_of_flat(body, light);
  const std::span<const Plane> planes(body.planes.data(), body.facets.size());
  Sides sides;
  add_sides(sides, planes, light);
  std::vector<Plane> hull = kept_planes(planes, sides);
  // The facet to the left of each directed edge, as a square table; -1: no such edge.
  const std::size_t n = body.vertices.size();
  InlineVector<int, 576> facet(n * n, -1);
  for (std::size_t i = 0; i < body.facets.size(); ++i) {
    const std::vector<int>& f = body.facets[i];
    for (std::size_t k = 0; k < f.size(); ++k) facet[f[k] * n + f[k + 1 < f.size() ? k + 1 : 0]] = int(i);
  }
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      const int i = facet[a * n + b], j = facet[b * n + a];
      if (i >= 0 && makes_silhouette(sides[i], sides[j])) hull.push_back(Plane::silhouette(planes[i], planes[j], light));
    }
  return hull;
}

std::vector<Plane> frustum_hull_with_light(std::span<const Plane> frustum, const glm::dvec4& light) {
  assert(frustum.size() == 5 || frustum.size() == 6);
  std::vector<Plane> planes(frustum.begin(), frustum.end());
  if (planes.size() == 5) planes.emplace_back(0.0, 0.0, 0.0, 1.0, PlaneId::infinity);
  Sides sides;
  add_sides(sides, planes, light);
  std::vector<Plane> hull = kept_planes(frustum, sides);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      if (i / 2 != j / 2 && makes_silhouette(sides[i], sides[j])) hull.push_back(Plane::silhouette(planes[i], planes[j], light));
  return hull;
}

}  // namespace psm
