// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pixels.h"

#include <algorithm>
#include <cmath>

namespace psm {

Image filled(const glm::ivec2& size, const glm::vec4& color) {
  Image image{size.x, size.y, std::vector<std::uint8_t>(std::size_t(size.x) * size.y * 4)};
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = std::uint8_t(std::lround(color[int(i % 4)] * 255.0f));
  return image;
}

void fill(Image& image, glm::ivec2 min, glm::ivec2 max, const glm::vec3& color) {
  min = glm::max(min, glm::ivec2(0));
  max = glm::min(max, glm::ivec2(image.width, image.height));
  if (min.x < max.x && min.y < max.y) {
    const glm::ivec2 size = max - min;
    paste(filled(size, glm::vec4(color, 1.0f)), {0, size.x}, min, image);
  }
}

void paste(const Image& part, const glm::ivec2& columns, const glm::ivec2& origin, Image& whole) {
  for (int y = 0; y < part.height; ++y) {
    const auto row = part.rgba.begin() + std::ptrdiff_t(y) * part.width * 4;
    std::copy(row + columns.x * 4, row + columns.y * 4,
              whole.rgba.begin() + (std::ptrdiff_t(origin.y + y) * whole.width + origin.x + columns.x) * 4);
  }
}

}  // namespace psm
