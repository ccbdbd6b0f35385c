// SPDX-License-Identifier: GPL-3.0-or-later
// A slider for doubles with marks: linear or logarithmic, snapping to its marks, typed values on Ctrl+click or Tab.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "ui/theme.h"

namespace psm {

struct Tick {
  double value = 0.0;
  std::string label;  // shown above the mark; may be empty
  Role role = Role::neutral;
};

struct SliderRange {
  double min = 0.0, max = 1.0;
  bool logarithmic = false;  // then 0 < min
  bool whole = false;        // whole numbers only,
  double step = 1.0;         // these far apart, from min on
};

/// 0 at min, 1 at max, and back; clamped.
double slider_place(const SliderRange& range, double value);
double slider_value(const SliderRange& range, double place);

/// `value` where the tick within `reach` (in places) is nearest, else unchanged.
double snapped(const SliderRange& range, double value, std::span<const Tick> ticks, double reach);

/// One line, as wide as ImGui's next item width. `text`: the value as shown. Typed values may leave the range; the caller clamps.
bool ticked_slider(const char* id, double& value, const SliderRange& range, std::span<const Tick> ticks, const std::string& text,
                   Theme theme);

/// Room above a slider for the labels of its ticks, in pixels; 0 if they have none.
float tick_label_height(std::span<const Tick> ticks);

}  // namespace psm
