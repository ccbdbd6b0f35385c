// SPDX-License-Identifier: GPL-3.0-or-later
// The explorer on the screen: its light as a handle, its slice, and the quiz beside it.
#pragma once

#include <optional>

#include "scene/light_quiz.h"
#include "ui/ui_context.h"
#include "ui/view_images.h"

namespace psm {

/// Whether the mouse at this pixel of the picture is on the map.
bool on_explorer_map(const ViewImages& images, glm::ivec2 size, glm::dvec2 pixel, double scale);

/// `before`, with the light where the mouse is; w = 0 attracts it from `snap_pixels`.
Experiment with_light_under(const Experiment& before, const ViewImages& images, glm::ivec2 size, glm::dvec2 pixel, double scale,
                            double snap_pixels);

/// The small controls at the upper right: the slice, and the quiz's button. Returns whether that was clicked.
bool explorer_tools(UiContext& ui, const Rect& picture, Experiment& experiment);

/// What is left beside the map for the quiz; where that is too little the quiz covers the picture.
Rect quiz_place(const Rect& picture, double scale);

}  // namespace psm
