// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of a sweep, or its film, picture by picture: whoever waits for them can do something else between two.
#pragma once

#include <filesystem>
#include <optional>

#include "app/film.h"
#include "app/picture_file.h"

namespace psm {

/// A folder beside the target, gone with this object.
class FrameFolder {
 public:
  explicit FrameFolder(const std::filesystem::path& out);
  ~FrameFolder();
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;

  std::filesystem::path path;
  std::error_code error;
};

/// Nothing stands at the target's name before the end, and nothing is left of one that is dropped before.
class SweepWriter {
 public:
  SweepWriter(Sheet sheet, PictureSweep sweep, std::filesystem::path out);

  /// Draws one picture, or gives them a moment to become a film. Needs a current OpenGL context.
  std::optional<InputError> step(SheetPainter& painter);
  bool done() const { return done_; }
  std::size_t drawn() const { return drawn_; }
  std::size_t count() const { return sweep_.values.size(); }

 private:
  std::filesystem::path frame_file(std::size_t index) const;
  std::optional<InputError> draw_next(SheetPainter& painter);
  std::optional<InputError> move_frames() const;

  Sheet sheet_;
  PictureSweep sweep_;
  std::filesystem::path out_;
  FrameFolder frames_;
  std::optional<FilmMaker> film_;  // ends before the folder goes
  std::size_t drawn_ = 0;
  bool done_ = false;
};

}  // namespace psm
