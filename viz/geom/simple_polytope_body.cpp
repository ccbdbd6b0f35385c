// SPDX-License-Identifier: GPL-3.0-or-later
// From the simple polytope to the body: coincident corners become one vertex, facets that shrank to an edge or a point go, and
// coordinates are rounded.
#include <algorithm>
#include <numeric>

#include "geom/simple_polytope.h"

namespace psm {
namespace {

int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

int position_of(const ConvexBody::Corner& c, int plane) { return c.plane[0] == plane ? 0 : c.plane[1] == plane ? 1 : 2; }

/// Large where the three planes cut each other cleanly.
double quality(const FilterCorner& c) { return c.value.w / c.magnitude.w; }

int dimension_of(std::size_t vertices, std::size_t facets) {
  if (vertices < 3) return int(vertices) - 1;
  return facets == 2 ? 2 : 3;
}

}  // namespace

/// The corners that coincide are joined by edges of length zero: the ends of an edge coincide when one lies on the plane that the
/// edge leaves at the other.
SimplePolytope::Merged SimplePolytope::merge_corners() {
  const int count = int(nodes_.size());
  std::vector<int> parent(count);
  std::iota(parent.begin(), parent.end(), 0);
  for (int i = 0; i < count; ++i) {
    if (!nodes_[i].live) continue;
    const Corner& c = nodes_[i].corner;
    for (int k = 0; k < 3; ++k)
      if (c.next[k] > i && side(nodes_[c.next[k]], c.plane[k]) == 0) parent[root_of(parent, i)] = root_of(parent, c.next[k]);
  }
  Merged merged;
  merged.vertex_of.assign(count, -1);
  merged.node_of.reserve(live_);
  for (int i = 0; i < count; ++i) {
    if (!nodes_[i].live) continue;
    int& vertex = merged.vertex_of[root_of(parent, i)];
    if (vertex < 0) {
      vertex = int(merged.node_of.size());
      merged.node_of.push_back(i);
    }
    merged.vertex_of[i] = vertex;
    int& best = merged.node_of[vertex];
    if (quality(nodes_[i].filtered) > quality(nodes_[best].filtered)) best = i;
  }
  return merged;
}

/// The facet's vertices, counter-clockwise from outside: at each corner along the edge that leaves the plane before the facet's.
std::vector<int> SimplePolytope::facet_loop(int node, int facet, const std::vector<int>& vertex_of) const {
  std::vector<int> loop;
  loop.reserve(8);
  int at = node;
  do {
    if (loop.empty() || loop.back() != vertex_of[at]) loop.push_back(vertex_of[at]);
    const Corner& c = nodes_[at].corner;
    at = c.next[(position_of(c, facet) + 2) % 3];
  } while (at != node);
  if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
  return loop;
}

void SimplePolytope::add_facets(ConvexBody& body, const Merged& merged) const {
  std::vector<int> start(planes_.size(), -1);
  for (int i = 0; i < int(nodes_.size()); ++i)
    if (nodes_[i].live)
      for (const int p : nodes_[i].corner.plane) start[p] = i;
  std::vector<int> without_facet;
  body.planes.reserve(planes_.size());
  body.facets.reserve(planes_.size());
  for (int p = 0; p < int(planes_.size()); ++p) {
    if (start[p] < 0) continue;
    std::vector<int> loop = facet_loop(start[p], p, merged.vertex_of);
    if (loop.size() < 3) {
      without_facet.push_back(p);
      continue;
    }
    body.facets.push_back(std::move(loop));
    body.planes.push_back(*planes_[p]);
  }
  body.dimension = dimension_of(body.vertices.size(), body.facets.size());
  if (body.dimension < 3)
    for (const int p : without_facet) body.planes.push_back(*planes_[p]);
}

/// The corners and the planes that still meet in one, renumbered.
void SimplePolytope::keep_simple(ConvexBody& body) const {
  std::vector<int> plane_at(planes_.size(), -1), corner_at(nodes_.size(), -1);
  int corners = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].live) continue;
    corner_at[i] = corners++;
    for (const int p : nodes_[i].corner.plane) plane_at[p] = 0;
  }
  body.simple_planes.reserve(planes_.size());
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    if (plane_at[p] < 0) continue;
    plane_at[p] = int(body.simple_planes.size());
    body.simple_planes.push_back(*planes_[p]);
  }
  body.simple_corners.reserve(corners);
  for (const Node& n : nodes_) {
    if (!n.live) continue;
    Corner c = n.corner;
    for (int k = 0; k < 3; ++k) c.plane[k] = plane_at[c.plane[k]], c.next[k] = corner_at[c.next[k]];
    body.simple_corners.push_back(c);
  }
}

/// The quotient of doubles where its error bound is near the rounding of the coordinates' own size, else the exact quotient.
glm::dvec3 SimplePolytope::vertex(const Node& node) {
  const glm::dvec4 &v = node.filtered.value, &m = node.filtered.magnitude;
  const glm::dvec3 x = glm::dvec3(v) / v.w;
  const glm::dvec3 size = glm::abs(x);
  const double relative = std::max({size.x, size.y, size.z});
  const glm::dvec3 bound = 64 * kRoundingUnit * (glm::dvec3(m) + size * m.w) / v.w;
  if (std::max({bound.x, bound.y, bound.z}) <= 1e-12 * relative) return x;
  return exact_.vertex(planes_, node.corner.plane);
}

ConvexBody SimplePolytope::to_body() {
  ConvexBody body;
  if (!empty()) {
    const Merged merged = merge_corners();
    body.vertices.reserve(merged.node_of.size());
    for (const int i : merged.node_of) body.vertices.push_back(vertex(nodes_[i]));
    add_facets(body, merged);
    keep_simple(body);
  }
  body.decisions = decisions_;
  return body;
}

}  // namespace psm
