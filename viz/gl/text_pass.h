// SPDX-License-Identifier: GPL-3.0-or-later
// Text on the picture: a quad for each glyph.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "draw/annotation.h"
#include "gl/glyph_atlas.h"

namespace psm::gl {

class TextPass {
 public:
  TextPass(const std::filesystem::path& shaders, const std::filesystem::path& font);

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
