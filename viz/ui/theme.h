// SPDX-License-Identifier: GPL-3.0-or-later
// Colours, spacing and type of the widgets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>

#include "draw/draw_list.h"
#include "gl/renderer.h"
#include "lesson/box.h"

struct ImVec4;
struct ImFont;

namespace psm {

/// Everything that a new font texture or a fresh style depends on.
struct LookKey {
  int font_px = 0;     // whole pixels on the screen
  double scale = 0.0;  // of spacing and lines
  Theme theme = Theme::light;
  bool operator==(const LookKey&) const = default;
};

/// Body text of this size and a style of this scale, made afresh. The font texture on the graphics card is then out of date.
void apply_look(const LookKey& look, const std::filesystem::path& font);

/// The fonts of the current look: body text; headings, larger; code.
ImFont* face_font(Face face);

/// Packed colours for ImDrawList.
using Color = std::uint32_t;
Color color(const glm::vec3& srgb, double alpha = 1.0);
Color text_color(double alpha = 1.0);  // of the current style
Color line_color(Role role, Theme theme);

/// Ground of the window behind all panes; the accent colour of what is selected or dragged.
glm::vec3 ground_color(Theme theme);
glm::vec3 accent_color(Theme theme);
glm::vec3 warning_color(Theme theme);

}  // namespace psm
