// SPDX-License-Identifier: GPL-3.0-or-later
// The aliasing error as a relief over angle and depth (GMNPR 2007, Figure 6): its heights are log F.
#pragma once

#include "draw/draw_list.h"
#include "scene/curve_quantity.h"

namespace psm {

/// On a page whose unit is a pixel at scale 1, y downwards. The relief is made of opaque fills, the far ones first, so that every
/// output hides what lies behind.
DrawList relief_list(const CurveSetting& setting, const glm::dvec2& page);

}  // namespace psm
