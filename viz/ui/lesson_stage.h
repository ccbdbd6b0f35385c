// SPDX-License-Identifier: GPL-3.0-or-later
// How a step of a lesson fills the screen in front of a class. Plain numbers, no widgets.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace psm {

struct PartSize {
  double height = 0.0;
  bool begins = false;  // a group: its parts share a screen where one can hold them
};

struct StageFit {
  double column = 0.0;                 // width of the text, margins included, in pixels
  double size = 0.0;                   // of its type
  std::vector<std::size_t> begins{0};  // the first part of each screen
  std::size_t divided = 0;             // groups that go on on another screen
  bool fits = true;                    // false: one part alone is too much for a screen, which then has to be scrolled
};

/// Type that the last row reads, and type beyond which a class gains nothing, in a window of this height.
double least_stage_type(int window_height);
double largest_stage_type(int window_height);

/// The first part of each screen; nothing where one part is higher than a screen. `gap` stands between parts.
std::optional<std::vector<std::size_t>> spread_over_screens(const std::vector<PartSize>& parts, double gap, double height);

/// Whether parts whose heights may have changed still are on screens that begin like this.
bool stays_on_screens(const std::vector<PartSize>& parts, const std::vector<std::size_t>& begins, double gap, double height);

/// The parts' heights in a column of text of this width and in type of this size; nothing where something is wider than that.
using MeasureParts = std::function<std::optional<std::vector<PartSize>>(double width, double size)>;

/// As few screens as possible, with as few groups divided; for them the largest type; for that the narrowest column, since the
/// views take the rest. `height`: of a screen. `margin`: on either side of the text.
StageFit fit_stage(glm::ivec2 window, double height, double margin, double gap, const MeasureParts& measure);

}  // namespace psm
