// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/quiz_panel.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "scene/eye_and_light.h"
#include "ui/theme.h"

namespace psm {
namespace {

/// The plane that holds the view direction and the light: depth to the right, distance from the line of sight upwards.
class SideView {
 public:
  SideView(const UiContext& ui, glm::dvec2 min, glm::dvec2 size)
      : ui_(ui), min_(min), size_(size), middle_(min + 0.5 * size), list_(ImGui::GetWindowDrawList()) {}

  void draw(const Experiment& e, const LightSettings& light, bool reveal) const {
    const ViewFrame view = camera_frame(e);
    const glm::dvec4 l = homogeneous_light(light);
    const glm::dvec3 from_eye = glm::dvec3(l) - l.w * view.eye;
    const double depth = glm::dot(view.forward, from_eye), across = glm::length(from_eye - depth * view.forward);
    const glm::dvec2 way = glm::normalize(glm::dvec2(depth, across));
    list_->PushClipRect(vec(min_), vec(min_ + size_), true);
    list_->AddRectFilled(vec(min_), vec(min_ + size_), color(ground_color(ui_.theme)));
    frustum(view);
    if (reveal) camera_plane();
    if (l.w == 0.0)
      sun(way);
    else
      lamp(way * 0.42 * std::min(size_.x, size_.y));
    list_->PopClipRect();
    list_->AddRect(vec(min_), vec(min_ + size_), line_color(Role::neutral, ui_.theme));
  }

 private:
  static ImVec2 vec(glm::dvec2 v) { return {float(v.x), float(v.y)}; }
  glm::dvec2 at(glm::dvec2 v) const { return middle_ + glm::dvec2(v.x, -v.y); }
  void line(glm::dvec2 a, glm::dvec2 b, Role role, double width) const {
    list_->AddLine(vec(at(a)), vec(at(b)), line_color(role, ui_.theme), float(width * ui_.scale));
  }
  void say(glm::dvec2 place, const char* words, Role role) const {
    list_->AddText(vec(at(place)), line_color(role, ui_.theme), words);
  }

  void frustum(const ViewFrame& view) const {
    const double reach = 0.48 * size_.x;
    for (const double side : {-1.0, 1.0}) line({0, 0}, {reach, side * view.tan_y * reach}, Role::frustum, 2.0);
    line({0, 0}, {0.3 * size_.x, 0}, Role::frustum, 2.0);
    arrow({0.3 * size_.x, 0}, {1, 0}, Role::frustum);
    list_->AddCircleFilled(vec(middle_), float(5.0 * ui_.scale), line_color(Role::frustum, ui_.theme));
    say({-0.5 * ImGui::GetFontSize(), -0.4 * ImGui::GetFontSize()}, "eye", Role::frustum);
  }

  void arrow(glm::dvec2 tip, glm::dvec2 way, Role role) const {
    const double length = 11.0 * ui_.scale;
    const glm::dvec2 back = tip - length * way, aside = 0.4 * length * glm::dvec2(-way.y, way.x);
    list_->AddTriangleFilled(vec(at(tip)), vec(at(back + aside)), vec(at(back - aside)), line_color(role, ui_.theme));
  }

  void camera_plane() const {
    line({0, -0.5 * size_.y}, {0, 0.5 * size_.y}, Role::infinity, 2.0);
    say({0.3 * ImGui::GetFontSize(), 0.5 * size_.y - 0.2 * ImGui::GetFontSize()}, "w = 0", Role::infinity);
  }

  /// Parallel rays that come from its side.
  void sun(glm::dvec2 way) const {
    const double length = 0.22 * std::min(size_.x, size_.y), out = 0.46 * std::min(size_.x, size_.y);
    for (const double aside : {-0.12, 0.0, 0.12}) {
      const glm::dvec2 start = out * way + aside * size_.y * glm::dvec2(-way.y, way.x);
      line(start, start - length * way, Role::light, 2.5);
      arrow(start - length * way, -way, Role::light);
    }
  }

