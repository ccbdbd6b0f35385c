// SPDX-License-Identifier: GPL-3.0-or-later
// A box in space on a flat page, and what is drawn in it: what comes later covers what came before. Private to viz/draw.
#pragma once

#include <string>
#include <vector>

#include "draw/draw_list.h"

namespace psm {

/// The box is [0, 1]^3, seen in a parallel projection from the side of large x and y, with z upwards. The page's unit is a pixel
/// at scale 1, y downwards.
class ReliefBox {
 public:
  explicit ReliefBox(const glm::dvec2& page);

  /// Where a point of the box stands on the page; the box leaves what is above and left of `kTopLeft` free.
  glm::dvec2 at(const glm::dvec3& p) const;
  static constexpr glm::dvec2 kTopLeft{70.0, 66.0};

  /// A convex polygon that covers what is behind it, and a little more, so that no seam shows between neighbours.
  void fill(const std::vector<glm::dvec3>& corners, Role role, double alpha);
  /// A line that covers, and is covered.
  void stroke(const glm::dvec3& from, const glm::dvec3& to, Role role, double width);
  /// Over all of them.
  void line(const glm::dvec3& a, const glm::dvec3& b);
  void text(const glm::dvec2& on_page, const std::string& words, Role role, const glm::dvec2& pivot);

  DrawList list() const;

 private:
  void cover(std::vector<glm::dvec2> corners, Role role, double alpha, double overlap);

  double x_, floor_, height_;
  glm::dvec2 back_;  // the corner that is farthest from the eye
  DrawList list_;
};

}  // namespace psm
