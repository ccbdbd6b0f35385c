// SPDX-License-Identifier: GPL-3.0-or-later
// The small control on the cube view: how far it has come from the world to the cube.
#pragma once

#include "ui/ui_context.h"

namespace psm {

/// At the upper right of the cube view's picture; nothing where that has no room.
void cube_tools(UiContext& ui, const Rect& picture, Experiment& experiment);

}  // namespace psm
