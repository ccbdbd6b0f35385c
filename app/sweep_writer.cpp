// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep_writer.h"

#include <cstdio>
#include <map>
#include <random>

#include "scene/control.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kMoment(20);

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

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

}  // namespace

FrameFolder::FrameFolder(const fs::path& out) {
  std::random_device random;
  char name[32];
  std::snprintf(name, sizeof name, ".psmlab-%08x.tmp", random());
  path = folder_of(out) / name;
  fs::create_directory(path, error);
}

FrameFolder::~FrameFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

SweepWriter::SweepWriter(Sheet sheet, PictureSweep sweep, fs::path out)
    : sheet_(std::move(sheet)), sweep_(std::move(sweep)), out_(std::move(out)), frames_(out_) {}

std::optional<InputError> SweepWriter::step(SheetPainter& painter) {
  if (frames_.error)
    return InputError{out_.string() + ": cannot be written: " + frames_.error.message() +
                      "; allowed: a folder that may be written to"};
  if (drawn_ < count()) return draw_next(painter);
  if (!is_film(out_)) return done_ = true, move_frames();
  if (!film_) film_.emplace(frames_.path, out_);
  if (!film_->ended_within(kMoment)) return std::nullopt;
  return done_ = true, film_->finish();
}

fs::path SweepWriter::frame_file(std::size_t index) const {
  return frames_.path / numbered("frame", index, is_film(out_) ? ".png" : out_.extension().string());
}

std::optional<InputError> SweepWriter::draw_next(SheetPainter& painter) {
  const auto frame = sheet_at(sheet_, sweep_, sweep_.values[drawn_]);
  if (!frame) return frame.error();
  const fs::path file = frame_file(drawn_++);
  const auto bytes = sheet_bytes(painter, *frame, file);
  return bytes ? write_file_atomically(file, *bytes) : bytes.error();
}

/// The frames to their names, all of them after all were drawn.
std::optional<InputError> SweepWriter::move_frames() const {
  for (std::size_t i = 0; i < count(); ++i) {
    const fs::path name = folder_of(out_) / numbered(out_.stem().string(), i, out_.extension().string());
    std::error_code error;
    fs::rename(frame_file(i), name, error);
    if (error) return InputError{name.string() + ": cannot be written: " + error.message()};
  }
  return std::nullopt;
}

}  // namespace psm
