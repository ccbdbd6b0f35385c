// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>

namespace psm {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Mesh = CGAL::Surface_mesh<Point>;

glm::dvec3 at(const Point& p) { return {p.x(), p.y(), p.z()}; }

HullFacet facet(const Point& a, const Point& b, const Point& c) { return {glm::cross(at(b) - at(a), at(c) - at(a)), at(a)}; }

HullFacets of_plane(const HullFacet& f) { return {{f, {-f.normal, f.corner}}, 0}; }

/// Largest triangle first, so that each plane is named by the triangle that knows it best.
std::vector<HullFacet> distinct(std::vector<HullFacet> triangles, std::size_t most) {
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const auto& a, const auto& b) { return glm::dot(a.normal, a.normal) > glm::dot(b.normal, b.normal); });
  std::vector<HullFacet> out;
  std::vector<glm::dvec3> units;
  for (const HullFacet& t : triangles) {
    const double length = glm::length(t.normal);
    if (!(length > 0) || out.size() == most) break;
    const glm::dvec3 unit = t.normal / length;
    const auto same = [&](const glm::dvec3& u) { return glm::length(u - unit) < 1e-9; };
    if (std::any_of(units.begin(), units.end(), same)) continue;
    units.push_back(unit);
    out.push_back(t);
  }
  return out;
}

}  // namespace

HullFacets hull_facets(std::span<const glm::dvec3> points, std::size_t most) {
  std::vector<Point> in;
  in.reserve(points.size());
  for (const glm::dvec3& p : points) in.emplace_back(p.x, p.y, p.z);
  CGAL::Object hull;
  CGAL::convex_hull_3(in.begin(), in.end(), hull, CGAL::Convex_hull_traits_3<Kernel, Mesh>());
  if (const Triangle* t = CGAL::object_cast<Triangle>(&hull)) return of_plane(facet((*t)[0], (*t)[1], (*t)[2]));
  const Mesh* mesh = CGAL::object_cast<Mesh>(&hull);
  if (!mesh) return {};
  HullFacets out;
  for (const Mesh::Face_index f : mesh->faces()) {
    const auto h = mesh->halfedge(f);
    out.facets.push_back(
        facet(mesh->point(mesh->source(h)), mesh->point(mesh->target(h)), mesh->point(mesh->target(mesh->next(h)))));
    out.volume += glm::dot(out.facets.back().corner - points[0], out.facets.back().normal) / 6;
  }
  out.facets = distinct(std::move(out.facets), most);
  return out.facets.size() == 1 ? of_plane(out.facets[0]) : out;
}

}  // namespace psm
