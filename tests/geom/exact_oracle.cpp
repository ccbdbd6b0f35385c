// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_oracle.h"

#include <CGAL/Gmpzf.h>

#include <array>
#include <cmath>

namespace psm {
namespace {

using Number = CGAL::Gmpzf;
using Four = std::array<Number, 4>;

Number number(double x) { return Number(x); }

Number at(const Four& p, const Four& x) {
  Number sum(0);
  for (int k = 0; k < 4; ++k) sum += p[k] * x[k];
  return sum;
}

Four exact(const Plane& p) {
  Four out{number(p.x), number(p.y), number(p.z), number(p.offset)};
  if (!p.edge) {
    for (int k = 0; k < 3; ++k) out[3] -= out[k] * number(p.anchor[k]);
    return out;
  }
  const glm::dvec4& light = p.edge->light;
  const Four i = exact(p.edge->kept), j = exact(p.edge->dropped);
  const Four l{number(light.x), number(light.y), number(light.z), number(light.w)};
  for (int k = 0; k < 4; ++k) out[k] = at(i, l) * j[k] - at(j, l) * i[k];
  return out;
}

Number det3(const Number& a, const Number& b, const Number& c, const Number& d, const Number& e, const Number& f, const Number& g,
            const Number& h, const Number& i) {
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

/// Minor of rows a, b, c without column k, by Laplace's signs: the point common to three planes, or the plane of three points.
Four cross(const Four& a, const Four& b, const Four& c) {
  Four out;
  for (int k = 0; k < 4; ++k) {
    const int x = k == 0 ? 1 : 0, y = k <= 1 ? 2 : 1, z = k == 3 ? 2 : 3;
    const Number minor = det3(a[x], a[y], a[z], b[x], b[y], b[z], c[x], c[y], c[z]);
    out[k] = k % 2 ? minor : -minor;
  }
  return out;
}

bool zero(const Four& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0 && v[3] == 0; }

bool same_point(const Four& a, const Four& b) {  // both w > 0
  for (int k = 0; k < 3; ++k)
    if (a[k] * b[3] != b[k] * a[3]) return false;
  return true;
}

bool flat(const std::vector<Four>& points, const std::vector<int>& which) {  // on a line
  for (std::size_t i = 2; i < which.size(); ++i)
    if (!zero(cross(points[which[0]], points[which[1]], points[which[i]]))) return false;
  return true;
}

int dimension_of(const std::vector<Four>& points) {
  if (points.size() < 3) return int(points.size()) - 1;
  for (std::size_t i = 2; i < points.size(); ++i) {
    const Four plane = cross(points[0], points[1], points[i]);
    if (zero(plane)) continue;
    for (const Four& p : points)
      if (at(plane, p) != 0) return 3;
    return 2;
  }
  return 1;
}

std::vector<Four> vertices_of(const std::vector<Four>& planes) {
  std::vector<Four> found;
  const std::size_t n = planes.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        Four x = cross(planes[i], planes[j], planes[k]);
        if (x[3] == 0) continue;
        if (x[3] < 0)
          for (Number& c : x) c = -c;
        bool kept = true;
        for (std::size_t p = 0; p < n && kept; ++p) kept = !(at(planes[p], x) < 0);
        for (std::size_t f = 0; f < found.size() && kept; ++f) kept = !same_point(found[f], x);
        if (kept) found.push_back(x);
      }
  return found;
}

/// The point of the first three planes that have just one.
Four corner_of(const std::vector<Four>& planes) {
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j)
      for (std::size_t k = j + 1; k < planes.size(); ++k)
        if (const Four x = cross(planes[i], planes[j], planes[k]); x[3] != 0) return x;
  return {Number(0), Number(0), Number(0), Number(1)};
}

}  // namespace

OracleBody exact_intersection(std::span<const Plane> planes) {
  std::vector<Four> rows;
  for (const Plane& p : planes) rows.push_back(exact(p));
  const std::vector<Four> points = vertices_of(rows);
  OracleBody body;
  body.dimension = dimension_of(points);
  for (const Four& x : points) {
    const double w = x[3].to_double();
    body.vertices.push_back({x[0].to_double() / w, x[1].to_double() / w, x[2].to_double() / w});
  }
  std::vector<std::vector<int>> on;
  std::vector<std::set<int>> facets(points.size());
  for (std::size_t p = 0; p < rows.size(); ++p) {
    std::vector<int> members;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (at(rows[p], points[i]) == 0) members.push_back(int(i));
    on.push_back(members);
    int facet = -1;
    if (members.size() >= 3 && !flat(points, members))
      for (facet = 0; on[facet] != members;) ++facet;
    body.facet_of_plane.push_back(facet);
    if (facet == int(p))
      for (const int i : members) facets[i].insert(facet);
  }
  body.vertex_facets = {facets.begin(), facets.end()};
  return body;
}

double exact_volume(const ConvexBody& body) {
  if (body.dimension < 3) return 0;
  std::vector<std::vector<Four>> planes(body.vertices.size());
  for (std::size_t f = 0; f < body.facets.size(); ++f)
    for (const int v : body.facets[f]) planes[v].push_back(exact(body.planes[f]));
  std::vector<Four> points;
  for (const auto& p : planes) points.push_back(corner_of(p));
  double sum = 0;  // of positive terms
  for (const auto& f : body.facets)
    for (std::size_t k = 1; k + 1 < f.size(); ++k) {
      const Four &o = points[0], &a = points[f[0]], &b = points[f[k]], &c = points[f[k + 1]];
      const double weights = o[3].to_double() * a[3].to_double() * b[3].to_double() * c[3].to_double();
      sum += std::abs(at(cross(o, a, b), c).to_double() / weights);
    }
  return sum / 6;
}

}  // namespace psm
