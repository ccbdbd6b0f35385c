// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture_file.h"

#include <algorithm>
#include <cmath>

#include "app/film.h"
#include "app/numbers.h"
#include "app/progress.h"
#include "app/sweep_writer.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

std::optional<InputError> write_sweep(SheetPainter& painter, const Sheet& sheet, const PictureSweep& sweep, const fs::path& out) {
  const Interruptible interruptible;  // the frames so far must not stay
  SweepWriter writer(sheet, sweep, out);
  while (!writer.done()) {
    if (Interruptible::asked()) return InputError{"interrupted: nothing is written"};
    if (auto error = writer.step(painter)) return error;
  }
  return std::nullopt;
}

}  // namespace

Result<std::optional<PictureSweep>> parse_sweep(const std::optional<std::string>& text) {
  if (!text) return std::optional<PictureSweep>();
  const std::size_t equals = text->find('=');
  const std::vector<std::string> parts = split(equals == std::string::npos ? "" : text->substr(equals + 1), ':');
  const auto first = number_from_text(parts[0]), last = number_from_text(parts.size() == 3 ? parts[1] : ""),
             count = number_from_text(parts.back());
  if (!first || !last || !count || !std::isfinite(*first) || !std::isfinite(*last) || !(*count >= 2 && *count <= 9999) ||
      std::trunc(*count) != *count)
    return flag_error("--sweep", *text, "PATH=A:B:COUNT, such as light.theta_deg=10:90:50, with COUNT in [2, 9999]");
  PictureSweep sweep{"--sweep", text->substr(0, equals), {}};
  for (int i = 0; i < int(*count); ++i) sweep.values.push_back(*first + (*last - *first) * i / (*count - 1));
  return std::optional(sweep);
}

PictureSweep frames_of(const Animation& animation) {
  PictureSweep sweep{"animation", animation.path, {}};
  const int last = std::max(1, int(std::lround(animation.seconds * kFramesPerSecond)));
  for (int i = 0; i <= last; ++i) sweep.values.push_back(animation.at(animation.seconds * i / last));
  return sweep;
}

std::optional<InputError> check_picture_name(const std::string& out, bool sweeps, const char* asked_by) {
  const fs::path path = out;
  const std::string extension = path.extension().string();
  const bool still = extension == ".png" || extension == ".svg" || extension == ".pdf";
  if (path.stem().empty() || !(still || (sweeps && is_film(path))))
    return flag_error(asked_by, out,
                      std::string("the name of a .png, .svg or .pdf file") + (sweeps ? ", or of a .mp4 or .gif" : ""));
  std::error_code error;
  if (!fs::is_directory(folder_of(path), error)) return flag_error(asked_by, out, "a file in an existing folder");
  if (!is_film(path)) return extension == ".pdf" ? pdf_missing() : std::nullopt;
  const auto missing = film_missing();
  return missing ? std::optional(InputError{std::string(asked_by) + ": " + missing->text}) : std::nullopt;
}

std::optional<InputError> write_pictures(SheetPainter& painter, const Sheet& sheet, const std::optional<PictureSweep>& sweep,
                                         const fs::path& out) {
  if (sweep) return write_sweep(painter, sheet, *sweep, out);
  const auto bytes = sheet_bytes(painter, sheet, out);
  return bytes ? write_file_atomically(out, *bytes) : bytes.error();
}

}  // namespace psm
