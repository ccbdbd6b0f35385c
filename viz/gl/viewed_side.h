// SPDX-License-Identifier: GPL-3.0-or-later
// Which boxes a view shows, decided on the processor: what lies outside the picture is not drawn, what is whole needs no test a
// pixel, and of a projective picture's two sides of w = 0 each box is drawn on those that it reaches.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace psm::gl {

/// Beyond `reach` half sides of the cube nothing is shown; from `clear` on it fades.
struct CubeLimit {
  glm::dmat4 cube_from_world{1.0};
  double clear = 1.0, reach = 1.0;
};

struct Shown {
  bool at_all = false;  // something of it may be in the picture
  bool clear = true;    // all of it is nearer than where fading starts
  bool uncut = false;   // all of it is beyond the picture's near plane
};

class ViewedSide {
 public:
  /// `sign`: of w, 1 or -1.
  ViewedSide(const glm::dmat4& clip_from_world, double sign, const std::optional<CubeLimit>& limit = std::nullopt);

  Shown of(const Bounds& box) const;
  /// The largest w on the box, of this side: its far end, in whatever unit this side has.
  double far_end(const Bounds& box) const;

 private:
  std::vector<glm::dvec4> seen_, clear_, uncut_;  // half-spaces p.x >= 0 in world space that hold what the word says
};

}  // namespace psm::gl
