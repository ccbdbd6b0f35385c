// SPDX-License-Identifier: GPL-3.0-or-later
// The texels of the map in the picture: the heat map's scale and legend, and how many lines of the texel grid one can read.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "draw/view.h"

namespace psm {

/// Bands of colour, an octave each, on a logarithmic scale: the first ends at 2^first_bound, the last has no end. Those that
/// begin at `marked_from` (log2) or beyond are hatched.
struct HeatScale {
  int first_bound = 0, marked_from = 1000;
  std::vector<glm::vec3> colors;  // sRGB
  bool hatched(std::size_t band) const { return first_bound + int(band) - 1 >= marked_from; }
};

/// For m it diverges at 1: blue where texels are finer than pixels, orange where they are coarser, lightest at 1, in the
/// palette's own blue and vermillion, which stay apart for the common kinds of colour blindness. Anisotropy has no middle.
/// Nothing for the other overlays.
const HeatScale* heat_scale(EyeOverlay overlay);

/// sRGB grey of surfaces that have no m because they face away from the light or are outside its cone.
constexpr glm::vec3 kNoTexelColor{0.62f};

/// Legend of a heat map, with the numbers of analysis.texels where somebody filled them in.
Legend heat_legend(EyeOverlay overlay, const Analysis& analysis);

/// Every how many texels (a power of two) a line of the grid is drawn: on all but `fraction` of what the eye sees of the
/// receivers lines are then at least 12 pixels apart in a view of `size`, and where they are much closer they fade. 0 where there
/// is no map or no receiver. Views from outside show much of what is small to the eye: there a larger fraction is right.
int readable_texel_step(const Analysis& analysis, const glm::dmat4& clip_from_world, glm::ivec2 size, double fraction = 0.5);

/// Sets the view's overlay, grid and legend as the experiment asks for them.
void add_texel_overlay(ViewPicture& picture, const Analysis& analysis, glm::ivec2 size);

}  // namespace psm
