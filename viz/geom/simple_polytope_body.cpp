// SPDX-License-Identifier: GPL-3.0-or-later
// From the simple polytope to the body: coincident corners become one vertex, facets that shrank to an edge or a point go, and
// coordinates are rounded.
#include <algorithm>
#include <utility>

#include "geom/refine.h"
#include "geom/simple_polytope.h"

namespace psm {
namespace {

template <class Indices>
int root_of(Indices& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

int position_of(const ConvexBody::Corner& c, int plane) { return c.plane[0] == plane ? 0 : c.plane[1] == plane ? 1 : 2; }

/// Large where the three planes cut each other cleanly.
double quality(const FilterCorner& c) { return c.value.w / c.magnitude.w; }

double largest_of(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

int dimension_of(std::size_t vertices, std::size_t facets) {
  if (vertices < 3) return int(vertices) - 1;
  return facets == 2 ? 2 : 3;
}

}  // namespace

/// The corners that coincide are joined by edges of length zero: the ends of an edge coincide when one lies on the plane that the
/// edge leaves at the other.
void SimplePolytope::merge_corners(Merged& merged) {
  const int count = int(nodes_.size());
  Indices parent;
  for (int i = 0; i < count; ++i) parent.push_back(i);
  for (int i = 0; i < count; ++i) {
    if (!nodes_[i].live) continue;
    const Corner& c = nodes_[i].corner;
    for (int k = 0; k < 3; ++k)
      if (c.next[k] > i && side(nodes_[c.next[k]], c.plane[k]) == 0) parent[root_of(parent, i)] = root_of(parent, c.next[k]);
  }
  merged.vertex_of.resize(count, -1);
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
}

/// The facet's vertices, counter-clockwise from outside: at each corner along the edge that leaves the plane before the facet's.
std::vector<int> SimplePolytope::facet_loop(int node, int facet, const Merged& merged) const {
  InlineVector<int, 32> loop;
  int at = node;
  do {
    const int v = merged.vertex_of[at];
    if (loop.empty() || loop.back() != v) loop.push_back(v);
    const Corner& c = nodes_[at].corner;
    at = c.next[(position_of(c, facet) + 2) % 3];
  } while (at != node);
  if (loop.size() > 1 && loop[0] == loop.back()) loop.pop_back();
  if (loop.size() < 3) return {};
  return {loop.begin(), loop.end()};
}

/// The planes with facets come first, then those whose facets shrank to an edge or a point.
void SimplePolytope::add_facets(ConvexBody& body, const Merged& merged) const {
  Indices start(planes_.size(), -1), plane_at(planes_.size(), -1), without_facet;
  std::size_t used = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].live)
      for (const int p : nodes_[i].corner.plane) used += std::exchange(start[p], int(i)) < 0;
  const auto add = [&](int p) {
    plane_at[p] = int(body.planes.size());
    body.planes.push_back(*planes_[p]);
  };
  body.planes.reserve(used);
  body.facets.reserve(used);
  for (int p = 0; p < int(planes_.size()); ++p) {
    if (start[p] < 0) continue;
    std::vector<int> loop = facet_loop(start[p], p, merged);
    if (loop.empty()) {
      without_facet.push_back(p);
    } else {
      body.facets.push_back(std::move(loop));
      add(p);
    }
  }
  for (const int p : without_facet) add(p);
  body.dimension = dimension_of(body.vertices.size(), body.facets.size());
  keep_corners(body, plane_at);
}

/// The corners, renumbered. Which infinitesimal was larger no longer matters: those of later cuts are larger than all of these.
void SimplePolytope::keep_corners(ConvexBody& body, const Indices& plane_at) const {
  Indices corner_at(nodes_.size(), -1);
  int corners = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].live) corner_at[i] = corners++;
  body.corners.reserve(corners);
  for (const Node& n : nodes_) {
    if (!n.live) continue;
    Corner c = n.corner;
    for (int k = 0; k < 3; ++k) c.plane[k] = plane_at[c.plane[k]], c.next[k] = corner_at[c.next[k]];
    body.corners.push_back(c);
  }
}

/// Quotients of doubles, where their error bound is not small beside the body's largest coordinate refined once, and where even
/// the normals' determinant is in doubt exact quotients.
std::vector<glm::dvec3> SimplePolytope::coordinates(const Merged& merged) {
  std::vector<glm::dvec3> out;
  out.reserve(merged.node_of.size());
  InlineVector<double, kNodes> bounds;
  double largest = 0;
  for (const int i : merged.node_of) {
    const glm::dvec4 &v = nodes_[i].filtered.value, &m = nodes_[i].filtered.magnitude;
    out.push_back(glm::dvec3(v) / v.w);
    const double size = largest_of(absolute(out.back()));
    bounds.push_back(64 * kRoundingUnit * (largest_of(glm::dvec3(m)) + size * m.w) / v.w);
    largest = std::max(largest, size);
  }
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (bounds[k] <= 2e-13 * largest) continue;
    const Node& n = nodes_[merged.node_of[k]];
    const auto& c = n.corner.plane;
    const bool close = bounds[k] <= 1e-6 * largest && kRoundingUnit * n.filtered.magnitude.w <= 1e-8 * n.filtered.value.w;
    out[k] = close ? refined({planes_[c[0]], planes_[c[1]], planes_[c[2]]}, out[k])
                   : exact_.vertex({planes_.data(), planes_.size()}, c);
  }
  return out;
}

ConvexBody SimplePolytope::to_body() {
  ConvexBody body;
  if (!empty()) {
    Merged merged;
    merge_corners(merged);
    body.vertices = coordinates(merged);
    add_facets(body, merged);
  }
  body.decisions = decisions_;
  return body;
}

}  // namespace psm
