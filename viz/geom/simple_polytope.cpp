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
  const Node made{corner, 1, true, filter_corner(filter_of(0), filter_of(1), filter_of(2))};
  int index = int(nodes_.size());
  if (free_.empty()) {
    nodes_.push_back(made);
  } else {
    index = free_.back();
    free_.pop_back();
    nodes_[index] = made;
  }
  ++live_;
  return index;
}

int SimplePolytope::side(const Node& node, int plane) {
  const FilterPlane& p = filters_[plane];
  const double value = dot4(p.value, node.filtered.value), bound = side_bound(p, node.filtered);
  if (value > bound || value < -bound) {
    ++decisions_.filtered;
    return value > 0 ? 1 : -1;
  }
  const auto& c = node.corner.plane;
  if (known_to_meet(filters_[c[0]], filters_[c[1]], filters_[c[2]], p)) {
    ++decisions_.shared;
    return 0;
  }
  ++decisions_.exact;
  return exact_.side({planes_.data(), planes_.size()}, c, plane);
}

/// Finds the side of every corner; true if some lie outside.
bool SimplePolytope::classify(int plane) {
  bool any = false;
  for (Node& n : nodes_) {
    if (!n.live) continue;
    n.side = side(n, plane);
    any |= n.side < 0;
  }
  return any;
}

void SimplePolytope::cut(const Plane& plane) {
  const auto is_plane = [&](const Plane* p) { return same_definition(*p, plane); };
  assert(std::isfinite(dot4(plane, plane)));
  if (empty() || std::any_of(planes_.begin(), planes_.end(), is_plane)) return;
  add_plane(plane);
  const int p = int(planes_.size()) - 1;
  if (classify(p)) {
    const int old_size = int(nodes_.size());
    for (int i = 0; i < old_size; ++i)
      if (nodes_[i].live && nodes_[i].side >= 0) cut_edges_of(i, p);
    remove_outside();
  }
}

/// Ends the edges that run from an inside node to an outside one at the plane. Seen from its other end an edge's planes come in
/// the opposite order.
void SimplePolytope::cut_edges_of(int node, int plane) {
  if (nodes_[node].corner.plane[2] == plane) return;  // made by this cut
  for (int k = 0; k < 3; ++k) {
    const Corner from = nodes_[node].corner;
    const Node& far_end = nodes_[from.next[k]];
    if (far_end.side >= 0) continue;
    const int a = from.plane[(k + 1) % 3], b = from.plane[(k + 2) % 3];
    const int made = new_node({{b, a, plane}, {-1, -1, node}});
    nodes_[node].corner.next[k] = made;
    join(a, made, 0);
    join(b, made, 1);
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

void SimplePolytope::remove_outside() {
  for (int i = 0; i < int(nodes_.size()); ++i) {
    if (!nodes_[i].live || nodes_[i].side >= 0) continue;
    nodes_[i].live = false;
    free_.push_back(i);
    --live_;
  }
}

}  // namespace psm
