// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parts of a legend go: on one plate at the lower left, as wide as it needs to be, lines broken where the view ends.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "draw/legend.h"
#include "gl/overlay_vertices.h"

namespace psm::gl {

/// A text and where it goes; pixels, y downwards.
struct TextBox {
  glm::dvec2 top_left, size;
  std::string text;
  glm::vec4 color;
};

/// Appends texts, plates (the ground first, then the swatches) and the lines that hatch swatches; returns the part of the view
/// that is taken.
Occupied lay_out_legend(const Legend& legend, const PictureFrame& frame,
                        const std::function<glm::dvec2(const std::string&)>& text_size, std::vector<TextBox>& texts,
                        std::vector<ShapeVertex>& plates, std::vector<LineVertex>& marks);

}  // namespace psm::gl
