// SPDX-License-Identifier: GPL-3.0-or-later
// What a TrueType font can show, and how wide: enough to set and to check text without anything that draws.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "scene/result.h"

namespace psm {

/// The code points, first and last of each range, that the window's type is baked for: Latin, Greek, punctuation, sub- and
/// superscripts, arrows and mathematics, shapes.
inline constexpr char32_t kTextRanges[][2] = {{0x0020, 0x007E}, {0x00A0, 0x00FF}, {0x0370, 0x03FF},
                                              {0x1D62, 0x1D65}, {0x2010, 0x205F}, {0x2070, 0x209F},
                                              {0x2100, 0x214F}, {0x2190, 0x22FF}, {0x25A0, 0x25FF}};

/// How far a text's ink reaches above and below the baseline.
struct Reach {
  double above = 0.0, below = 0.0;
};

class FontFace {
 public:
  static Result<FontFace> load(const std::filesystem::path& file);

  /// `bytes` of a .ttf file; without glyphs where they are no font.
  explicit FontFace(std::string bytes);
  ~FontFace();
  FontFace(FontFace&&) noexcept;

  /// The font has it, and it lies in kTextRanges.
  bool has(char32_t point) const;
  /// Of a line of UTF-8 text, in parts of the font's size (ascent plus descent).
  double width(const std::string& text) const;
  /// Of such a line in this size.
  glm::dvec2 text_size(const std::string& text, double size) const { return {size * width(text), size}; }
  /// How far its ink reaches above and below the baseline, in parts of the size.
  Reach reach(const std::string& text) const;

 private:
  struct Font;
  std::unique_ptr<Font> font_;
};

}  // namespace psm
