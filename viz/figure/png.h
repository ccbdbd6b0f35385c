// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "draw/image.h"
#include "scene/result.h"

namespace psm {

/// `rgba`: 8 bit, rows top to bottom, width * height * 4 bytes. Written whole or not at all.
std::optional<InputError> write_png(const std::filesystem::path& file, int width, int height, std::span<const std::uint8_t> rgba);

/// At least 1x1. `parameters`: what the picture was made from, as a tEXt chunk "psmlab"; "" for none.
std::string png_bytes(const Image& image, const std::string& parameters = "");

}  // namespace psm
