// SPDX-License-Identifier: GPL-3.0-or-later
// The views of one experiment as a picture, without a display.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "app/sheet.h"

namespace psm {

struct RenderRequest {
  std::vector<ViewId> views;  // one fills the picture; several share it in two columns, over a line with the light case
  glm::ivec2 size{1280, 720};
  double scale = 1.0;  // of line widths and type
  Theme theme = Theme::light;
  bool transparent = false;
};

constexpr int kLargestSide = 16384;
constexpr std::int64_t kMostPixels = 64 << 20;

/// Where the views go; an error, starting with "--size", where the picture has no room for them.
struct RenderLayout {
  std::vector<glm::ivec2> origins;  // top left of each view
  glm::ivec2 tile{0};               // size of each
  int status_height = 0, gap = 0;   // 0 for a single view; the status line is at the bottom
};
Result<RenderLayout> lay_out(const RenderRequest& request);

/// The views of `request`, as `layout` places them.
Sheet sheet_of(const LoadedExperiment& loaded, const RenderRequest& request, const RenderLayout& layout);

}  // namespace psm
