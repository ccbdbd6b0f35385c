// SPDX-License-Identifier: GPL-3.0-or-later
// Where everything stands in the window: whole pixels, from fractions.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "scene/experiment.h"
#include "ui/settings.h"

namespace psm {

/// Pixels; y downwards. Empty where a side is not positive.
struct Rect {
  glm::ivec2 min{0}, max{0};
  glm::ivec2 size() const { return max - min; }
  bool empty() const { return max.x <= min.x || max.y <= min.y; }
  bool contains(glm::dvec2 p) const { return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y; }
};

using ViewSizes = std::array<glm::ivec2, kAllViews.size()>;  // by ViewId, in pixels; 0: hidden

struct Layout {
  std::array<Rect, kAllViews.size()> views;                            // by ViewId; empty: hidden
  Rect lesson, pane, badges;                                           // lesson, pane empty: hidden
  Rect lesson_splitter, pane_splitter, column_splitter, row_splitter;  // empty: nothing to divide
  bool visible(ViewId id) const { return !views[std::size_t(id)].empty(); }
  const Rect& view(ViewId id) const { return views[std::size_t(id)]; }
};

/// The tiles, one to four in reading order: two side by side (in a high room one above the other), a third below them over the
/// full width, or two rows of two; a maximised view has their place for itself. `badge_height` and `splitter` (the dividers'
/// thickness) in pixels.
Layout lay_out(glm::ivec2 window, const LayoutSettings& settings, const ViewSettings& view, int badge_height, int splitter);

/// The settings after a divider was dragged to this pixel.
enum class Splitter { lesson, pane, column, row };
LayoutSettings move_splitter(Splitter splitter, glm::dvec2 to, glm::ivec2 window, LayoutSettings settings, int badge_height);
LayoutSettings reset_splitter(Splitter splitter, LayoutSettings settings);

}  // namespace psm
