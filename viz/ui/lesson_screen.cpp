// SPDX-License-Identifier: GPL-3.0-or-later
// A step of a lesson in front of a class, screen by screen.
#include <algorithm>
#include <cmath>

#include "ui/lesson_context.h"

namespace psm {
namespace {

constexpr double kLeading = 1.3;

double margin() { return std::ceil(ImGui::GetStyle().WindowPadding.x); }

}  // namespace

std::optional<std::vector<PartSize>> LessonPanel::part_sizes(const Context& c) {
  std::vector<PartSize> sizes;
  for (const Part& part : step_parts(c)) {
    if (part.too_wide) return std::nullopt;
    sizes.push_back({part.height, part.begins});
  }
  return sizes;
}

double LessonPanel::set_stage(UiContext& ui, const LessonSession& session, glm::ivec2 window, int height,
                              Experiment& experiment) {
  const auto measure = [&](double width, double size) {
    return part_sizes({ui, session, {}, experiment, {std::floor(width), size, kLeading}, true});
  };
  const double gap = ImGui::GetStyle().ItemSpacing.y, screen = height - 2.0 * margin();
  const std::string step = session.run()->lesson().name + "/" + std::to_string(session.run()->index());
  const StageKey key{step, window, height, ImGui::GetFontSize()};
  const bool same = key == stage_key_;
  if (same) {
    const auto parts = measure(stage_.column - 2.0 * margin(), stage_.size);
    if (!stage_.fits || (parts && stays_on_screens(*parts, stage_.begins, gap, screen))) return stage_.column;
  }
  stage_ = fit_stage(window, screen, margin(), gap, measure);
  const std::size_t last = stage_.begins.size() - 1;
  if (!same) screen_ = std::exchange(enters_at_end_, false) ? last : 0;
  screen_ = std::min(screen_, last);
  stage_key_ = key;
  return stage_.column;
}

bool LessonPanel::turn_screen(int by) {
  const std::ptrdiff_t to = std::ptrdiff_t(screen_) + by;
  if (to < 0 || to >= std::ptrdiff_t(stage_.begins.size())) return false;
  screen_ = std::size_t(to);
  return true;
}

std::vector<LessonCommand> LessonPanel::draw_stage(UiContext& ui, const LessonSession& session, const Rect& pane,
                                                   Experiment& experiment) {
  Context c{ui, session, pane, experiment, {std::floor(stage_.column - 2.0 * margin()), stage_.size, kLeading}, true};
  ui.places["lesson.pane"] = pane;
  ImGui::SetCursorScreenPos({float(pane.min.x), float(pane.min.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {float(margin()), float(margin())});
  ImGui::BeginChild("lesson screen", {float(std::max(1, pane.size().x)), float(std::max(1, pane.size().y))}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | (stage_.fits ? ImGuiWindowFlags_NoScrollbar : 0));
  ImGui::PopStyleVar();
  ImGui::SetWindowFontScale(1.0f);  // ImGui keeps it from frame to frame
  ImGui::SetWindowFontScale(float(stage_.size) / ImGui::GetFontSize());
  const Parts parts = step_parts(c);
  const std::size_t begin = stage_.begins[screen_];
  const std::size_t end = screen_ + 1 < stage_.begins.size() ? stage_.begins[screen_ + 1] : parts.size();
  ImVec2 at = ImGui::GetCursorScreenPos();
  open_question_.reset(), open_task_.reset();
  for (std::size_t i = begin; i < std::min(end, parts.size()); ++i) {
    if (!parts[i].draw) continue;  // the room that waits for it is left at the bottom
    ImGui::SetCursorScreenPos(at);
    parts[i].draw(c);
    if (!open_question_) open_question_ = parts[i].question;
    if (!open_task_) open_task_ = parts[i].task;
    const float bottom = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y;
    ui.places["lesson.part." + std::to_string(i)] = {{int(at.x), int(at.y)}, {pane.max.x, int(std::max(at.y, bottom))}};
    at.y += float(parts[i].height) + ImGui::GetStyle().ItemSpacing.y;
  }
  ImGui::EndChild();
  return std::move(c.commands);
}

}  // namespace psm
