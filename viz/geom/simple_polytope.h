// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting a convex polytope by planes with exact topology. Private to viz/geom.
//
// Every plane is moved outwards by an infinitesimal of its own, a later plane by infinitely more than all earlier ones
// (simulation of simplicity). So a corner that lies exactly on the cutting plane counts as inside, with no further case; three
// planes meet in every corner; flat bodies have an inside; and a body is empty exactly when the closed half-spaces have no common
// point. Corners that coincide are merged at the end (`to_body`).
#pragma once

#include <span>

#include "geom/convex_body.h"
#include "geom/exact.h"
#include "geom/filter.h"
#include "geom/inline_vector.h"

namespace psm {

class SimplePolytope {
 public:
  using Corner = ConvexBody::Corner;

  /// The planes must outlive this object.
  SimplePolytope(std::span<const Plane> planes, std::span<const Corner> corners);

  bool empty() const { return live_ == 0; }
  void cut(const Plane& plane);
  ConvexBody to_body();

 private:
  struct Node {
    Corner corner;
    int side;  // of the cutting plane: 1, 0, -1
    bool live;
    FilterCorner filtered;
  };
  static constexpr std::size_t kPlanes = 32, kNodes = 64;  // past these the heap is used
  using Indices = InlineVector<int, kNodes>;
  /// What merging coincident corners leaves: the vertex of each node, and for each vertex the node that gives its coordinates.
  struct Merged {
    Indices vertex_of, node_of;
  };

  void add_plane(const Plane& plane);
  int side(const Node& node, int plane);
  int side_in_doubt(const Node& node, int plane);
  void classify(int plane);
  int new_node(const Corner& corner);
  void cut_edges_of(int outside, int plane);
  void join(int facet, int node, int slot);
  void remove(int node);

  void merge_corners(Merged& merged);
  std::vector<int> facet_loop(int node, int facet, const Merged& merged) const;
  void add_facets(ConvexBody& body, const Merged& merged) const;
  void keep_corners(ConvexBody& body, const Indices& plane_at) const;
  std::vector<glm::dvec3> coordinates(const Merged& merged);

  InlineVector<const Plane*, kPlanes> planes_;
  InlineVector<FilterPlane, kPlanes> filters_;
  InlineVector<Node, kNodes> nodes_;
  Indices free_;                     // unused nodes
  Indices outside_;                  // of the cutting plane
  InlineVector<int, kPlanes> open_;  // for each facet, the new node that waits for its partner: node * 3 + slot
  int live_ = 0;
  SharedParts shared_;
  ExactPlanes exact_;
  Decisions decisions_;
};

/// Of the plane on which side the corner lies: 1 inside, 0 on it, -1 outside.
inline int SimplePolytope::side(const Node& node, int plane) {
  const FilterPlane& p = filters_[plane];
  const double value = dot4(p.value, node.filtered.value), bound = side_bound(p, node.filtered);
  if (!(std::abs(value) > bound)) return side_in_doubt(node, plane);
  ++decisions_.filtered;
  return value > 0 ? 1 : -1;
}

}  // namespace psm
