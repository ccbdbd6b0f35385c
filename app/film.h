// SPDX-License-Identifier: GPL-3.0-or-later
// Films from numbered frames, by ffmpeg where it is installed.
#pragma once

#include <filesystem>
#include <optional>

#include "scene/result.h"

namespace psm {

constexpr int kFramesPerSecond = 25;

/// Whether the name's ending is a film's: .mp4 or .gif.
bool is_film(const std::filesystem::path& file);

/// One line where there is no ffmpeg on the PATH.
std::optional<InputError> film_missing();

/// `frames`: a folder with frame_0001.png and so on. `film`: .mp4 or .gif; written whole or not at all.
std::optional<InputError> write_film(const std::filesystem::path& frames, const std::filesystem::path& film);

}  // namespace psm
