// SPDX-License-Identifier: GPL-3.0-or-later
// The views as they stand in the window, without what is around them: for whoever draws them into a file.
#pragma once

#include <optional>
#include <string>
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

/// Views on their way into a file. A film is many pictures: the window goes on between two of them. Nothing is left of one that
/// is dropped before its end.
class ViewsWriter {
 public:
  virtual ~ViewsWriter() = default;

  /// A moment's work; an error ends it. Needs a current OpenGL context, as its end does.
  virtual std::optional<InputError> step() = 0;
  virtual bool done() const = 0;

  struct Progress {
    double part = 0.0;  // of the pictures
    std::string text;
  };
  virtual Progress progress() const = 0;
};

}  // namespace psm
