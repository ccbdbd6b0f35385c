// SPDX-License-Identifier: GPL-3.0-or-later
// The small control on the eye view: what its colours mean, and the texel grid.
#pragma once

#include "ui/ui_context.h"

namespace psm {

const char* display_name(EyeOverlay overlay);

/// At the upper right of the eye view's picture; nothing where that has no room.
void eye_tools(UiContext& ui, const Rect& picture, Experiment& experiment);

}  // namespace psm
