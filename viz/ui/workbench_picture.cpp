// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of what is on the screen: the views into a file of a name that is asked for (key P), or the screen itself (F12).
#include <algorithm>

#include "ui/workbench.h"
#include "ui/workbench_frame.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

Rect around(const Rect& a, const Rect& b) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

}  // namespace

/// The first name in the pictures' folder that no file has.
fs::path Workbench::free_picture_name(const std::string& ending) const {
  const std::string stem = "psmlab-" + fs::path(model_.experiment().scene.source).stem().string() + "-";
  fs::path file;
  std::error_code ignored;
  for (int i = 1; file.empty() || fs::exists(file, ignored); ++i)
    file = (options_.pictures / (stem + std::to_string(i) + ending)).lexically_normal();
  return file;
}

void Workbench::ask_for_picture() { dialogs_.show(Dialogs::Kind::picture, free_picture_name(picture_ending_).string()); }

/// Views that a question covers stay out of it.
ShownViews Workbench::shown_views(const Frame& f) {
  ShownViews out{model_.loaded(), {}, {}, {0, 0}, f.scale, settings_.theme, {}, std::nullopt};
  out.loaded.experiment.view = fitted_.shown(model_, f.view_sizes());
  Rect whole;
  for (const ViewId id : kAllViews) {
    const Rect place = around(f.layout.view(id), f.second[std::size_t(id)]);
    if (place.empty() || is_covered(id)) continue;
    out.views.push_back(id);
    out.places.push_back(place);
    whole = around(whole, place);
  }
  for (Rect& place : out.places) place = {place.min - whole.min, place.max - whole.min};
  out.size = whole.size();
  if (!settings_.layout.lesson_shown || !lessons_.run()) return out;
  out.emphasis = lessons_.emphasis();
  out.animation = lessons_.run()->step().animation;
  return out;
}

void Workbench::save_views(const Frame& f, const std::string& file) {
  if (!options_.write_views) return;
  const ShownViews shown = shown_views(f);
  if (shown.views.empty()) return dialogs_.show_error("no view is uncovered", Dialogs::Kind::picture, file);
  auto writer = options_.write_views(file, shown);
  if (!writer) return dialogs_.show_error(writer.error().text, Dialogs::Kind::picture, file);
  writer_ = std::move(*writer);
  written_file_ = file;
  write_on();
}

/// A moment of what is being written, if anything is.
void Workbench::write_on() {
  if (!writer_) return;
  wake();
  if (const auto error = writer_->step()) {
    writer_.reset();
    return dialogs_.show_error(error->text, Dialogs::Kind::picture, written_file_);
  }
  const ViewsWriter::Progress now = writer_->progress();
  if (!writer_->done()) return dialogs_.show_progress(now.part, now.text + ", for " + written_file_);
  writer_.reset();
  if (dialogs_.shown() == Dialogs::Kind::progress) dialogs_.close();
  picture_ending_ = fs::path(written_file_).extension().string();
  picture_saved(written_file_);
}

/// Somebody closed the pop-up that shows how far it is.
void Workbench::give_up_writing() {
  writer_.reset();
  message_ = "given up: nothing was written";
}

// A view that is alone is saved by itself; several come with everything around them.
void Workbench::save_screen() {
  const auto alone = model_.experiment().view.maximised;
  if (alone && images_.texture(*alone) != 0)
    write_screen(renderer_.read_view(*alone));
  else
    wants_screen_ = true;
}

void Workbench::take_screen(const Image& image) {
  wants_screen_ = false;
  write_screen(image);
  wake();
}

void Workbench::write_screen(const Image& image) {
  if (!options_.write_picture) return;
  const fs::path file = free_picture_name(".png");
  if (const auto error = options_.write_picture(file, image)) return dialogs_.show(Dialogs::Kind::error, error->text);
  picture_saved(file);
}

void Workbench::picture_saved(const fs::path& file) {
  std::error_code ignored;
  last_picture_ = fs::absolute(file, ignored).lexically_normal();
  message_ = "picture saved: " + last_picture_.string();
}

}  // namespace psm
