// SPDX-License-Identifier: GPL-3.0-or-later
// One view on the screen: its picture, and what the mouse does in it.
#pragma once

#include <optional>
#include <string>

#include "ui/handles.h"
#include "ui/ui_context.h"
#include "ui/view_images.h"

namespace psm {

/// The drag that is under way in a view, and what keys would move.
struct ViewDrag {
  enum class Kind { none, turn, pan, handle, light };
  Kind kind = Kind::none;
  std::optional<HandleDrag> handle;
  std::optional<HandleKind> selected;  // by keyboard
  std::optional<Experiment> before;    // of a light that is dragged in the curves or in the explorer's map
};

/// Takes the mouse in this rectangle, with the pictures of the last frame: edits `experiment`. Returns the history tag of a
/// change that comes in steps (the wheel), else "".
std::string tile_input(UiContext& ui, ViewId id, const Rect& picture, const ViewImages& images, ViewDrag& drag,
                       Experiment& experiment);

/// Draws it; after ViewImages::update.
void draw_tile(UiContext& ui, ViewId id, const Rect& picture, const ViewImages& images, const ViewDrag& drag);

}  // namespace psm
