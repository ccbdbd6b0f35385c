// SPDX-License-Identifier: GPL-3.0-or-later
// The last rounding: a corner's coordinates, corrected once by residuals in double-double arithmetic. Private to viz/geom.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "geom/plane.h"

namespace psm {

/// One Newton step for the point common to three planes from `x`, a few digits short of it; the residuals see the planes' exact
/// definitions to 100 bits.
glm::dvec3 refined(const std::array<const Plane*, 3>& planes, const glm::dvec3& x);

}  // namespace psm
