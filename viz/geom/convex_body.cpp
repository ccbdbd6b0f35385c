// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/convex_body.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace psm {
namespace {

enum Side : signed char { outside = -1, on = 0, inside = 1 };

double evaluate(const Plane& p, const glm::dvec3& v) { return p.x * v.x + p.y * v.y + p.z * v.z + p.w; }

/// A vertex counts as on the plane within the rounding of its own evaluation.
Side side_of(const Plane& p, const glm::dvec3& v) {
  const double d = evaluate(p, v);
  const double terms = std::abs(p.x * v.x) + std::abs(p.y * v.y) + std::abs(p.z * v.z) + std::abs(p.w);
  const double rounding = 16 * 2.220446049250313e-16 * terms;
  return d > rounding ? inside : d < -rounding ? outside : on;
}

using EdgeKey = std::pair<int, int>;

/// One cut of a body: the vertices made on crossing edges, and the cap's edges.
struct Cut {
  const Plane& plane;
  const std::vector<Side>& side;
  ConvexBody& body;
  std::map<EdgeKey, int> made = {};
  std::map<int, int> cap_next = {};  // directed edges of the cap

  int crossing(int a, int b) {  // a and b on different sides, or one of them on the plane
    if (side[a] == on) return a;
    if (side[b] == on) return b;
    const EdgeKey key = std::minmax(a, b);
    const auto [it, fresh] = made.try_emplace(key, int(body.vertices.size()));
    if (fresh) {
      const glm::dvec3 p = body.vertices[key.first], q = body.vertices[key.second];
      const double dp = evaluate(plane, p), dq = evaluate(plane, q);
      body.vertices.push_back(p + (q - p) * (dp / (dp - dq)));
    }
    return it->second;
  }

