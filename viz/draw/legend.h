// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours of a view mean, as plain data.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace psm {

struct LegendEntry {
  glm::vec3 color;  // sRGB, 0 to 1
  std::string text;
  bool hatched = false;  // marked without colour, too
};

/// A heading, colours with their meaning, and lines of numbers, at the lower left of the view.
struct Legend {
  std::string title;
  std::vector<LegendEntry> entries;
  std::vector<std::string> lines;
  bool empty() const { return title.empty() && entries.empty() && lines.empty(); }
};

}  // namespace psm
