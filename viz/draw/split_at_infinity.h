// SPDX-License-Identifier: GPL-3.0-or-later
// Segments and polygons of homogeneous points, as the pieces of them that a finite box holds. What crosses w = 0 is torn there:
// it leaves the box towards infinity on one side and comes back on the other.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace psm {

struct Box {
  glm::dvec3 min{-1.0}, max{1.0};
  glm::dvec3 center() const { return 0.5 * (min + max); }
  glm::dvec3 half() const { return 0.5 * (max - min); }
  /// Scaled about its middle.
  Box scaled(double factor) const { return {center() - factor * half(), center() + factor * half()}; }
  bool contains(const glm::dvec3& p) const {
    return glm::all(glm::lessThanEqual(min, p)) && glm::all(glm::lessThanEqual(p, max));
  }
};

/// A piece of a segment, with its ends in Cartesian coordinates, in the direction of the segment; cut: the box ends it there.
struct Piece {
  glm::dvec3 a, b;
  bool cut_a = false, cut_b = false;
};

/// The part of the segment { (1 - t) a + t b } whose points have w of the sign `side` (1 or -1) and lie, after division, in the
/// box. The box is tested on homogeneous points, side * (max w - x) >= 0 and so on, so nothing near w = 0 is ever divided.
std::optional<Piece> clip_segment(const glm::dvec4& a, const glm::dvec4& b, const Box& box, int side = 1);

/// Both sides of the segment, in its own order: at most two pieces. A direction (w = 0) as an end runs to the box's wall.
std::vector<Piece> split_segment(const glm::dvec4& a, const glm::dvec4& b, const Box& box);

/// The part of a convex polygon with w of the sign `side` that lies in the box; empty if there is none. On the negative side its
/// winding is reversed, because negated points are seen from the other side: what bounds a body stays counter-clockwise from
/// outside.
std::vector<glm::dvec3> clip_polygon(const std::vector<glm::dvec4>& corners, const Box& box, int side = 1);

}  // namespace psm
