// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_picture.h"

#include "app/film.h"
#include "app/numbers.h"
#include "app/picture_file.h"
#include "app/render.h"
#include "app/sweep_writer.h"

namespace psm {
namespace {

class StillWriter : public ViewsWriter {
 public:
  StillWriter(Sheet sheet, std::filesystem::path file) : sheet_(std::move(sheet)), file_(std::move(file)) {}
  std::optional<InputError> step() override {
    done_ = true;
    SheetPainter painter;
    return write_pictures(painter, sheet_, std::nullopt, file_);
  }
  bool done() const override { return done_; }
  Progress progress() const override { return {}; }

 private:
  Sheet sheet_;
  std::filesystem::path file_;
  bool done_ = false;
};

class FilmWriter : public ViewsWriter {
 public:
  FilmWriter(Sheet sheet, const Animation& animation, const std::filesystem::path& file)
      : writer_(std::move(sheet), frames_of(animation), file) {}
  std::optional<InputError> step() override { return writer_.step(painter_); }
  bool done() const override { return writer_.done(); }
  Progress progress() const override {
    if (writer_.drawn() == writer_.count()) return {1.0, "ffmpeg makes a film of them"};
    return {double(writer_.drawn()) / double(writer_.count()),
            "picture " + std::to_string(writer_.drawn() + 1) + " of " + std::to_string(writer_.count())};
  }

 private:
  SheetPainter painter_;
  SweepWriter writer_;
};

}  // namespace

Result<std::unique_ptr<ViewsWriter>> shown_views_writer(const std::filesystem::path& file, const ShownViews& shown) {
  const bool plays = is_film(file);
  if (plays && !shown.animation)
    return flag_error("name", file.string(), "a film in a lesson's step that has an animation; .png, .svg or .pdf everywhere");
  if (auto error = check_picture_name(file.string(), plays, "name")) return *error;
  RenderRequest request{shown.views, shown.size, shown.scale, shown.theme, false, shown.emphasis};
  Sheet sheet = sheet_of(shown.loaded, request, {shown.places, 0});
  std::unique_ptr<ViewsWriter> writer;
  if (plays)
    writer = std::make_unique<FilmWriter>(std::move(sheet), *shown.animation, file);
  else
    writer = std::make_unique<StillWriter>(std::move(sheet), file);
  return writer;
}

}  // namespace psm
