// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/closed_mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace psm {
namespace {

using Index = std::uint32_t;

/// For each position, the first in the list that is equal to it.
std::vector<Index> welded(const std::vector<glm::dvec3>& positions) {
  std::vector<Index> order(positions.size()), same(positions.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto key = [&](Index i) { return std::make_tuple(positions[i].x, positions[i].y, positions[i].z, i); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  for (std::size_t k = 0; k < order.size(); ++k)
    same[order[k]] = k > 0 && positions[order[k]] == positions[order[k - 1]] ? same[order[k - 1]] : order[k];
  return same;
}

struct Edge {
  Index low, high;
  int way;  // 1 from low to high, -1 back
};

bool cancel_out(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
  int sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    sum += edges[i].way;
    const bool last = i + 1 == edges.size() || edges[i].low != edges[i + 1].low || edges[i].high != edges[i + 1].high;
    if (last && sum != 0) return false;
  }
  return true;
}

Index root_of(std::vector<Index>& piece, Index i) {
  while (piece[i] != i) i = piece[i] = piece[piece[i]];
  return i;
}

}  // namespace

bool is_closed(const Mesh& mesh) {
  const std::vector<Index> corner_of = welded(mesh.positions);
  std::vector<Index> piece = corner_of;
  std::vector<Edge> edges;
  for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = corner_of[mesh.triangles[t + k]], b = corner_of[mesh.triangles[t + (k + 1) % 3]];
      if (a == b) continue;
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
      piece[root_of(piece, a)] = root_of(piece, b);
    }
  }
  if (edges.empty() || !cancel_out(edges)) return false;
  std::vector<double> volume(mesh.positions.size(), 0.0);
  std::vector<bool> used(mesh.positions.size(), false);
  const glm::dvec3 origin = mesh.positions[mesh.triangles[0]];
  for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
    const Index i = root_of(piece, corner_of[mesh.triangles[t]]);
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.triangles[t + k]] - origin; };
    volume[i] += glm::dot(at(0), glm::cross(at(1), at(2)));
    used[i] = true;
  }
  for (std::size_t i = 0; i < volume.size(); ++i)
    if (used[i] && !(volume[i] > 0.0)) return false;
  return true;
}

}  // namespace psm
