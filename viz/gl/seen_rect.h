// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a picture in which something can be seen, so that only there it is cleared, drawn with several samples, and
// resolved.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "scene/scene.h"

namespace psm::gl {

/// Whole pixels; left and bottom belong to it, right and top do not.
struct PixelRect {
  int left = 0, bottom = 0, right = 0, top = 0;

  bool empty() const { return left >= right || bottom >= top; }
};

/// The clip-space rectangle min x, min y, max x, max y in whole pixels, inside the picture.
PixelRect pixel_rect(const glm::dvec4& rect, glm::ivec2 size);

PixelRect common(const PixelRect& a, const PixelRect& b);
/// The smallest that holds both.
PixelRect joined(const PixelRect& a, const PixelRect& b);

/// Grows with what is added; what has w <= 0 is not seen, what nears w = 0 reaches to the picture's border.
class SeenRect {
 public:
  void add_box(const glm::dmat4& clip_from_world, const Bounds& box);
  void add_polygon(const glm::dmat4& clip_from_space, std::span<const glm::dvec4> corners);

  /// With `margin` pixels more on each side.
  PixelRect pixels(glm::ivec2 size, int margin) const;

 private:
  void add_point(const glm::dvec4& p);
  void add_segment(const glm::dvec4& a, const glm::dvec4& b);

  glm::dvec2 min_{1e300}, max_{-1e300};
};

}  // namespace psm::gl
