// SPDX-License-Identifier: GPL-3.0-or-later
// From CGAL's polyhedra to what the comparison looks at: repeated vertices are welded, facets that collapse are dropped.
#pragma once

#include <CGAL/Polyhedron_3.h>

#include <map>

#include "ways.h"

namespace psm {

/// Index of each point among the distinct ones; `same` decides.
template <class Point, class Same>
std::vector<int> weld(const std::vector<Point>& points, std::vector<Point>& distinct, Same same) {
  std::vector<int> index;
  for (const Point& p : points) {
    std::size_t k = 0;
    while (k < distinct.size() && !same(distinct[k], p)) ++k;
    if (k == distinct.size()) distinct.push_back(p);
    index.push_back(int(k));
  }
  return index;
}

inline double fan_volume(const std::vector<glm::dvec3>& v, const std::vector<int>& loop) {
  double six = 0;
  for (std::size_t k = 1; k + 1 < loop.size(); ++k)
    six += glm::dot(v[loop[0]] - v[0], glm::cross(v[loop[k]] - v[0], v[loop[k + 1]] - v[0]));
  return six / 6;
}

template <class Polyhedron, class Same>
WayBody body_of(const Polyhedron& mesh, Same same) {
  using Point = typename Polyhedron::Traits::Point_3;
  std::vector<Point> points, distinct;
  std::map<const void*, int> number;
  for (auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v) {
    number[&*v] = int(points.size());
    points.push_back(v->point());
  }
  const std::vector<int> index = weld(points, distinct, same);
  WayBody out;
  for (const Point& p : distinct)
    out.vertices.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  for (auto f = mesh.facets_begin(); f != mesh.facets_end(); ++f) {
    std::vector<int> loop;
    auto h = f->facet_begin();
    do {
      const int v = index[number.at(&*h->vertex())];
      if (loop.empty() || loop.back() != v) loop.push_back(v);
    } while (++h != f->facet_begin());
    if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    if (loop.size() < 3) continue;
    out.facet_sizes.push_back(int(loop.size()));
    out.volume += fan_volume(out.vertices, loop);
  }
  out.volume = std::abs(out.volume);
  return out;
}

}  // namespace psm
