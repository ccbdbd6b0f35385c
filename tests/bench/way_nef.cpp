// SPDX-License-Identifier: GPL-3.0-or-later
// The way of the 2002 paper: convex hulls of points, intersected as Nef polyhedra. V's corners are rounded to doubles; a
// directional light and an endless pyramid reach far past the scene.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include "cgal_mesh.h"

namespace psm {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Point = Kernel::Point_3;

Point point(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

Nef hull(const std::vector<glm::dvec3>& corners) {
  std::vector<Point> points;
  for (const auto& p : corners) points.push_back(point(p));
  Polyhedron mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), mesh);
  return Nef(mesh);
}

double reach_of(const BodyCase& c) {
  return 4 * (glm::length(c.max - c.min) + glm::length(c.view.eye - c.min) +
              (c.light.w == 1 ? glm::length(glm::dvec3(c.light) - c.min) : 0));
}

void add_rectangle(std::vector<glm::dvec3>& out, const ViewFrame& v, double depth) {
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) out.push_back(v.at(x, y, depth));
}

Nef caster_hull(const BodyCase& c) {
  std::vector<glm::dvec3> corners;
  add_rectangle(corners, c.view, c.near);
  add_rectangle(corners, c.view, std::isinf(c.far) ? reach_of(c) : c.far);
  if (c.light.w == 1) {
    corners.push_back(glm::dvec3(c.light));
  } else {
    const glm::dvec3 shift = (reach_of(c) + (std::isinf(c.far) ? 0 : 4 * c.far)) * glm::normalize(glm::dvec3(c.light));
    for (int i = 0; i < 8; ++i) corners.push_back(corners[i] + shift);
  }
  return hull(corners);
}

void intersect_scene(Nef& body, const BodyCase& c) {
  if (glm::all(glm::lessThan(c.min, c.max))) {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.push_back({i & 1 ? c.max.x : c.min.x, i & 2 ? c.max.y : c.min.y, i & 4 ? c.max.z : c.min.z});
    body *= hull(corners);
    return;
  }
  for (int a = 0; a < 3; ++a)  // a flat box has no solid hull
    for (const double side : {-1.0, 1.0}) {
      glm::dvec3 n(0);
      n[a] = side;
      body = body.intersection(Kernel::Plane_3(n.x, n.y, n.z, side < 0 ? c.min[a] : -c.max[a]), Nef::CLOSED_HALFSPACE);
    }
}

/// Each facet once: it has two sides.
void read_facets(const Nef& body, WayBody& out) {
  std::map<Point, int> number;
  for (auto v = body.vertices_begin(); v != body.vertices_end(); ++v) {
    number[v->point()] = int(out.vertices.size());
    out.vertices.push_back({CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()), CGAL::to_double(v->point().z())});
  }
  for (auto f = body.halffacets_begin(); f != body.halffacets_end(); ++f) {
    if (f->is_twin()) continue;
    std::vector<int> loop;
    const typename Nef::SHalfedge_const_handle start(f->facet_cycles_begin());
    auto at = start;
    do loop.push_back(number.at(at->source()->center_vertex()->point()));
    while ((at = at->next()) != start);
    out.facet_sizes.push_back(int(loop.size()));
    out.volume += std::abs(fan_volume(out.vertices, loop));  // each tetrahedron has vertex 0 as its apex
  }
}

}  // namespace

WayBody way_nef(const BodyCase& c) {
  WayBody out;
  try {
    Nef body = caster_hull(c);
    intersect_scene(body, c);
    if (c.spot) {
      std::vector<glm::dvec3> pyramid{c.spot->eye};
      add_rectangle(pyramid, *c.spot, reach_of(c));
      body *= hull(pyramid);
    }
    read_facets(body, out);
  } catch (const std::exception&) {
    out = {};
    out.failed = true;
  }
  return out;
}

}  // namespace psm
