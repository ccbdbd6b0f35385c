// SPDX-License-Identifier: GPL-3.0-or-later
// Images in and out. The only file of this folder that knows stb; its functions are private to this file, so that they do not
// meet those that tinygltf or other folders link.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wshadow"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <limits>

#include "scene/gltf_reader.h"

namespace psm::gltf {
namespace {

constexpr std::size_t kLargestImageFile = std::size_t(1) << 30;
constexpr std::uint64_t kMostPixels = std::uint64_t(1) << 26;  // 8192 x 8192
constexpr std::uint64_t kMostPixelsPerByte = 16384;            // beyond what deflate and JPEG reach: the header lies

void append_bytes(void* bytes, void* data, int size) {
  const auto* first = static_cast<const std::uint8_t*>(data);
  static_cast<Bytes*>(bytes)->insert(static_cast<Bytes*>(bytes)->end(), first, first + size);
}

}  // namespace

std::optional<ImageSize> image_size(const std::uint8_t* bytes, std::size_t size, std::string& reason) {
  ImageSize image;
  int channels = 0;
  if (size > kLargestImageFile || !stbi_info_from_memory(bytes, int(size), &image.width, &image.height, &channels)) {
    reason = "it is neither PNG nor JPEG";
    return std::nullopt;
  }
  const std::uint64_t pixels = std::uint64_t(image.width) * std::uint64_t(image.height);
  if (pixels == 0 || pixels > kMostPixels || pixels > kMostPixelsPerByte * size) {
    reason =
        "it says " + std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels, which is more than is read";
    return std::nullopt;
  }
  return image;
}

std::optional<std::vector<std::uint8_t>> decode_image(const std::uint8_t* bytes, std::size_t size, std::string& reason) {
  const auto expected = image_size(bytes, size, reason);
  if (!expected) return std::nullopt;
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(stbi_load_from_memory(bytes, int(size), &width, &height, &channels, 4),
                                                         stbi_image_free);
  if (!pixels || width != expected->width || height != expected->height) {
    reason = "it does not decode";
    return std::nullopt;
  }
  return std::vector<std::uint8_t>(pixels.get(), pixels.get() + std::size_t(width) * std::size_t(height) * 4);
}

Bytes encode_png(const Texture& texture) {
  Bytes bytes;
  stbi_write_png_to_func(append_bytes, &bytes, texture.width, texture.height, 4, texture.rgba.data(), texture.width * 4);
  return bytes;
}

}  // namespace psm::gltf
