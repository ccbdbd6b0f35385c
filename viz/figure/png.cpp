// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure/png.h"

#include <string>

#include "scene/experiment_file.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace psm {
namespace {

void append(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), std::size_t(size));
}

}  // namespace

std::optional<InputError> write_png(const std::filesystem::path& file, int width, int height,
                                    std::span<const std::uint8_t> rgba) {
  const bool fits = width > 0 && height > 0 && rgba.size() == std::size_t(width) * std::size_t(height) * 4;
  std::string bytes;
  if (!fits || !stbi_write_png_to_func(append, &bytes, width, height, 4, rgba.data(), width * 4)) {
    return InputError{file.string() + ": a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                      " pixels cannot be written as PNG; allowed: at least 1x1, with 4 bytes a pixel"};
  }
  return write_file_atomically(file, bytes);
}

}  // namespace psm
