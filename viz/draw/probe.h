// SPDX-License-Identifier: GPL-3.0-or-later
// One texel and one pixel that meet: the texel of the map at a surface point, its footprint, and the two rays of Figure 2 of the
// 2002 paper.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "draw/view.h"
#include "math/texel_footprint.h"

namespace psm {

struct Probe {
  SurfacePoint receiver;
  std::optional<glm::dvec3> occluder;  // what keeps the light from it
  bool seen = false;                   // by the eye
  bool lit_side = false;               // the normal is on the light's side

  int layer = 0;           // of six maps
  glm::dvec2 in_map{0.0};  // where, clip coordinates
  glm::ivec2 texel{0};     // column and row from the map's lower left; outside [0, N) outside the map
  bool inside_map = false;
  /// The texel's four corners, along their light rays, on the receiver's tangent plane; empty where a ray does not meet it.
  std::vector<glm::dvec3> footprint;

  // PSM 2002, section 1.1, with beta between the *view* direction and the normal, as it must be.
  double r_s = 0, r_i = 0;      // distance from the light (infinite for a direction) and from the eye
  double alpha = 0, beta = 0;   // radians
  double beam = 0;              // d_s r_s: largest width of the texel's beam across the light ray at the receiver, world units
  double pixel = 0;             // d_i: a pixel's height at distance 1
  double d = 0;                 // (d_s r_s / r_i) (cos beta / cos alpha) / d_i, pixels; infinite where the light grazes
  TexelFootprint<double> size;  // m, measured
};

/// Pure. Nothing where the analysis has no map.
std::optional<Probe> make_probe(const Analysis& analysis, const SurfacePoint& receiver, std::optional<glm::dvec3> occluder,
                                bool seen);

/// The texel of the map view's sheet at a point of it: its layer, and its middle in that layer's clip coordinates; nothing beside
/// the maps.
struct SheetTexel {
  int layer = 0;
  glm::dvec2 center{0.0};
};
std::optional<SheetTexel> on_map(const Analysis& analysis, const glm::dvec2& sheet_point);

/// What a probe adds to a view, in the space of the view's list. `size` in pixels.
DrawList probe_list(const Probe& probe, ViewId id, const Analysis& analysis, glm::ivec2 size);

/// Name and value of each number, for a table: texel, r_s, r_i, alpha, beta, d, m, anisotropy, orientation.
std::vector<std::pair<std::string, std::string>> probe_numbers(const Probe& probe);

}  // namespace psm
