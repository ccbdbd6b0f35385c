// SPDX-License-Identifier: GPL-3.0-or-later
// The bar at the bottom: each badge a shape and words.
#pragma once

#include <string>
#include <vector>

#include "ui/ui_context.h"

namespace psm {

enum class BadgeShape { none, disc, ring, parallels, triangle, square };

struct Badge {
  BadgeShape shape = BadgeShape::none;
  std::string text, help;
  glm::vec3 tone{0.5f};  // of the shape
  std::string name;      // as Places knows it
};

/// Light case, technique, "worse than uniform", notes, times, and the last message. `views_ms`: of the last drawing of the views.
std::vector<Badge> badges(const Model& model, double views_ms, const std::string& message, Theme theme);

/// Draws them into `bar`, line after line, as many as the bar has; one that is alone in its line is written smaller where it
/// must. Returns the name of the one that was clicked, else "".
std::string badge_bar(UiContext& ui, const std::vector<Badge>& badges, const Rect& bar);

/// In pixels: two lines in windows of a small width, else one.
int badge_bar_height(int width);
int badge_line_height();

}  // namespace psm
