// SPDX-License-Identifier: GPL-3.0-or-later
// The curves on the screen: the cursor that turns the light, values under the mouse, which quantity shows, and its CSV.
#pragma once

#include <string>

#include "ui/ui_context.h"
#include "ui/view_images.h"

namespace psm {

/// Whether the mouse at this pixel of the picture grabs the cursor: over theta, within the axes.
bool grabs_cursor(const ViewImages& images, glm::dvec2 pixel, double scale);

/// `before`, with the light at the angle of this pixel of the picture. Angles that the curves mark, and 90 degrees, attract it
/// from `snap_pixels`.
Experiment with_cursor_at(const Experiment& before, const ViewImages& images, glm::dvec2 pixel, double scale, double snap_pixels);

/// The values of all techniques under the mouse; after the picture.
void draw_curve_reading(const UiContext& ui, const Rect& picture, const ViewImages& images);

/// At the upper right of the picture. Returns whether the curves are to be copied as CSV.
bool curve_tools(UiContext& ui, const Rect& picture, Experiment& experiment);

}  // namespace psm
