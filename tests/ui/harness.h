// SPDX-License-Identifier: GPL-3.0-or-later
// The real frame loop without a window: a headless context, the workbench, and mouse and keys that arrive as events.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/headless_context.h"
#include "ui/host.h"

namespace psm::test {

/// A folder of its own for each test, removed with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

class Bench {
 public:
  explicit Bench(const std::string& source = "ground", const std::vector<std::string>& overrides = {},
                 glm::ivec2 size = {1024, 768}, const std::filesystem::path& lessons = {}, const std::string& lesson = "",
                 bool start_card = false);

  Workbench& work() { return *workbench_; }
  const Experiment& experiment() const { return workbench_->model().experiment(); }
  const Analysis& analysis() const { return workbench_->model().analysis(); }
  InputQueue& input() { return input_; }
  const std::filesystem::path& folder() const { return folder_.path(); }

  void resize(glm::ivec2 size);
  void frame(double seconds = 1.0 / 60.0);
  /// As the window does: frames until no event is left and nothing is to be drawn. Fails the test after 200.
  void settle();
  void pass_time(double seconds) { seconds_ += seconds; }

  // Each ends settled.
  void move(glm::dvec2 pixel);
  void press(glm::dvec2 pixel, int button = 0);
  void release(int button = 0);
  void click(glm::dvec2 pixel, int button = 0);
  void double_click(glm::dvec2 pixel);
  void drag(glm::dvec2 from, glm::dvec2 to, int button = 0, int steps = 4);
  void wheel(glm::dvec2 pixel, double steps);
  void key(int key, Modifiers modifiers = {});
  void type(const std::string& text);

  /// The middle of a widget (or this part of its width) by its name; fails the test if it is not on the screen. Scrolls the pane.
  glm::dvec2 at(const std::string& place, double part = 0.5);
  bool on_screen(const std::string& place) const { return work_places().count(place) > 0; }
  const Places& work_places() const { return workbench_->places(); }

  Image screen() { return host_->read_screen(); }
  Image view(ViewId id) { return workbench_->renderer().read_view(id); }

 private:
  std::optional<Rect> scroller_of(const Rect& widget) const;
  bool scroll_to(const std::string& place);

  ScratchFolder folder_;
  std::unique_ptr<HeadlessContext> context_;
  std::unique_ptr<Host> host_;
  std::unique_ptr<Workbench> workbench_;
  InputQueue input_;
  glm::ivec2 size_;
  double seconds_ = 0.0;
};

/// How many pixels differ by more than `tolerance` in any channel; all of them where the sizes differ.
std::size_t differing_pixels(const Image& a, const Image& b, int tolerance = 0);

}  // namespace psm::test
