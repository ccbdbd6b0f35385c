// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of text set into lines: what is drawn where, as plain data. The same for the window, presentations and tests.
#pragma once

#include "lesson/box.h"
#include "lesson/markdown.h"

namespace psm {

struct PageStyle {
  double width = 400.0;  // of the lines, in pixels
  double size = 18.0;    // of body text; all else scales with it
  double leading = 1.4;  // from baseline to baseline, in em
};

struct LinkArea {
  glm::dvec2 min{0.0}, max{0.0};
  std::string target;
};

/// The origin is the top left corner; nothing leaves [0, width] but what no line could hold.
struct TextPage {
  TypesetBox ink;
  std::vector<LinkArea> links;
  double height = 0.0;
};

/// `live`: the text of the value at a path.
TextPage typeset(const std::vector<Block>& blocks, const PageStyle& style, const FontMetrics& metrics,
                 const std::function<std::string(const std::string& path)>& live);

}  // namespace psm
