// SPDX-License-Identifier: GPL-3.0-or-later
// The views of one experiment as a sheet.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "app/sheet.h"
#include "ui/layout.h"

namespace psm {

struct RenderRequest {
  // One fills the picture; several share it in two columns, an odd last one over both, above a line with the light case.
  std::vector<ViewId> views;
  glm::ivec2 size{1280, 720};
  double scale = 1.0;  // of line widths and type
  Theme theme = Theme::light;
  bool transparent = false;
  Emphasis emphasis = {};
};

constexpr int kLargestSide = 16384;
constexpr std::int64_t kMostPixels = 64 << 20;

/// Where the views go, in pixels.
struct RenderLayout {
  std::vector<Rect> places;
  int status_height = 0;  // of the line at the bottom; 0: none
};
/// As the request says; an error, starting with "--size", where the picture has no room for the views.
Result<RenderLayout> lay_out(const RenderRequest& request);

/// The views of `request`, as `layout` places them.
Sheet sheet_of(const LoadedExperiment& loaded, const RenderRequest& request, const RenderLayout& layout);

}  // namespace psm
