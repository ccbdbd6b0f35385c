// SPDX-License-Identifier: GPL-3.0-or-later
// The intersection of half-spaces by trying all triples of planes in exact arithmetic: slow, and nothing to get wrong.
#pragma once

#include <glm/glm.hpp>
#include <set>
#include <span>
#include <vector>

#include "geom/convex_body.h"

namespace psm {

struct OracleBody {
  int dimension = -1;
  std::vector<glm::dvec3> vertices;
  /// For each input plane the facet that lies on it, named by the first plane that holds the same vertices; -1: none.
  std::vector<int> facet_of_plane;
  /// For each vertex the facets it lies on, as named above.
  std::multiset<std::set<int>> vertex_facets;
};

/// The half-spaces' intersection must be bounded.
OracleBody exact_intersection(std::span<const Plane> planes);

/// The volume from the exact planes and the body's topology, rounded once.
double exact_volume(const ConvexBody& body);

}  // namespace psm
