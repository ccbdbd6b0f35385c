// SPDX-License-Identifier: GPL-3.0-or-later
// Convex bodies around any choice among some sets of points (a scene's meshes). What is costly is done once; a body for a choice
// is a handful of planes.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geom/convex_body.h"

namespace psm {

/// The planes are those of the box of the chosen sets, and one for each normal, through the chosen points' farthest one. The
/// normals are facet normals of the hull of all sets (its 256 largest facets): greedily those that cut the most off the volume
/// left, until none cuts a hundredth or `most` are there. So where the hull of all sets has few facets the body around all of
/// them is that hull; else it is larger, by `excess`. It never misses a point: normals are rounded, then each plane lies on a
/// point exactly.
struct PointHulls {
  struct Set {
    glm::dvec3 min{0.0}, max{0.0};
    std::vector<glm::dvec3> farthest;  // along each normal
    bool empty() const { return min.x > max.x; }
  };
  std::vector<glm::dvec3> normals;  // outward
  double excess = 0;                // of the body around all sets, as a fraction of the hull's volume
  std::vector<Set> sets;            // those without a point stay at index, with min > max
};

/// At most this many planes besides the box's: each adds about a microsecond to every body.
constexpr std::size_t kHullPlanes = 12;

PointHulls point_hulls(std::span<const std::span<const glm::dvec3>> sets, std::size_t most = kHullPlanes);

/// The body around the chosen sets, by their index. No point chosen: empty.
ConvexBody hull_body(const PointHulls& hulls, std::span<const int> chosen);

}  // namespace psm
