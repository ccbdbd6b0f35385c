// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's half-space intersection with exact constructions and exact planes. The interior point is the mean of the double
// clipper's vertices where that is inside, else CGAL's own; where there is none, the body counts as empty.
#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "cgal_mesh.h"

namespace psm {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Number = Kernel::FT;
using Four = std::array<Number, 4>;

Number at(const Four& p, const glm::dvec4& x) { return p[0] * x.x + p[1] * x.y + p[2] * x.z + p[3] * x.w; }

Four exact(const Plane& p) {
  if (p.edge) {
    const Four i = exact(p.edge->kept), j = exact(p.edge->dropped);
    const Number a = at(i, p.edge->light), b = at(j, p.edge->light);
    return {a * j[0] - b * i[0], a * j[1] - b * i[1], a * j[2] - b * i[2], a * j[3] - b * i[3]};
  }
  const Number x = p.x, y = p.y, z = p.z;
  return {x, y, z, Number(p.offset) - (x * p.anchor.x + y * p.anchor.y + z * p.anchor.z)};
}

void add_plane(std::vector<Kernel::Plane_3>& planes, const Plane& p) {
  const Four e = exact(p);
  const Kernel::Plane_3 plane(-e[0], -e[1], -e[2], -e[3]);
  if (std::find(planes.begin(), planes.end(), plane) == planes.end()) planes.push_back(plane);
}

boost::optional<Kernel::Point_3> inner_point(const BodyCase& c, const std::vector<Kernel::Plane_3>& planes) {
  const WayBody guess = way_double_clipper(c);
  glm::dvec3 mean(0);
  for (const auto& v : guess.vertices) mean += v / double(guess.vertices.size());
  const Kernel::Point_3 point(mean.x, mean.y, mean.z);
  const auto inside = [&](const Kernel::Plane_3& p) { return p.has_on_negative_side(point); };
  if (std::all_of(planes.begin(), planes.end(), inside)) return point;
  return CGAL::halfspace_intersection_interior_point_3(planes.begin(), planes.end());
}

}  // namespace

WayBody way_epeck_halfspaces(const BodyCase& c) {
  WayBody out;
  try {
    const CasePlanes p = planes_of(c);
    std::vector<Kernel::Plane_3> planes;
    for (const Plane& plane : p.scene.planes) add_plane(planes, plane);
    for (const Plane& plane : p.caster) add_plane(planes, plane);
    const auto point = inner_point(c, planes);
    if (!point) return out;
    Polyhedron mesh;
    CGAL::halfspace_intersection_3(planes.begin(), planes.end(), mesh, point);
    out = body_of(mesh, [](auto& a, auto& b) { return a == b; });
  } catch (const std::exception&) {
    out.failed = true;
  }
  return out;
}

}  // namespace psm
