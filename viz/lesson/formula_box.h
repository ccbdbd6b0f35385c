// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas set as boxes.
#pragma once

#include "lesson/box.h"
#include "lesson/formula.h"

namespace psm {

/// In parts between which a line may break: after each relation that stands in no group. `display`: fractions in full size.
std::vector<TypesetBox> formula_boxes(const Formula& formula, double size, bool display, Ink ink, const FontMetrics& metrics);

}  // namespace psm
