// SPDX-License-Identifier: GPL-3.0-or-later
// Some roles stand out, as a step of a lesson asks.
#pragma once

#include "draw/draw_list.h"

namespace psm {

/// Lines and bodies of these roles stronger, those of others fainter; what has no role of its own stays. None: nothing changes.
void emphasise(DrawList& list, const std::vector<Role>& strong);

}  // namespace psm
