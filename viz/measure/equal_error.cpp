// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/equal_error.h"

#include <algorithm>
#include <cmath>

namespace psm {

std::optional<int> equal_error_resolution(const std::function<double(int)>& error_at, double target,
                                          const ResolutionRange& range) {
  if (!(error_at(range.largest) <= target)) return std::nullopt;
  int too_small = range.largest, enough = range.largest;
  while (too_small == enough) {
    too_small = std::max(enough / 2, range.smallest);
    if (error_at(too_small) <= target) enough = too_small;
    if (enough == range.smallest) return enough;
  }
  while (enough - too_small > std::max(1.0, range.step * too_small)) {
    // Halving the ratio, not the difference: errors fall with the ratio of resolutions.
    const int middle = std::clamp(int(std::lround(std::sqrt(double(too_small) * enough))), too_small + 1, enough - 1);
    (error_at(middle) <= target ? enough : too_small) = middle;
  }
  return enough;
}

}  // namespace psm
