// SPDX-License-Identifier: GPL-3.0-or-later
// E on the central line of the view, measured in the map itself, and the least that any map can have.
#pragma once

#include <optional>

#include "scene/analysis.h"

namespace psm {

/// Along the view axis between the technique's n and f: the largest 1 / (z tan(phi) ds/dt), where s runs once across the map and
/// t is the length perpendicular to the light in the plane of view and light (GMNPR 2007, section 2, with E = F sin(theta)).
/// Nothing where light and view are parallel, or where there is no single map.
std::optional<double> largest_line_error(const Analysis& analysis);

/// sin(theta) ln(f/n) / tan(phi): a map whose texels are equal in the image all along the line and that spends none elsewhere.
/// From E ds = sin(theta) dz / (z tan(phi)), integrated over the line, and the integral of ds at most 1.
double logarithmic_line_error(double near, double far, double phi, double theta);

}  // namespace psm
