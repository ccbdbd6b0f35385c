// SPDX-License-Identifier: GPL-3.0-or-later
// Chess pieces, Staunton pattern: they stand on y = 0 about the y axis and face +x. One unit is the side of a square.
#pragma once

#include "scene/builtin_shapes.h"

namespace psm::shapes {

Solid pawn();
Solid rook();
Solid knight();
Solid bishop();
Solid queen();
Solid king();

/// Plinth and flare that every piece begins with, up to its waist (radius, height).
Outline foot(double radius, glm::dvec2 waist);

}  // namespace psm::shapes
