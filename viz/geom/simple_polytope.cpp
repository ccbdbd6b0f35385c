// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/simple_polytope.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace psm {

SimplePolytope::SimplePolytope(std::span<const Plane> planes, std::span<const Corner> corners) {
  for (const Plane& p : planes) add_plane(p);
  for (const Corner& c : corners) new_node(c);
}

void SimplePolytope::add_plane(const Plane& plane) {
  planes_.push_back(&plane);
  filters_.push_back(filter_plane(plane));
  shared_.annotate(plane, filters_.back());
  open_.push_back(-1);
}

int SimplePolytope::new_node(const Corner& corner) {
  const auto filter_of = [&](int k) -> const FilterPlane& { return filters_[corner.plane[k]]; };
  int index = int(nodes_.size());
  if (free_.empty()) {
    nodes_.append();
  } else {
    index = free_.back();
    free_.pop_back();
  }
  Node& node = nodes_[index];
  node.corner = corner;
  node.side = 1;
  node.live = true;
  node.filtered = filter_corner(filter_of(0), filter_of(1), filter_of(2));
  ++live_;
  return index;
}

/// Where doubles cannot tell.
int SimplePolytope::side_in_doubt(const Node& node, int plane) {
  const auto& c = node.corner.plane;
  if (known_to_meet(filters_[c[0]], filters_[c[1]], filters_[c[2]], filters_[plane])) {
    ++decisions_.shared;
    return 0;
  }
  ++decisions_.exact;
  return exact_.side({planes_.data(), planes_.size()}, c, plane);
}

/// Finds the side of every corner and lists those outside.
void SimplePolytope::classify(int plane) {
  outside_.clear();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Node& n = nodes_[i];
    if (!n.live) continue;
    n.side = side(n, plane);
    if (n.side < 0) outside_.push_back(int(i));
  }
}

void SimplePolytope::cut(const Plane& plane) {
  const auto is_plane = [&](const Plane* p) { return same_definition(*p, plane); };
  assert(std::isfinite(dot4(plane, plane)));
  if (empty() || std::any_of(planes_.begin(), planes_.end(), is_plane)) return;
  add_plane(plane);
  const int p = int(planes_.size()) - 1;
  classify(p);
  for (const int i : outside_) cut_edges_of(i, p);
  for (const int i : outside_) remove(i);
}

/// Ends the edges that run from an outside node to an inside one at the plane. Seen from its other end an edge's planes come in
/// the opposite order.
void SimplePolytope::cut_edges_of(int outside, int plane) {
  for (int k = 0; k < 3; ++k) {
    const Corner& from = nodes_[outside].corner;
    const int inside = from.next[k], a = from.plane[(k + 1) % 3], b = from.plane[(k + 2) % 3];
    if (nodes_[inside].side < 0) continue;
    const int made = new_node({{a, b, plane}, {-1, -1, inside}});
    auto& next = nodes_[inside].corner.next;
    *std::find(next.begin(), next.end(), outside) = made;
    join(b, made, 0);
    join(a, made, 1);
  }
}

/// Two new nodes lie on each facet that the plane crosses; the second one meets the first.
void SimplePolytope::join(int facet, int node, int slot) {
  int& waiting = open_[facet];
  if (waiting < 0) {
    waiting = node * 3 + slot;
    return;
  }
  nodes_[waiting / 3].corner.next[waiting % 3] = node;
  nodes_[node].corner.next[slot] = waiting / 3;
  waiting = -1;
}

void SimplePolytope::remove(int node) {
  nodes_[node].live = false;
  free_.push_back(node);
  --live_;
}

}  // namespace psm
