// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/relief_box.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kTurn = 0.9;              // radians, of the eye around the box
constexpr double kFloorShare = 0.42;       // of the height of the page
constexpr double kWidest = 2.2;            // the box, as parts of its height on the page
constexpr dvec2 kBottomRight(64.0, 56.0);  // room around the box
constexpr double kOverlap = 0.4;           // pixels that neighbours overlap

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

dvec2 outwards(const dvec2& a, const dvec2& b) {
  const double length = glm::distance(a, b);
  return length > 0.0 ? dvec2(b.y - a.y, a.x - b.x) / length : dvec2(0.0);
}

}  // namespace

ReliefBox::ReliefBox(const dvec2& page) {
  const dvec2 room = glm::max(page - kTopLeft - kBottomRight, dvec2(40.0));
  const double along = std::sin(kTurn) + std::cos(kTurn);
  const double width = std::min(room.x, kWidest * room.y);
  x_ = width / along;
  floor_ = kFloorShare * room.y / along;
  height_ = (1.0 - kFloorShare) * room.y;
  back_ = {kTopLeft.x + 0.5 * (room.x - width) + x_ * std::cos(kTurn), kTopLeft.y + height_};
}

dvec2 ReliefBox::at(const dvec3& p) const {
  return back_ + dvec2(x_ * (std::sin(kTurn) * p.x - std::cos(kTurn) * p.y),
                       floor_ * (std::cos(kTurn) * p.x + std::sin(kTurn) * p.y) - height_ * p.z);
}

/// Grown by `overlap` on all sides.
void ReliefBox::cover(std::vector<dvec2> corners, Role role, double alpha, double overlap) {
  const std::size_t n = corners.size();
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i) area += cross(corners[i], corners[(i + 1) % n]);
  if (n < 3 || std::abs(area) < 1e-3) return;
  if (area < 0.0) std::reverse(corners.begin(), corners.end());  // outputs draw one winding before the other
  DrawFill out{{}, role, alpha, true};
  for (std::size_t i = 0; i < n; ++i) {
    const dvec2 before = outwards(corners[(i + n - 1) % n], corners[i]), after = outwards(corners[i], corners[(i + 1) % n]);
    const dvec2 reach = overlap / std::max(0.5, 1.0 + glm::dot(before, after)) * (before + after);
    out.corners.push_back({corners[i] + reach, 0.0, 1.0});
  }
  list_.fills.push_back(std::move(out));
}

void ReliefBox::fill(const std::vector<dvec3>& corners, Role role, double alpha) {
  std::vector<dvec2> flat;
  for (const dvec3& corner : corners) flat.push_back(at(corner));
  cover(std::move(flat), role, alpha, kOverlap);
}

void ReliefBox::stroke(const dvec3& from, const dvec3& to, Role role, double width) {
  const dvec2 a = at(from), b = at(to);
  const double length = glm::distance(a, b);
  if (!(length > 1e-9)) return;
  const dvec2 side = 0.5 * width / length * dvec2(a.y - b.y, b.x - a.x);
  cover({a + side, b + side, b - side, a - side}, role, role == Role::text ? 0.75 : 1.0, 0.0);
}

void ReliefBox::line(const dvec3& a, const dvec3& b) {
  list_.lines.push_back({{at(a), 0.0, 1.0}, {at(b), 0.0, 1.0}, Role::neutral, 1.25});
}

void ReliefBox::text(const dvec2& on_page, const std::string& words, Role role, const dvec2& pivot) {
  list_.texts.push_back({{on_page, 0.0, 1.0}, words, role, pivot});
}

/// With depths that keep the order of the fills, whoever sorts them.
DrawList ReliefBox::list() const {
  DrawList out = list_;
  const double step = 1.8 / double(std::max<std::size_t>(1, out.fills.size()));
  double depth = 0.9;
  for (DrawFill& fill : out.fills) {
    for (glm::dvec4& corner : fill.corners) corner.z = depth;
    depth -= step;
  }
  return out;
}

}  // namespace psm
