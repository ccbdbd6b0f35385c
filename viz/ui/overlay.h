// SPDX-License-Identifier: GPL-3.0-or-later
// A DrawList over a view's picture, by ImGui: for what comes and goes with the mouse. In front of everything.
#pragma once

#include "draw/view.h"
#include "ui/ui_context.h"

namespace psm {

/// `under`: the view's picture, whose labels are kept free. `picture`: where it is on the screen.
void draw_over(const UiContext& ui, const DrawList& list, const ViewPicture& under, const Rect& picture);

}  // namespace psm
