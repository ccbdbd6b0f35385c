// SPDX-License-Identifier: GPL-3.0-or-later
// Which view stands in which tile: the title of each is a menu.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/view.h"
#include "ui/ui_context.h"

namespace psm {

/// "Unit cube": as menus and help name it.
const char* display_name(ViewId view);

/// The view goes to the tile of this number; one that stands in another tile changes places with what was here. The number after
/// the last opens a tile; no view closes this one, unless it is the only one.
void put_in_tile(std::vector<ViewId>& tiles, std::size_t place, std::optional<ViewId> view);

/// A view's title on the screen, from the upper left corner of its tile: its lines, and the room that they take with their plate.
struct ShownTitle {
  std::vector<std::string> lines;
  double last = 0.0;  // the last line's width
  glm::dvec2 end{0.0};
};
ShownTitle shown_title(const ViewPicture& picture, glm::ivec2 tile, double scale);

/// The menu behind a view's title, at the upper left of its tile.
void tile_menu(UiContext& ui, ViewId id, const Rect& tile, const ViewPicture& picture, ViewSettings& view);

/// A menu of views for one place of the list, of the given width; its widgets are "NAME" and "NAME=VIEW".
void tile_field(UiContext& ui, const std::string& name, float width, std::size_t place, std::vector<ViewId>& tiles);

}  // namespace psm
