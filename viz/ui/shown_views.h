// SPDX-License-Identifier: GPL-3.0-or-later
// The views as they stand in the window, without what is around them: for whoever draws them into a file.
#pragma once

#include <optional>
#include <vector>

#include "draw/emphasis.h"
#include "draw/theme.h"
#include "lesson/lesson.h"
#include "scene/experiment_file.h"
#include "ui/layout.h"

namespace psm {

struct ShownViews {
  LoadedExperiment loaded;  // with every orbit written out
  std::vector<ViewId> views;
  std::vector<Rect> places;  // of each, in pixels from the upper left corner of them all
  glm::ivec2 size{0};        // of them all
  double scale = 1.0;
  Theme theme = Theme::light;
  Emphasis emphasis;
  std::optional<Animation> animation;  // of the lesson's step
};

}  // namespace psm
