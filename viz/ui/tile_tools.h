// SPDX-License-Identifier: GPL-3.0-or-later
// A plate for a row of small controls, at the upper right of a view's picture.
#pragma once

#include "ui/layout.h"

namespace psm {

/// `width`, of what stands on it: pixels. False where the picture has no room; then nothing is begun.
bool begin_tile_tools(const char* id, const Rect& picture, float width);
void end_tile_tools();

}  // namespace psm
