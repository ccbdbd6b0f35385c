// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's half-space intersection with inexact constructions. Near-equal planes are merged first (unmerged ones fail most of the
// time), and the interior point is the mean of the double clipper's vertices.
#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "cgal_mesh.h"

namespace psm {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

bool near_equal(const glm::dvec4& p, const glm::dvec4& q, double size) {
  return glm::length(glm::dvec3(p) - glm::dvec3(q)) < 1e-9 && std::abs(p.w - q.w) < 1e-9 * size;
}

/// Unit normals, of near-equal planes the tighter one.
std::vector<glm::dvec4> merged_planes(const CasePlanes& p, double size) {
  std::vector<glm::dvec4> out;
  const auto add = [&](const Plane& plane) {
    const glm::dvec4 unit = glm::dvec4(plane) / glm::length(glm::dvec3(plane));
    for (glm::dvec4& q : out)
      if (near_equal(unit, q, size)) {
        if (unit.w < q.w) q = unit;
        return;
      }
    out.push_back(unit);
  };
  for (const Plane& plane : p.scene.planes) add(plane);
  for (const Plane& plane : p.caster) add(plane);
  return out;
}

}  // namespace

WayBody way_epick_halfspaces(const BodyCase& c) {
  const WayBody guess = way_double_clipper(c);
  if (guess.vertices.empty()) return guess;
  glm::dvec3 mean(0);
  for (const auto& v : guess.vertices) mean += v / double(guess.vertices.size());
  const double size = glm::length(c.max - c.min);
  std::vector<Kernel::Plane_3> planes;
  for (const glm::dvec4& p : merged_planes(planes_of(c), size)) planes.emplace_back(-p.x, -p.y, -p.z, -p.w);
  WayBody out;
  try {
    Polyhedron mesh;
    CGAL::halfspace_intersection_3(planes.begin(), planes.end(), mesh,
                                   boost::make_optional(Kernel::Point_3(mean.x, mean.y, mean.z)));
    const double near = 1e-9 * size;
    out = body_of(mesh, [&](auto& a, auto& b) { return CGAL::squared_distance(a, b) <= near * near; });
  } catch (const std::exception&) {
    out.failed = true;
  }
  return out;
}

}  // namespace psm
