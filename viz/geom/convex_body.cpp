// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/convex_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/simple_polytope.h"

namespace psm {
namespace {

/// Sums weight(triangle) and weight * centroid over the facets' fans.
template <class Weight>
std::pair<double, glm::dvec3> weighted_centroid(const ConvexBody& body, double corners, Weight weight) {
  const glm::dvec3 o = body.vertices[0];
  double total = 0;
  glm::dvec3 sum(0);
  for (const auto& f : body.facets)
    for (std::size_t i = 1; i + 1 < f.size(); ++i) {
      const glm::dvec3 a = body.vertices[f[0]] - o, b = body.vertices[f[i]] - o, c = body.vertices[f[i + 1]] - o;
      const double w = weight(a, b, c);
      total += w;
      sum += w * (a + b + c) / corners;
    }
  return {total, total > 0 ? o + sum / total : o};
}

double six_tetrahedra(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) { return glm::dot(a, glm::cross(b, c)); }
double two_areas(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) { return glm::length(glm::cross(b - a, c - a)); }

/// Corner i of a box: bit 0, 1, 2 choose the side in x, y, z, whose planes are 2 * axis and 2 * axis + 1.
ConvexBody::Corner box_corner(int i) {
  const int sides[3] = {i & 1, (i >> 1) & 1, (i >> 2) & 1};
  ConvexBody::Corner c;
  const bool mirrored = (sides[0] + sides[1] + sides[2]) % 2 == 1;
  const int axes[3] = {0, mirrored ? 2 : 1, mirrored ? 1 : 2};
  for (int k = 0; k < 3; ++k) {
    c.plane[k] = 2 * axes[k] + sides[axes[k]];
    c.next[k] = i ^ (1 << axes[k]);
  }
  return c;
}

}  // namespace

double ConvexBody::volume() const {
  return dimension < 3 ? 0.0 : std::max(0.0, weighted_centroid(*this, 4.0, six_tetrahedra).first / 6.0);
}

glm::dvec3 ConvexBody::centroid() const {
  assert(!empty());
  if (dimension >= 2) {
    const auto [weight, centre] =
        dimension == 3 ? weighted_centroid(*this, 4.0, six_tetrahedra) : weighted_centroid(*this, 3.0, two_areas);
    if (weight > 0) return centre;  // else too thin for its rounded coordinates
  }
  glm::dvec3 sum(0);
  for (const auto& v : vertices) sum += v - vertices[0];
  return vertices[0] + sum / double(vertices.size());
}

ConvexBody box_body(const glm::dvec3& min, const glm::dvec3& max) {
  if (!(min.x <= max.x && min.y <= max.y && min.z <= max.z)) return {};
  const Plane planes[6] = {{1, 0, 0, -min.x, PlaneId::min_x}, {-1, 0, 0, max.x, PlaneId::max_x},
                           {0, 1, 0, -min.y, PlaneId::min_y}, {0, -1, 0, max.y, PlaneId::max_y},
                           {0, 0, 1, -min.z, PlaneId::min_z}, {0, 0, -1, max.z, PlaneId::max_z}};
  ConvexBody::Corner corners[8];
  for (int i = 0; i < 8; ++i) corners[i] = box_corner(i);
  if (!(min.x < max.x && min.y < max.y && min.z < max.z)) return SimplePolytope(planes, corners).to_body();
  ConvexBody box;
  box.dimension = 3;
  box.planes.assign(planes, planes + 6);
  box.corners.assign(corners, corners + 8);
  box.vertices.reserve(8);
  for (int i = 0; i < 8; ++i) box.vertices.push_back({i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z});
  box.facets = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return box;
}

ConvexBody clip(const ConvexBody& body, std::span<const Plane> planes) {
  if (planes.empty()) {
    ConvexBody same = body;
    same.decisions = {};
    return same;
  }
  SimplePolytope polytope(body.planes, body.corners);
  for (const Plane& p : planes) polytope.cut(p);
  return polytope.to_body();
}

bool misses(const ConvexBody& body, const glm::dvec3& min, const glm::dvec3& max) {
  return std::any_of(body.planes.begin(), body.planes.end(), [&](const Plane& p) {
    const glm::dvec3 farthest = glm::mix(min, max, glm::greaterThan(glm::dvec3(p), glm::dvec3(0.0)));
    const glm::dvec4 terms = p * glm::dvec4(farthest, 1.0);
    const double rounding =
        8 * 2.220446049250313e-16 * (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w));
    return terms.x + terms.y + terms.z + terms.w < -rounding;
  });
}

}  // namespace psm
