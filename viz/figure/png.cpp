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

std::string big_endian(std::uint32_t value) {
  return {char(value >> 24 & 255), char(value >> 16 & 255), char(value >> 8 & 255), char(value & 255)};
}

std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

/// Length, kind, data, checksum of kind and data.
std::string chunk(const std::string& kind, const std::string& data) {
  return big_endian(std::uint32_t(data.size())) + kind + data + big_endian(crc_of(kind + data));
}

}  // namespace

std::string png_bytes(const Image& image, const std::string& parameters) {
  std::string bytes;
  stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(), image.width * 4);
  constexpr std::size_t kHeader = 8 + 25;  // signature and IHDR
  if (!parameters.empty() && bytes.size() > kHeader)
    bytes.insert(kHeader, chunk("tEXt", "psmlab" + std::string(1, '\0') + parameters));
  return bytes;
}

std::optional<InputError> write_png(const std::filesystem::path& file, int width, int height,
                                    std::span<const std::uint8_t> rgba) {
  const bool fits = width > 0 && height > 0 && rgba.size() == std::size_t(width) * std::size_t(height) * 4;
  std::string bytes;
  if (fits) bytes = png_bytes({width, height, {rgba.begin(), rgba.end()}});
  if (bytes.empty()) {
    return InputError{file.string() + ": a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                      " pixels cannot be written as PNG; allowed: at least 1x1, with 4 bytes a pixel"};
  }
  return write_file_atomically(file, bytes);
}

}  // namespace psm
