// SPDX-License-Identifier: GPL-3.0-or-later
// Where pictures go: a file, or the numbered frames or the film of a sweep. Written whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/sheet.h"

namespace psm {

/// One number of the experiment, taken through a range.
struct PictureSweep {
  std::string path;
  std::vector<double> values;
};

/// PATH=A:B:COUNT.
Result<std::optional<PictureSweep>> parse_sweep(const std::optional<std::string>& text);

/// What is wrong with it as a target, before anything is drawn.
std::optional<InputError> check_picture_name(const std::string& out, bool sweeps);

/// Draws and writes; an error where a value of the sweep is not allowed, or a file cannot be written. Needs a current OpenGL
/// context.
std::optional<InputError> write_pictures(SheetPainter& painter, const Sheet& sheet, const std::optional<PictureSweep>& sweep,
                                         const std::filesystem::path& out);

}  // namespace psm
