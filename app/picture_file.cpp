// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "app/film.h"
#include "app/numbers.h"
#include "app/progress.h"
#include "scene/control.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// A folder beside the target, gone with this object.
class FrameFolder {
 public:
  explicit FrameFolder(const fs::path& out) {
    std::random_device random;
    char name[32];
    std::snprintf(name, sizeof name, ".psmlab-%08x.tmp", random());
    path = folder_of(out) / name;
    fs::create_directory(path, error);
  }
  ~FrameFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;

  fs::path path;
  std::error_code error;
};

std::string numbered(const std::string& stem, std::size_t index, const std::string& extension) {
  char number[16];
  std::snprintf(number, sizeof number, "_%04zu", index + 1);
  return stem + number + extension;
}

/// The sheet with the control at this value in every experiment; experiments that were the same stay the same.
Result<Sheet> sheet_at(const Sheet& sheet, const PictureSweep& sweep, double value) {
  Sheet changed = sheet;
  std::map<const LoadedExperiment*, std::shared_ptr<const LoadedExperiment>> moved;
  for (SheetPanel& panel : changed.panels) {
    auto& target = moved[panel.loaded.get()];
    if (!target) {
      const auto copy = std::make_shared<LoadedExperiment>(*panel.loaded);
      const auto control = find_control(sweep.path, copy->experiment);
      if (!control) return InputError{sweep.asked_by + " " + control.error().text};
      if (const auto error = (*control)(copy->experiment, value)) return InputError{sweep.asked_by + " " + error->text};
      target = copy;
    }
    panel.loaded = target;
  }
  return changed;
}

std::optional<InputError> write_frames(SheetPainter& painter, const Sheet& sheet, const PictureSweep& sweep,
                                       const fs::path& folder, const std::string& extension) {
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    if (Interruptible::asked()) return InputError{"interrupted: nothing is written"};
    const auto frame = sheet_at(sheet, sweep, sweep.values[i]);
    if (!frame) return frame.error();
    const fs::path file = folder / numbered("frame", i, extension);
    const auto bytes = sheet_bytes(painter, *frame, file);
    if (!bytes) return bytes.error();
    if (auto error = write_file_atomically(file, *bytes)) return error;
  }
  return std::nullopt;
}

/// The frames to their names, all of them after all were drawn.
std::optional<InputError> move_frames(const fs::path& folder, std::size_t count, const fs::path& out) {
  const std::string extension = out.extension().string();
  for (std::size_t i = 0; i < count; ++i) {
    const fs::path name = folder_of(out) / numbered(out.stem().string(), i, extension);
    std::error_code error;
    fs::rename(folder / numbered("frame", i, extension), name, error);
    if (error) return InputError{name.string() + ": cannot be written: " + error.message()};
  }
  return std::nullopt;
}

std::optional<InputError> write_sweep(SheetPainter& painter, const Sheet& sheet, const PictureSweep& sweep, const fs::path& out) {
  const Interruptible interruptible;  // the frames so far must not stay
  const FrameFolder frames(out);
  if (frames.error)
    return InputError{out.string() + ": cannot be written: " + frames.error.message() +
                      "; allowed: a folder that may be written to"};
  if (auto error = write_frames(painter, sheet, sweep, frames.path, is_film(out) ? ".png" : out.extension().string()))
    return error;
  return is_film(out) ? write_film(frames.path, out) : move_frames(frames.path, sweep.values.size(), out);
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
