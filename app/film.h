// SPDX-License-Identifier: GPL-3.0-or-later
// Films from numbered frames, by ffmpeg where it is installed.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include "scene/result.h"

namespace psm {

constexpr int kFramesPerSecond = 25;

/// Whether the name's ending is a film's: .mp4 or .gif.
bool is_film(const std::filesystem::path& file);

/// One line where there is no ffmpeg on the PATH.
std::optional<InputError> film_missing();

/// ffmpeg at work beside this program. One that is dropped before its end leaves no film.
class FilmMaker {
 public:
  /// `frames`: a folder with frame_0001.png and so on. `film`: .mp4 or .gif; written whole or not at all.
  FilmMaker(const std::filesystem::path& frames, const std::filesystem::path& film);
  ~FilmMaker();
  FilmMaker(const FilmMaker&) = delete;
  FilmMaker& operator=(const FilmMaker&) = delete;

  /// Whether it has ended, by this time at the latest from now.
  bool ended_within(std::chrono::milliseconds time);
  /// After its end: the film is at its place, or why it is not.
  std::optional<InputError> finish();

 private:
  std::filesystem::path finished_, film_;
  pid_t child_ = 0;  // 0: there is none, or none any more
  int status_ = -1;  // the exit status; -1: it has none
};

}  // namespace psm
