// SPDX-License-Identifier: GPL-3.0-or-later
// Some roles stand out, others are left out, as a step of a lesson asks.
#pragma once

#include "draw/draw_list.h"

namespace psm {

struct Emphasis {
  /// Lines and bodies of these stronger, those of others fainter; what has no role of its own stays. None: no change.
  std::vector<Role> strong;
  std::vector<Role> hidden;  // left out
  bool operator==(const Emphasis&) const = default;
};

void emphasise(DrawList& list, const Emphasis& emphasis);

}  // namespace psm
