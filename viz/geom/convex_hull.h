// SPDX-License-Identifier: GPL-3.0-or-later
// The facets of a convex hull, as suggestions for planes around its points. Private to viz/geom (CGAL).
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace psm {

/// A facet's outward normal as the cross product of two of its edges, of any length and rounded once, and one of its corners.
struct HullFacet {
  glm::dvec3 normal{0.0}, corner{0.0};
};

/// The largest facets, at most `most`, coplanar triangles counted once. Points in one plane have two facets; fewer dimensions
/// have none.
struct HullFacets {
  std::vector<HullFacet> facets;
  double volume = 0;  // of the whole hull
};

HullFacets hull_facets(std::span<const glm::dvec3> points, std::size_t most);

}  // namespace psm
