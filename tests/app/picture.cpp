// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.h"

#include <algorithm>
#include <cstdlib>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace psm::testing {

std::optional<Image> read_png(const std::filesystem::path& file) {
  int width = 0, height = 0, channels = 0;
  stbi_uc* pixels = stbi_load(file.c_str(), &width, &height, &channels, 4);
  if (!pixels) return std::nullopt;
  Image image{width, height, std::vector<std::uint8_t>(pixels, pixels + std::size_t(width) * height * 4)};
  stbi_image_free(pixels);
  return image;
}

bool shows_something(const Image& image, int x, int y, int width, int height) {
  int least = 255 * 3, most = 0;
  for (int j = y; j < y + height; ++j)
    for (int i = x; i < x + width; ++i) {
      const std::uint8_t* p = &image.rgba[(std::size_t(j) * image.width + i) * 4];
      const int sum = p[0] + p[1] + p[2];
      least = std::min(least, sum), most = std::max(most, sum);
    }
  return most - least > 60;
}

Difference difference(const Image& a, const Image& b, int ignored) {
  Difference result{0, 0.0, a};
  std::size_t different = 0;
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    int largest = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i) {
      const int delta = std::abs(int(a.rgba[i]) - int(b.rgba[i]));
      largest = std::max(largest, delta);
      result.image.rgba[i] = std::uint8_t(std::min(255, 8 * delta));
    }
    result.image.rgba[pixel + 3] = 255;
    result.largest = std::max(result.largest, largest);
    if (largest > ignored) ++different;
  }
  result.fraction = double(different) / std::max<std::size_t>(1, a.rgba.size() / 4);
  return result;
}

}  // namespace psm::testing
