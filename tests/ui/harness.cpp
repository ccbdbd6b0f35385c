// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness.h"

#include <unistd.h>

#include <cstdlib>

#include "app/assets.h"
#include "app/window_picture.h"
#include "figure/png.h"

namespace psm::test {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "psmlab-ui-XXXXXX").string();
  if (mkdtemp(name.data())) path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

Bench::Bench(const std::string& source, const std::vector<std::string>& overrides, glm::ivec2 size,
             const std::filesystem::path& lessons, const std::string& lesson, bool start_card)
    : size_(size) {
  auto context = HeadlessContext::create();
  EXPECT_TRUE(context) << context.error().text;
  context_ = std::move(*context);
  host_ = std::make_unique<Host>(Screen::Target::texture);
  auto loaded = load_experiment(source, overrides);
  EXPECT_TRUE(loaded) << loaded.error().text;
  WorkbenchOptions options;
  options.assets = assets_folder();
  options.font = font_file();
  options.settings = folder_.path() / "config" / "settings.txt";
  options.lessons = lessons;
  options.lesson = lesson;
  options.start_card = start_card;
  options.pictures = folder_.path();
  options.write_picture = [](const std::filesystem::path& file, const Image& image) {
    return write_png(file, image.width, image.height, image.rgba);
  };
  options.write_views = shown_views_writer;
  workbench_ = std::make_unique<Workbench>(*loaded, options);
  settle();
}

void Bench::resize(glm::ivec2 size) {
  size_ = size;
  workbench_->wake();
  settle();
}

void Bench::frame(double seconds) {
  host_->frame(*workbench_, input_, size_, 1.0, seconds + seconds_);
  seconds_ = 0.0;
}

void Bench::settle() {
  int left = 200;
  if (!input_.empty()) workbench_->wake();
  while ((workbench_->needs_redraw() || !input_.empty()) && --left > 0) frame();
  ASSERT_GT(left, 0) << "the window never comes to rest";
}

void Bench::move(glm::dvec2 pixel) {
  input_.mouse_move(pixel);
  settle();
}
void Bench::press(glm::dvec2 pixel, int button) {
  move(pixel);
  input_.mouse_button(button, true);
  settle();
}
void Bench::release(int button) {
  input_.mouse_button(button, false);
  settle();
}
void Bench::click(glm::dvec2 pixel, int button) {
  pass_time(2.0);  // never taken for the second half of a double click
  press(pixel, button);
  release(button);
}
void Bench::double_click(glm::dvec2 pixel) {
  click(pixel);
  press(pixel);
  release();
}
void Bench::drag(glm::dvec2 from, glm::dvec2 to, int button, int steps) {
  pass_time(2.0);
  press(from, button);
  for (int i = 1; i <= steps; ++i) move(from + (to - from) * (double(i) / steps));
  release(button);
}
void Bench::wheel(glm::dvec2 pixel, double steps) {
  move(pixel);
  input_.wheel({0.0, steps});
  settle();
}

void Bench::key(int code, Modifiers modifiers) {
  const auto each = [&](bool down) {
    if (modifiers.control) input_.key(psm::key::control, down);
    if (modifiers.shift) input_.key(psm::key::shift, down);
    if (modifiers.alt) input_.key(psm::key::alt, down);
  };
  each(true);
  input_.key(code, true);
  input_.key(code, false);
  each(false);
  settle();
}

void Bench::type(const std::string& text) {
  for (char c : text) input_.text(static_cast<unsigned char>(c));
  settle();
}

/// The part that scrolls and has this widget: of the control pane, or of the lesson's.
std::optional<Rect> Bench::scroller_of(const Rect& widget) const {
  for (const char* name : {"pane.fields", "lesson.text"})
    if (const auto pane = work_places().find(name); pane != work_places().end())
      if (widget.min.x >= pane->second.min.x && widget.min.x < pane->second.max.x) return pane->second;
  return std::nullopt;
}

/// The wheel over the pane until the widget is inside it.
bool Bench::scroll_to(const std::string& place) {
  const auto found = work_places().find(place);
  const auto pane = found == work_places().end() ? std::nullopt : scroller_of(found->second);
  if (!pane) return false;
  const Rect window = *pane;
  for (int tries = 0; tries < 300; ++tries) {
    const Rect rect = work_places().at(place);
    if (rect.min.y >= window.min.y && rect.max.y <= window.max.y) return true;
    wheel(glm::dvec2(window.max.x - 3, window.max.y - 3), rect.min.y < window.min.y ? 0.5 : -0.5);
    if (work_places().count(place) == 0 || work_places().at(place).min == rect.min) return false;  // it does not scroll
  }
  return false;
}

glm::dvec2 Bench::at(const std::string& place, double part) {
  const bool scrolls = place.find('=') == std::string::npos && place.rfind("dialog", 0) != 0 && place.rfind("badge", 0) != 0 &&
                       place.rfind("splitter", 0) != 0 && place != "scene.source";
  if (scrolls) scroll_to(place);
  const auto found = work_places().find(place);
  EXPECT_NE(found, work_places().end()) << place << " is not on the screen";
  if (found == work_places().end()) return {-1.0, -1.0};
  const Rect& r = found->second;
  return {r.min.x + part * (r.max.x - r.min.x), 0.5 * (r.min.y + r.max.y)};
}

std::size_t differing_pixels(const Image& a, const Image& b, int tolerance) {
  if (a.width != b.width || a.height != b.height) return std::max(a.rgba.size(), b.rgba.size()) / 4;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t k = 0; k < 4; ++k) most = std::max(most, std::abs(int(a.rgba[i + k]) - int(b.rgba[i + k])));
    count += most > tolerance;
  }
  return count;
}

}  // namespace psm::test
