// SPDX-License-Identifier: GPL-3.0-or-later
// PNG files read back, and compared.
#pragma once

#include <filesystem>
#include <optional>

#include "gl/renderer.h"

namespace psm::testing {

std::optional<Image> read_png(const std::filesystem::path& file);

/// True where at least two pixels of the rectangle differ by more than a trace.
bool shows_something(const Image& image, int x, int y, int width, int height);

struct Difference {
  int largest = 0;        // of any channel of any pixel
  double fraction = 0.0;  // of the pixels: those that differ by more than `ignored` in some channel
  Image image;            // black where equal, brighter where not
};

/// Of two pictures of one size.
Difference difference(const Image& a, const Image& b, int ignored);

}  // namespace psm::testing
