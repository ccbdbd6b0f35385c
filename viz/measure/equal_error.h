// SPDX-License-Identifier: GPL-3.0-or-later
// How large a uniform map must be for an error no larger than a given one: Figure 1 of the 2002 paper, as a number.
#pragma once

#include <functional>
#include <optional>

namespace psm {

struct ResolutionRange {
  int smallest = 16, largest = 8192;
  double step = 1.0 / 64;  // the answer is this close, relatively; 0: to the texel
};

/// Down from the largest map by halves to the first whose error is larger than `target`, then by bisection: the smallest
/// resolution, up to the noise of where texels lie, above which no map that was tried is worse. From below it would not do: a map
/// too small to hold a shadow at all can be right by accident. Nothing where the largest map's error is still larger.
std::optional<int> equal_error_resolution(const std::function<double(int)>& error_at, double target,
                                          const ResolutionRange& range = {});

}  // namespace psm
