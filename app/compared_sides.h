// SPDX-License-Identifier: GPL-3.0-or-later
// Two techniques in one view of a sheet, A and B: which part of the picture is whose, and the marks that say so.
#pragma once

#include <string>
#include <vector>

#include "app/caption.h"
#include "app/sheet.h"
#include "draw/font_face.h"
#include "ui/layout.h"

namespace psm {

/// A plate over a panel, with a text; without one, the line that divides the panel.
struct SidePlate {
  glm::ivec2 top_left{0}, size{0};  // of one with a text: what it may take; it takes as much as its lines need
  std::string text;
};

/// The columns of the panel's picture that are its side's: from, to before.
glm::ivec2 shown_columns(const SheetPanel& panel);

/// What of the panel's picture that leaves, below the plates.
ShownPart shown_part(const SheetPanel& panel, const Analysis& analysis, const FontFace& font, double scale);

/// None where the panel shows one technique alone.
std::vector<SidePlate> side_plates(const SheetPanel& panel, const Analysis& analysis, double scale);

void draw_plate(const SidePlate& plate, const Caption& caption, const Sheet& sheet, Image& whole);
PagePanel plate_panel(const SidePlate& plate, const FontFace& font, const Sheet& sheet);

/// Adds the views as panels, each at its place: those that both techniques share twice, all of B's before A's, because
/// a painter keeps what the last panel needed.
void add_compared_panels(Sheet& sheet, const std::shared_ptr<const LoadedExperiment>& loaded, const std::vector<ViewId>& views,
                         const std::vector<Rect>& places);

}  // namespace psm