  /// The kept part of one facet; remembers the cap's edge, which runs the other way.
  std::vector<int> clip_facet(const std::vector<int>& facet) {
    std::vector<int> kept;
    int leave = -1, enter = -1;
    for (std::size_t i = 0; i < facet.size(); ++i) {
      const int a = facet[i], b = facet[(i + 1) % facet.size()];
      if (side[a] != outside) kept.push_back(a);
      if ((side[a] == outside) == (side[b] == outside)) continue;
      const int c = crossing(a, b);
      (side[a] == outside ? enter : leave) = c;
      if (kept.empty() || kept.back() != c) kept.push_back(c);
    }
    if (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
    if (leave != enter) cap_next[enter] = leave;
    return kept;
  }

  std::vector<int> cap() const {
    std::vector<int> loop;
    if (cap_next.size() < 3) return loop;
    int at = cap_next.begin()->first;
    while (loop.size() < cap_next.size()) {
      loop.push_back(at);
      const auto next = cap_next.find(at);
      if (next == cap_next.end()) return {};
      at = next->second;
      if (at == loop.front()) break;
    }
    return loop;
  }
};

void drop_unused_vertices(ConvexBody& body) {
  std::vector<int> renamed(body.vertices.size(), -1);
  std::vector<glm::dvec3> used;
  for (auto& facet : body.facets)
    for (int& v : facet) {
      if (renamed[v] < 0) {
        renamed[v] = int(used.size());
        used.push_back(body.vertices[v]);
      }
      v = renamed[v];
    }
  body.vertices = std::move(used);
}

void clip_by(ConvexBody& body, const Plane& plane) {
  std::vector<Side> side(body.vertices.size());
  bool any_outside = false, any_kept = false;
  for (std::size_t i = 0; i < side.size(); ++i) {
    side[i] = side_of(plane, body.vertices[i]);
    (side[i] == outside ? any_outside : any_kept) = true;
  }
  if (!any_outside) return;
  if (!any_kept) {
    body = {};
    return;
  }
  Cut cut{plane, side, body};
  ConvexBody rest;
  for (std::size_t i = 0; i < body.facets.size(); ++i) {
    std::vector<int> kept = cut.clip_facet(body.facets[i]);
    if (kept.size() < 3) continue;
    rest.facets.push_back(std::move(kept));
    rest.planes.push_back(body.planes[i]);
  }
  if (std::vector<int> cap = cut.cap(); cap.size() >= 3) {
    rest.facets.push_back(std::move(cap));
    rest.planes.push_back(plane);
  }
  rest.vertices = std::move(body.vertices);
  body = std::move(rest);
  drop_unused_vertices(body);
}

double extent(const ConvexBody& body) {
  glm::dvec3 lo = body.vertices[0], hi = lo;
  for (const auto& v : body.vertices) lo = glm::min(lo, v), hi = glm::max(hi, v);
  return glm::length(hi - lo);
}

/// Sums weight(triangle) and weight * centroid over the facets' fans.
template <class Weight>
std::pair<double, glm::dvec3> weighted_centroid(const ConvexBody& body, double corners, Weight weight) {
  const glm::dvec3 o = body.vertices[0];
  double total = 0;
  glm::dvec3 sum(0);
  for (const auto& f : body.facets)
    for (std::size_t i = 1; i + 1 < f.size(); ++i) {
      const glm::dvec3 a = body.vertices[f[0]] - o, b = body.vertices[f[i]] - o, c = body.vertices[f[i + 1]] - o;
      const double w = weight(a, b, c);
      total += w;
      sum += w * (a + b + c) / corners;
    }
  return {total, total > 0 ? o + sum / total : o};
}

double six_tetrahedra(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) { return glm::dot(a, glm::cross(b, c)); }
double two_areas(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) { return glm::length(glm::cross(b - a, c - a)); }

}  // namespace

double ConvexBody::volume() const {
  return empty() ? 0.0 : std::max(0.0, weighted_centroid(*this, 4.0, six_tetrahedra).first / 6.0);
}

glm::dvec3 ConvexBody::centroid() const {
  assert(!empty());
  const double size = extent(*this);
  const auto [six_volumes, of_volume] = weighted_centroid(*this, 4.0, six_tetrahedra);
  if (six_volumes > 1e-9 * size * size * size) return of_volume;
  const auto [areas, of_surface] = weighted_centroid(*this, 3.0, two_areas);
  if (areas > 1e-9 * size * size) return of_surface;
  glm::dvec3 sum(0);
  for (const auto& v : vertices) sum += v - vertices[0];
  return vertices[0] + sum / double(vertices.size());
}

ConvexBody box_body(const glm::dvec3& min, const glm::dvec3& max) {
  ConvexBody b;
  for (int i = 0; i < 8; ++i) b.vertices.push_back({i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z});
  b.planes = {{1, 0, 0, -min.x}, {-1, 0, 0, max.x}, {0, 1, 0, -min.y}, {0, -1, 0, max.y}, {0, 0, 1, -min.z}, {0, 0, -1, max.z}};
  b.facets = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return b;
}

ConvexBody clip(ConvexBody body, std::span<const Plane> planes) {
  for (const Plane& p : planes) {
    if (body.empty()) break;
    clip_by(body, p);
  }
  return body;
}

std::vector<Plane> hull_with_light(const ConvexBody& body, const glm::dvec4& light) {
  std::vector<double> value;
  std::vector<Plane> hull;
  std::map<EdgeKey, int> facet_of;
  for (std::size_t i = 0; i < body.facets.size(); ++i) {
    value.push_back(glm::dot(body.planes[i], light));
    if (value[i] >= 0) hull.push_back(body.planes[i]);
    const auto& f = body.facets[i];
    for (std::size_t k = 0; k < f.size(); ++k) facet_of[{f[k], f[(k + 1) % f.size()]}] = int(i);
  }
  for (const auto& [edge, i] : facet_of) {
    const auto twin = facet_of.find({edge.second, edge.first});
    if (twin == facet_of.end() || value[i] < 0 || value[twin->second] >= 0) continue;
    const Plane silhouette = value[i] * body.planes[twin->second] - value[twin->second] * body.planes[i];
    if (glm::dvec3(silhouette) != glm::dvec3(0)) hull.push_back(silhouette);
  }
  return hull;
}

}  // namespace psm
