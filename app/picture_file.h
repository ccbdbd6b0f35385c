// SPDX-License-Identifier: GPL-3.0-or-later
// Where pictures go: a file, or the numbered frames or the film of a sweep. Written whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/sheet.h"
#include "lesson/lesson.h"

namespace psm {

/// One number of the experiment, taken through a range.
struct PictureSweep {
  std::string asked_by;  // "--sweep": for messages
  std::string path;
  std::vector<double> values;
};

/// PATH=A:B:COUNT.
Result<std::optional<PictureSweep>> parse_sweep(const std::optional<std::string>& text);

/// A lesson's animation, frame by frame.
PictureSweep frames_of(const Animation& animation);

/// What is wrong with it as a target, before anything is drawn. `asked_by`: the flag, for the message.
std::optional<InputError> check_picture_name(const std::string& out, bool sweeps, const char* asked_by = "--out");

/// Draws and writes; an error where a value of the sweep is not allowed, or a file cannot be written. Needs a current OpenGL
/// context.
std::optional<InputError> write_pictures(SheetPainter& painter, const Sheet& sheet, const std::optional<PictureSweep>& sweep,
                                         const std::filesystem::path& out);

}  // namespace psm
