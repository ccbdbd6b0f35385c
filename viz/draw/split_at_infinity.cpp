// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/split_at_infinity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace psm {
namespace {

/// Homogeneous half-space distance of the box's wall `i`; two opposite walls together imply w >= 0.
double wall_distance(const glm::dvec4& q, const Box& box, int i) {
  const int axis = i / 2;
  return i % 2 == 0 ? q[axis] - box.min[axis] * q.w : box.max[axis] * q.w - q[axis];
}

/// A positive factor does not move a point; equal magnitudes keep t well conditioned.
glm::dvec4 scaled_to_one(const glm::dvec4& q) {
  const double largest = std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z), std::abs(q.w)});
  return largest > 0.0 ? q / largest : q;
}

bool finite(const glm::dvec4& q) { return std::isfinite(q.x + q.y + q.z + q.w); }

/// Divides; none where rounding has left nothing to divide by. The clamp removes the rounding of the cut.
std::optional<glm::dvec3> divided(const glm::dvec4& q, const Box& box) {
  if (!(q.w > 0.0)) return std::nullopt;
  const glm::dvec3 p = glm::dvec3(q) / q.w;
  if (!std::isfinite(p.x + p.y + p.z) || !box.scaled(1.0 + 1e-6).contains(p)) return std::nullopt;
  return glm::clamp(p, box.min, box.max);
}

std::vector<glm::dvec4> clip_to_wall(const std::vector<glm::dvec4>& corners, const Box& box, int wall) {
  std::vector<glm::dvec4> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec4& p = corners[i];
    const glm::dvec4& q = corners[(i + 1) % corners.size()];
    const double dp = wall_distance(p, box, wall), dq = wall_distance(q, box, wall);
    if (dp >= 0.0) kept.push_back(p);
    if ((dp >= 0.0) != (dq >= 0.0)) kept.push_back(scaled_to_one(glm::mix(p, q, dp / (dp - dq))));
  }
  return kept;
}

}  // namespace

std::optional<Piece> clip_segment(const glm::dvec4& a, const glm::dvec4& b, const Box& box, int side) {
  if (!finite(a) || !finite(b)) return std::nullopt;
  const glm::dvec4 p = double(side) * scaled_to_one(a), q = double(side) * scaled_to_one(b);
  double t0 = 0.0, t1 = 1.0;
  for (int wall = 0; wall < 6; ++wall) {
    const double dp = wall_distance(p, box, wall), dq = wall_distance(q, box, wall);
    if (dp < 0.0 && dq < 0.0) return std::nullopt;
    if (dp < 0.0) t0 = std::max(t0, dp / (dp - dq));
    if (dq < 0.0) t1 = std::min(t1, dp / (dp - dq));
  }
  if (!(t0 < t1)) return std::nullopt;
  const auto start = divided(glm::mix(p, q, t0), box), end = divided(glm::mix(p, q, t1), box);
  if (!start || !end) return std::nullopt;
  return Piece{*start, *end, t0 > 0.0, t1 < 1.0};
}

std::vector<Piece> split_segment(const glm::dvec4& a, const glm::dvec4& b, const Box& box) {
  const int first = a.w < 0.0 || (a.w == 0.0 && b.w < 0.0) ? -1 : 1;
  std::vector<Piece> pieces;
  for (int side : {first, -first}) {
    if (auto piece = clip_segment(a, b, box, side)) pieces.push_back(*piece);
  }
  return pieces;
}

std::vector<glm::dvec3> clip_polygon(const std::vector<glm::dvec4>& corners, const Box& box, int side) {
  std::vector<glm::dvec4> kept;
  for (const glm::dvec4& corner : corners) {
    if (!finite(corner)) return {};
    kept.push_back(double(side) * scaled_to_one(corner));
  }
  for (int wall = 0; wall < 6 && !kept.empty(); ++wall) kept = clip_to_wall(kept, box, wall);
  std::vector<glm::dvec3> result;
  for (const glm::dvec4& q : kept) {
    if (auto p = divided(q, box); p && (result.empty() || result.back() != *p)) result.push_back(*p);
  }
  if (result.size() < 3) return {};
  if (side < 0) std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace psm
