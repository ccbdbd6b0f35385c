// SPDX-License-Identifier: GPL-3.0-or-later
// A picture made of pixels.
#pragma once

#include <cstdint>
#include <vector>

namespace psm {

/// 8-bit RGBA, rows top to bottom.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace psm
