// SPDX-License-Identifier: GPL-3.0-or-later
// The aliasing error as a surface over angle and depth (GMNPR 2007, Figure 6): filled bands and lines of equal F.
#pragma once

#include "draw/chart.h"
#include "scene/curve_quantity.h"

namespace psm {

/// The technique whose surface shows: the current one, or GMNPR where that has none.
Warp surface_warp(const CurveSetting& setting);

/// Levels at 1, 2, 5, 10 ... between the least of the values and 150 times that; none where all are alike.
std::vector<double> surface_levels(const std::vector<double>& values);

/// Over theta and z, which the axes of the chart are.
void add_surface(const CurveSetting& setting, Chart& chart);

}  // namespace psm
