// SPDX-License-Identifier: GPL-3.0-or-later
// The view's title and the labels: text on rounded plates, with leaders to what they name.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "draw/view.h"
#include "gl/glyph_atlas.h"
#include "gl/legend_layout.h"
#include "gl/overlay_vertices.h"

namespace psm::gl {

class TextPass {
 public:
  TextPass(const std::filesystem::path& shaders, const std::filesystem::path& font);

  /// Places labels, title and legend, and appends their plates, leaders and marks (hatching over plates) to what the other passes
  /// draw.
  std::vector<TextBox> layout(const ViewPicture& picture, const PictureFrame& frame, std::vector<ShapeVertex>& plates,
                              std::vector<LineVertex>& leaders, std::vector<LineVertex>& marks);
  void draw(const std::vector<TextBox>& boxes, const PictureFrame& frame);

  glm::dvec2 text_size(const std::string& text, double scale) { return atlas(scale).text_size(text); }

 private:
  struct Vertex {
    glm::vec3 position;
    glm::vec2 atlas;
    glm::vec4 color;
  };
  GlyphAtlas& atlas(double scale);
  void append_text(std::vector<Vertex>& to, const TextBox& box, const GlyphAtlas& glyphs, const PictureFrame& frame) const;

  Program program_;
  VertexStream stream_;
  std::string font_;
  std::map<int, GlyphAtlas> atlases_;  // by pixel size
};

}  // namespace psm::gl
