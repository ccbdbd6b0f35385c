// SPDX-License-Identifier: GPL-3.0-or-later
// Closed convex bodies as intersections of half-spaces, and the caster body hull(B + l) in plane form.
#pragma once

#include <array>
#include <cassert>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace psm {

/// A half-space p.x >= 0 with x = (x, y, z, 1); p.xyz is the inward normal, of any length.
using Plane = glm::dvec4;

/// A bounded convex polytope. Facet i lies on planes[i]; its corners are counter-clockwise seen from outside. Flat bodies keep
/// zero-area facets, so that the topology stays that of a polytope. Empty: no vertices.
struct ConvexBody {
  std::vector<Plane> planes;
  std::vector<glm::dvec3> vertices;
  std::vector<std::vector<int>> facets;

  bool empty() const { return vertices.empty(); }
  double volume() const;
  glm::dvec3 centroid() const;  // of the volume; of the surface or the vertices where the body is flat; asserts !empty()
};

/// The box as a body: six facets, eight vertices. A flat box is a flat body.
ConvexBody box_body(const glm::dvec3& min, const glm::dvec3& max);

/// body ∩ { p.x >= 0 for all p }.
ConvexBody clip(ConvexBody body, std::span<const Plane> planes);

/// The half-spaces of hull(body + light) for a homogeneous light (w = 1 or 0): the planes with p.l >= 0, and for each edge
/// between a kept p_i and a dropped p_j the plane (p_i.l) p_j - (p_j.l) p_i. The body must not contain the light.
std::vector<Plane> hull_with_light(const ConvexBody& body, const glm::dvec4& light);

}  // namespace psm
