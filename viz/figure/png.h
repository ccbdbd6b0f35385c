// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "scene/result.h"

namespace psm {

/// `rgba`: 8 bit, rows top to bottom, width * height * 4 bytes. Written whole or not at all.
std::optional<InputError> write_png(const std::filesystem::path& file, int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace psm