  void lamp(glm::dvec2 place) const {
    for (int i = 0; i < 8; ++i) {
      const double angle = glm::radians(45.0 * i);
      const glm::dvec2 ray(std::cos(angle), std::sin(angle));
      line(place + 9.0 * ui_.scale * ray, place + 14.0 * ui_.scale * ray, Role::light, 2.5);
    }
    list_->AddCircleFilled(vec(at(place)), float(7.0 * ui_.scale), line_color(Role::light, ui_.theme));
  }

  const UiContext& ui_;
  glm::dvec2 min_, size_, middle_;
  ImDrawList* list_;
};

void wrapped(const std::string& words) {
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
}

std::optional<int> choices(UiContext& ui, const LightQuiz& quiz) {
  std::optional<int> clicked;
  const QuizQuestion& question = quiz.question();
  // Once answered, the keyboard goes on to what comes next.
  ImGui::PushItemFlag(ImGuiItemFlags_NoNavDefaultFocus, quiz.answered());
  for (int i = 0; i < int(question.choices.size()); ++i) {
    // A mark besides the colour.
    const bool right = quiz.answered() && i == question.right, wrong = quiz.answered() && i == quiz.chosen() && !right;
    const std::string text = (right ? "● " : wrong ? "× " : "") + question.choices[std::size_t(i)];
    if (right || wrong) {
      const glm::vec3 tone = right ? accent_color(ui.theme) : warning_color(ui.theme);
      ImGui::PushStyleColor(ImGuiCol_Text, color(tone));
    }
    const bool pressed = ImGui::Button(text.c_str(), {ImGui::GetContentRegionAvail().x, 0.0f});
    if (pressed && !quiz.answered()) clicked = i;
    note_place(ui, "quiz.answer=" + std::to_string(i));
    if (right || wrong) ImGui::PopStyleColor();
  }
  ImGui::PopItemFlag();
  return clicked;
}

}  // namespace

QuizClicks quiz_panel(UiContext& ui, const Rect& place, const LightQuiz& quiz) {
  QuizClicks clicks;
  if (place.empty()) return clicks;
  ImGui::SetCursorScreenPos({float(place.min.x), float(place.min.y)});
  ImGui::BeginChild("quiz", {float(place.size().x), float(place.size().y)}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  take_keyboard(ui, "quiz");
  // A child's own ground goes to its parent's list, under the picture.
  ImGui::GetWindowDrawList()->AddRectFilled({float(place.min.x), float(place.min.y)}, {float(place.max.x), float(place.max.y)},
                                            ImGui::GetColorU32(ImGuiCol_PopupBg));
  ImGui::Text("Question %d   right: %d of %d", quiz.number(), quiz.score().right, quiz.score().answers);
  const float width = ImGui::GetContentRegionAvail().x, height = std::min(0.5f * width, 0.32f * float(place.size().y));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  SideView(ui, {corner.x, corner.y}, {width, height}).draw(ui.model.experiment(), quiz.light(), quiz.answered());
  ImGui::Dummy({width, height});
  rest_tooltip("The plane that holds the line of sight and the light, seen from the side. An arrow: parallel light.");
  wrapped(quiz.question().prompt);
  clicks.answer = choices(ui, quiz);
  if (quiz.answered()) {
    wrapped((quiz.was_right() ? "Right. " : "No. ") + quiz.question().why);
    clicks.next = ImGui::Button(quiz.is_last_of_light() ? "Next light" : "Next question");
    note_place(ui, "quiz.next");
    ImGui::SameLine();
    clicks.show = ImGui::Button("Show this light");
    note_place(ui, "quiz.show");
    rest_tooltip("Makes it the experiment's light, in all views; can be undone.");
  }
  clicks.close = ImGui::Button("Close");
  note_place(ui, "quiz.close");
  if (quiz.score().answers > 0) {
    ImGui::SameLine();
    clicks.reset_score = ImGui::Button("Reset score");
    note_place(ui, "quiz.reset");
  }
  ImGui::EndChild();
  return clicks;
}

}  // namespace psm
