// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to compute H = hull(V + l) ∩ S ∩ L, for comparison with viz/geom.
#pragma once

#include <vector>

#include "../geom/body_cases.h"

namespace psm {

/// What a way returns: enough to compare topology and coordinates. A flat body has one facet.
struct WayBody {
  bool failed = false;  // threw, or found no way to begin
  std::vector<glm::dvec3> vertices;
  std::vector<int> facet_sizes;
  double volume = 0;
};

using Way = WayBody (*)(const BodyCase&);

WayBody way_exact(const BodyCase& c);             // viz/geom
WayBody way_double_clipper(const BodyCase& c);    // doubles and a tolerance
WayBody way_epick_halfspaces(const BodyCase& c);  // CGAL half-space intersection, EPICK, near-equal planes merged
WayBody way_epeck_halfspaces(const BodyCase& c);  // the same in exact constructions, planes exact
WayBody way_nef(const BodyCase& c);               // CGAL Nef polyhedra of convex hulls (EPECK), as in the 2002 paper

}  // namespace psm
