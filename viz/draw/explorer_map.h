// SPDX-License-Identifier: GPL-3.0-or-later
// A map of all lights there can be. Directions: a disc that preserves areas, the view direction in its middle and the opposite
// one all around its rim. Positions: a slice through the eye, along the view. On a page whose unit is a pixel at scale 1; y
// downwards.
#pragma once

#include <glm/glm.hpp>

#include "scene/analysis.h"

namespace psm {

struct ExplorerMap {
  bool directions = true;
  glm::dvec2 min{0.0}, max{0.0};  // of the map, on the page
  glm::dvec2 middle{0.0};         // the view direction, or the eye
  double scale = 1.0;             // radius of the disc; page units per scene unit
  glm::dvec3 eye{0.0}, forward{0.0, 0.0, -1.0}, right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0};
  glm::dvec3 across{0.0, 1.0, 0.0};  // of a slice: upwards on the page

  /// At theta from the view direction, in radians, and turned by `roll` from the camera's right towards its up.
  glm::dvec2 page_of(double theta, double roll) const;
  glm::dvec2 page_of_direction(const glm::dvec3& to_light) const;
  glm::dvec2 page_of_position(const glm::dvec3& position) const;
  glm::dvec2 page_of(const Analysis& analysis) const;  // its light

  /// Nearest point of the map.
  glm::dvec2 clamped(const glm::dvec2& page) const;
  bool contains(const glm::dvec2& page) const;

  /// `before` with its light there; a position keeps its distance from the slice. Within `reach` of w = 0 exactly on it.
  Experiment with_light_at(const Experiment& before, const glm::dvec2& page, double reach) const;
};

/// By the type of the light, and the experiment's slice.
ExplorerMap explorer_map(const Analysis& analysis, const glm::dvec2& page);

/// The map stands at the left of a wide page; this is what is left beside it. On other pages `max` is left of `min`.
struct PageRect {
  glm::dvec2 min{0.0}, max{0.0};
};
PageRect beside_explorer_map(const glm::dvec2& page);

}  // namespace psm
