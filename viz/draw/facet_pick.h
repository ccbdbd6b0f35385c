// SPDX-License-Identifier: GPL-3.0-or-later
// Which facet of H or R lies under a pixel of the world or cube view, and which planes made it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/view.h"

namespace psm {

struct PickedFacet {
  Role body = Role::caster_body;
  std::string text;                 // "H: light and the edge of V near and V left"
  std::vector<glm::dvec2> outline;  // pixels, y downwards
};

/// The nearest facet under the pixel. Where facets of both bodies coincide, R's, which lies within H. In the cube view facets
/// that cross w = 0 are passed over.
std::optional<PickedFacet> pick_facet(const ViewPicture& picture, const Analysis& analysis, glm::ivec2 size, glm::dvec2 pixel);

}  // namespace psm
