// SPDX-License-Identifier: GPL-3.0-or-later
// The font's glyphs at one size, on one texture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gl/gl_objects.h"

namespace psm::gl {

/// A glyph's quad: pixels relative to the pen on the baseline, y downwards; and its place on the atlas.
struct Glyph {
  glm::vec2 min{0.0f}, max{0.0f}, atlas_min{0.0f}, atlas_max{0.0f};
  float advance = 0.0f;
};

/// Baked once for each size in use: whole pixels, two samples across.
class GlyphAtlas {
 public:
  GlyphAtlas(const std::string& font, int pixel_size);

  /// Characters that the font or the ranges lack come out as a white square.
  const Glyph& glyph(char32_t character) const;
  glm::dvec2 text_size(const std::string& text) const;
  double ascent() const { return ascent_; }
  GLuint texture() const { return texture_.get(); }

 private:
  bool bake(const std::string& font, int pixel_size, int side);
  void upload(const std::vector<std::uint8_t>& coverage, int side);

  std::map<char32_t, Glyph> glyphs_;
  double ascent_ = 0.0, height_ = 0.0;
  GlTexture texture_;
};

}  // namespace psm::gl
