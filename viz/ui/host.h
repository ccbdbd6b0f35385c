// SPDX-License-Identifier: GPL-3.0-or-later
// Dear ImGui around the workbench: its context, its fonts, its OpenGL backend, and one frame from events to pixels.
#pragma once

#include <memory>

#include "gl/screen.h"
#include "ui/workbench.h"

struct ImGuiContext;

namespace psm {

/// Needs a current OpenGL context, which outlives it. One at a time.
class Host {
 public:
  explicit Host(Screen::Target target);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// One whole frame: takes events from `input`, lets the workbench draw, and composes everything on the screen. `size` in
  /// pixels.
  void frame(Workbench& workbench, InputQueue& input, glm::ivec2 size, double display_scale, double seconds_since_last);

  Image read_screen() const { return screen_.read(); }

 private:
  void update_look(const LookKey& look, const std::filesystem::path& font);
  Screen screen_;
  ImGuiContext* context_;
  LookKey look_;
};

}  // namespace psm
