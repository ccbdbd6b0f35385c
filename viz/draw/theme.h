// SPDX-License-Identifier: GPL-3.0-or-later
// The palette of roles on a light or a dark ground. sRGB, 0 to 1.
#pragma once

#include <glm/glm.hpp>

#include "draw/draw_list.h"

namespace psm {

enum class Theme { light, dark };

/// What a view is drawn into.
struct PictureFrame {
  glm::dvec2 size{1.0};  // pixels
  double scale = 1.0;    // of line widths and type
  Theme theme = Theme::light;
};

glm::vec3 picture_ground(Theme theme);

/// Beside the eye's image, where the view letterboxes.
glm::vec3 picture_outside(Theme theme);

/// For lines and points: the role's colour, darkened or lightened in linear light until it has the contrast of 3:1 with the
/// ground that meaningful lines need (WCAG); yellow and orange on white do not have it by themselves.
glm::vec3 picture_line_color(Role role, Theme theme);

/// Colour and opacity of a fill: translucent ones have the role's colour as it is.
glm::vec4 picture_fill(const DrawFill& fill, Theme theme);

/// For labels: at least 7:1, so that they read from a projector as well.
glm::vec3 picture_label_color(Role role, Theme theme);

/// WCAG contrast of two sRGB colours, 1 to 21.
float contrast(const glm::vec3& a, const glm::vec3& b);

}  // namespace psm
