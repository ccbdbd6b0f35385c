// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/box.h"

#include <algorithm>

namespace psm {

void TypesetBox::place(const TypesetBox& part, glm::dvec2 offset) {
  for (GlyphRun run : part.runs) run.baseline += offset, runs.push_back(std::move(run));
  for (Rule rule : part.rules) rule.min += offset, rule.max += offset, rules.push_back(rule);
  for (TextStroke stroke : part.strokes) {
    for (glm::dvec2& point : stroke.points) point += offset;
    strokes.push_back(std::move(stroke));
  }
  width = std::max(width, offset.x + part.width);
  ascent = std::max(ascent, part.ascent - offset.y);
  descent = std::max(descent, part.descent + offset.y);
}

TypesetBox text_box(const std::string& text, const Type& type, Ink ink, const FontMetrics& metrics) {
  TypesetBox box;
  const Reach reach = metrics.reach(text, type);
  box.width = metrics.width(text, type), box.ascent = reach.above, box.descent = reach.below;
  box.runs.push_back({text, type, glm::dvec2(0.0), ink});
  return box;
}

}  // namespace psm
