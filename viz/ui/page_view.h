// SPDX-License-Identifier: GPL-3.0-or-later
// Set pages on the screen: measured and drawn with the window's fonts.
#pragma once

#include <string>

#include "lesson/typeset.h"
#include "ui/ui_context.h"

namespace psm {

/// Measures with the fonts of the current look.
FontMetrics screen_metrics();

/// Draws at the cursor and moves it below. Links are buttons, named `name`.link.0 and so on; returns where the one that was
/// clicked leads, else "".
std::string show_page(UiContext& ui, const TextPage& page, const std::string& name);

}  // namespace psm
