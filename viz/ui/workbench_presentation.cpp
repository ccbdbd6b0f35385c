// SPDX-License-Identifier: GPL-3.0-or-later
// In front of a class: large type, nothing but the views and the light case, a clicker's keys.
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/workbench.h"

namespace psm {
namespace {

constexpr double kLeastScale = 1.8;       // of line widths
constexpr double kLinesPerScale = 540.0;  // on a screen of 1080 lines type of 36 px, with capitals of 22

}  // namespace

double presenting_scale(glm::ivec2 window, double scale) { return std::max({scale, kLeastScale, window.y / kLinesPerScale}); }

void Workbench::present(bool on) {
  presenting_ = on;
  black_ = false;
  wake();
}

// A key that has its meaning only here, or gets the picture back after a black screen.
bool Workbench::take_presenting_key(const KeyPress& press) {
  if (!presenting_) return false;
  if (std::exchange(black_, false)) return true;
  if (press.key != key::escape) return false;
  present(false);
  return true;
}

void Workbench::step_screen(int step) {
  if (step_lesson(step) || !presenting_) return;
  Experiment edited = model_.experiment();
  std::vector<std::optional<ViewId>> screens{std::nullopt};
  screens.insert(screens.end(), edited.view.tiles.begin(), edited.view.tiles.end());
  const auto now = std::find(screens.begin(), screens.end(), edited.view.maximised);
  const int count = int(screens.size()), at = now == screens.end() ? 0 : int(now - screens.begin());
  maximise(screens[std::size_t((at + step + count) % count)]);
}

// Over everything, so that the class looks at the lecturer.
void Workbench::draw_black(glm::ivec2 size) const {
  if (!black_) return;
  ImGui::GetForegroundDrawList()->AddRectFilled({0.0f, 0.0f}, {float(size.x), float(size.y)}, IM_COL32_BLACK);
}

}  // namespace psm
