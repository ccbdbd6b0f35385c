// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace psm {

std::vector<std::size_t> pareto_front(std::span<const glm::dvec2> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y)) order.push_back(i);
  const auto before = [&](std::size_t a, std::size_t b) {
    const glm::dvec2 &p = points[a], &q = points[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    const bool same_as_last = !front.empty() && points[front.back()] == points[i];
    if (points[i].y < least || same_as_last) front.push_back(i);
    least = std::min(least, points[i].y);
  }
  return front;
}

}  // namespace psm
