// SPDX-License-Identifier: GPL-3.0-or-later
// In front of a class: large type, nothing but the views and one line of text, or a lesson screen by screen; a clicker's keys.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "draw/view.h"
#include "ui/badge_bar.h"
#include "ui/workbench.h"
#include "ui/workbench_frame.h"

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

/// A step of a lesson is on the screen, not the list of lessons.
bool Workbench::stages_lesson() const {
  return presenting_ && lessons_.run() && settings_.layout.lesson_shown && !lesson_panel_.lists();
}

LayoutSettings Workbench::shown_layout(UiContext& ui, glm::ivec2 size) {
  LayoutSettings layout = settings_.layout;
  layout.pane_shown = layout.pane_shown && !presenting_;
  if (!stages_lesson()) return layout;
  layout.column = layout.row = LayoutSettings().row;
  Experiment untouched = model_.experiment();
  layout.lesson = lesson_panel_.set_stage(ui, lessons_, size, size.y - bar_height(size), untouched) / size.x;
  return layout;
}

int Workbench::bar_height(glm::ivec2 size) const {
  if (stages_lesson()) return int(std::ceil(1.75 * least_stage_type(size.y)));
  return presenting_ ? badge_line_height() : badge_bar_height(size.x);
}

/// What the bar says of a lesson: its title, the light case, the step, and the screen where the step has several.
void Workbench::lesson_line(Frame& f) {
  const LessonRun& run = *lessons_.run();
  const Rect& bar = f.layout.badges;
  const std::string title = numbered_title(run.lesson().name, run.lesson().title);
  const std::size_t screens = lesson_panel_.stage().begins.size();
  std::string step = "step " + std::to_string(run.index() + 1) + " of " + std::to_string(run.lesson().steps.size());
  if (screens > 1) step += "   " + std::to_string(lesson_panel_.screen() + 1) + "/" + std::to_string(screens);
  Badge light = badges(model_, views_ms_, "", settings_.theme).front();
  light.text = short_light_case_text(model_.analysis());
  ImFont* font = ImGui::GetFont();
  const float size = float(least_stage_type(f.size.y)), edge = size, room = float(bar.size().x) - 2.0f * edge;
  const auto width_of = [&](const std::string& text, float px) { return font->CalcTextSizeA(px, 1e9f, 0.0f, text.c_str()).x; };
  const float px = std::min(size, size * room / (width_of(title, size) + size + width_of(step, size)));
  const auto write = [&](float x, const std::string& text, const std::string& place) {
    const float y = float(bar.min.y) + std::floor(0.5f * (float(bar.size().y) - px));
    ImGui::GetWindowDrawList()->AddText(font, px, {std::floor(x), y}, text_color(), text.c_str());
    places_[place] = {{int(x), int(y)}, {int(std::ceil(x + width_of(text, px))), int(std::ceil(y + px))}};
  };
  write(float(bar.min.x) + edge, title, "bar.title");
  write(float(bar.max.x) - edge - width_of(step, px), step, "bar.step");
  const Rect between{{places_["bar.title"].max.x, bar.min.y}, {places_["bar.step"].min.x, bar.max.y}};
  if (width_of(light.text, px) + 4.0f * px < float(between.size().x))
    badge_bar(f.ui, {light}, {between.min + glm::ivec2(int(px), 0), between.max});
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

/// Within a step: forwards an open question's answer comes before what follows it, so that a clicker alone uncovers the views.
bool Workbench::step_stage(int by) {
  if (by > 0 && lesson_panel_.open_question()) return show_answer(), true;
  if (lesson_panel_.turn_screen(by)) return wake(), true;
  return false;
}

/// What the class is asked on this screen: the answer, or else the task's next hint and in the end its solution.
void Workbench::show_answer() {
  using Kind = LessonCommand::Kind;
  if (!stages_lesson()) return;
  if (const auto question = lesson_panel_.open_question())
    return lesson_commands_.push_back({Kind::show_answer, *question, "", 0, 0});
  const auto task = lesson_panel_.open_task();
  if (!task) return;
  const bool hints = lessons_.run()->state().tasks[*task].hints < lessons_.run()->step().tasks[*task].hints.size();
  lesson_commands_.push_back({hints ? Kind::hint : Kind::solve, *task, "", 0, 0.0});
}

// Over everything, so that the class looks at the lecturer.
void Workbench::draw_black(glm::ivec2 size) const {
  if (!black_) return;
  ImGui::GetForegroundDrawList()->AddRectFilled({0.0f, 0.0f}, {float(size.x), float(size.y)}, IM_COL32_BLACK);
}

}  // namespace psm
