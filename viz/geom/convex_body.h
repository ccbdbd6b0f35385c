// SPDX-License-Identifier: GPL-3.0-or-later
// Closed convex bodies as intersections of half-spaces, and the caster body hull(B + l) in plane form. Topology is exact: it is
// that of the exact planes, and coordinates are rounded last, once.
#pragma once

#include <array>
#include <cassert>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geom/plane.h"

namespace psm {

/// How the signs that made a body were decided: by doubles with an error bound, by what the planes are known to share (a point,
/// an edge), or in exact arithmetic.
struct Decisions {
  int filtered = 0, shared = 0, exact = 0;
};

/// A bounded convex polytope of dimension 3, 2 (flat: two opposite facets), 1 (a segment: no facet), 0 (a point) or -1 (empty: no
/// vertex). It is the intersection of `planes`. Facet i lies on planes[i]; its corners are counter-clockwise seen from outside.
/// Planes past the last facet's touch the body in an edge or a point; a body of dimension 0 to 2 is bounded by them.
struct ConvexBody {
  std::vector<Plane> planes;
  std::vector<glm::dvec3> vertices;
  std::vector<std::vector<int>> facets;
  int dimension = -1;
  Decisions decisions;  // of the operation that returned this body

  /// What further cuts start from: the same polytope with every plane moved outwards by its own infinitesimal: three planes meet
  /// in each corner, and next[k] is the corner at the other end of the edge that leaves plane[k]. Normals are positively oriented
  /// in the order of `plane`.
  struct Corner {
    std::array<int, 3> plane, next;
  };
  std::vector<Corner> corners;

  bool empty() const { return vertices.empty(); }
  double volume() const;        // 0 unless the dimension is 3
  glm::dvec3 centroid() const;  // of the volume, the area, the segment or the point; asserts !empty()
};

/// The box as a body. A flat box is a flat body; min > max in any coordinate is empty.
ConvexBody box_body(const glm::dvec3& min, const glm::dvec3& max);

/// body ∩ { p.x >= 0 for all p }. The body must come from one of these functions.
ConvexBody clip(const ConvexBody& body, std::span<const Plane> planes);

/// Whether the box lies wholly outside one of the body's planes: then the two do not meet. (The reverse may fail.)
bool misses(const ConvexBody& body, const glm::dvec3& min, const glm::dvec3& max);

/// The half-spaces of hull(body + light) for a homogeneous light (w = 1 or 0): the planes with p.l >= 0, and for each edge
/// between a kept p_i and a dropped p_j the plane (p_i.l) p_j - (p_j.l) p_i. Exact for flat bodies too (Fourier-Motzkin: every
/// pair of planes stands in for the edges). A body that contains the light is its own hull.
std::vector<Plane> hull_with_light(const ConvexBody& body, const glm::dvec4& light);

}  // namespace psm
