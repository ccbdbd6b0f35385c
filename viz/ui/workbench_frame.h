// SPDX-License-Identifier: GPL-3.0-or-later
// What one frame passes around. Private to workbench*.cpp.
#pragma once

#include "ui/workbench.h"

namespace psm {

constexpr int smallest_view = 8;  // pixels; below, nothing can be seen

struct Workbench::Frame {
  glm::ivec2 size;
  double scale, now;
  Layout layout;
  ViewRects second;  // B's pictures
  UiContext ui;
  Experiment edited;
  std::string tag;
  bool changed = false;

  ViewSizes view_sizes() const {
    ViewSizes sizes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      sizes[i] = layout.views[i].size();
      if (sizes[i].x < smallest_view || sizes[i].y < smallest_view) sizes[i] = glm::ivec2(0);
    }
    return sizes;
  }
};

}  // namespace psm
