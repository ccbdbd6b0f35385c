// SPDX-License-Identifier: GPL-3.0-or-later
// A view's legend as texts, plates and marks: what the colours mean, and numbers, in the lower left corner.
#pragma once

#include <string>
#include <vector>

#include "draw/annotation.h"

namespace psm {

/// Whether height is what this view lacks.
bool is_low(const PictureFrame& frame);

/// A text that is wider than this, in lines that are not, as far as its blanks allow: first where several stand together.
std::vector<std::string> broken_lines(const std::string& text, double width, const TextSize& text_size);

/// Appends texts, plates (the ground first, then the swatches) and the lines that hatch swatches; returns the part of the view
/// that is taken.
Occupied lay_out_legend(const Legend& legend, const PictureFrame& frame, const TextSize& text_size, std::vector<TextBox>& texts,
                        std::vector<Plate>& plates, std::vector<Mark>& marks);

}  // namespace psm
