// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas set as boxes.
#pragma once

#include "lesson/box.h"
#include "lesson/formula.h"

namespace psm {

/// What no line break divides of a formula.
struct FormulaPiece {
  TypesetBox box;
  bool after_quad = false;  // a statement of its own begins here: the best place to break before
};

/// In parts between which a line may break: after each relation that stands in no group, and after a quad. `display`: fractions
/// in full size.
std::vector<FormulaPiece> formula_pieces(const Formula& formula, double size, bool display, Ink ink, const FontMetrics& metrics);

}  // namespace psm
