// SPDX-License-Identifier: GPL-3.0-or-later
// Set text as plain data: glyph runs, rules and strokes around a baseline. Pixels, x to the right, y downwards.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "draw/font_face.h"

namespace psm {

enum class Face { regular, bold, mono };
enum class Ink { text, faint, link, live, code };

/// `size`: ascent plus descent, in pixels. Oblique type leans, with the widths of the upright one.
struct Type {
  Face face = Face::regular;
  bool oblique = false;
  double size = 18.0;
};

struct GlyphRun {
  std::string text;
  Type type;
  glm::dvec2 baseline{0.0};  // where its pen starts
  Ink ink = Ink::text;
};

struct Rule {
  glm::dvec2 min{0.0}, max{0.0};
  Ink ink = Ink::text;
};

struct TextStroke {
  std::vector<glm::dvec2> points;
  double width = 1.0;
  Ink ink = Ink::text;
};

/// The origin is the left end of the baseline.
struct TypesetBox {
  double width = 0.0, ascent = 0.0, descent = 0.0;
  std::vector<GlyphRun> runs;
  std::vector<Rule> rules;
  std::vector<TextStroke> strokes;

  /// Draws `part` here and grows around it; `width` grows to its right end.
  void place(const TypesetBox& part, glm::dvec2 offset);
};

/// Whoever draws measures: the screen's atlas, or the font file.
struct FontMetrics {
  std::function<double(const std::string&, const Type&)> width;
  std::function<Reach(const std::string&, const Type&)> reach;
};

/// DejaVu: an em is the design size, the unit of typographic spaces.
constexpr double em_of(double size) { return size / 1.164; }

TypesetBox text_box(const std::string& text, const Type& type, Ink ink, const FontMetrics& metrics);

}  // namespace psm
