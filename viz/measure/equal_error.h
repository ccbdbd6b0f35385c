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

/// By bisection: the end of an interval at whose upper end the error is at most `target`, and at whose lower end it is not. That
/// is the smallest such resolution where the error falls with resolution; it does so but for the noise of where texels lie.
/// Nothing where the largest map's error is still larger.
std::optional<int> equal_error_resolution(const std::function<double(int)>& error_at, double target,
                                          const ResolutionRange& range = {});

}  // namespace psm
