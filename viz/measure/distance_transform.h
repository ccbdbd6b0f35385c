// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from every pixel of an image to the nearest one of a set. Private to viz/measure.
#pragma once

#include <vector>

namespace psm {

/// On entry 0 for the pixels of the set, infinite elsewhere; on return the squared Euclidean distance to the set, in pixels,
/// exact for images up to 2,896 pixels a side (as far as floats hold whole numbers) and correctly ordered beyond. Time is linear
/// in the pixels: lower envelopes of parabolas, along columns, then along rows (Felzenszwalb and Huttenlocher 2012).
void spread_squared_distances(std::vector<float>& image, int width, int height);

}  // namespace psm
