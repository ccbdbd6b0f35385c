// SPDX-License-Identifier: GPL-3.0-or-later
// Questions and tasks in the lesson pane.
#include <cmath>

#include "ui/lesson_context.h"

namespace psm {
namespace {

using Kind = LessonCommand::Kind;

std::string name_of_question(std::size_t index) { return "question." + std::to_string(index); }

void toned(const glm::vec3& tone, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, {tone.r, tone.g, tone.b, 1.0f});
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool is_right(const Question& question, const QuestionState& state) {
  if (question.kind == Question::Kind::choice) return state.choice == question.answer_index;
  return std::abs(*state.number - state.truth) <= question.tolerance;
}

}  // namespace

void LessonPanel::question(Context& c, std::size_t index) {
  const Question& question = c.run().step().questions[index];
  const bool answered = c.run().state().questions[index].answered();
  part_heading(answered ? "Question" : "Predict first");
  prose(c, name_of_question(index), question.prompt);
  if (!question.cover.empty() && !answered) {
    std::string views;
    for (const std::string& view : question.cover) views += (views.empty() ? "" : ", ") + view;
    ImGui::TextDisabled("Your answer uncovers: %s", views.c_str());
  }
  question.kind == Question::Kind::choice ? choices(c, index) : number_answer(c, index);
  if (answered) verdict(c, index);
}

/// Each choice is a button as wide as the pane; once answered they stay, marked.
void LessonPanel::choices(Context& c, std::size_t index) {
  const Question& question = c.run().step().questions[index];
  const QuestionState& state = c.run().state().questions[index];
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const float width = ImGui::GetContentRegionAvail().x, mark = 1.4f * ImGui::GetFontSize();
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    const std::string name = name_of_question(index) + ".choice." + std::to_string(i);
    const TextPage& text = page(c, name, question.choices[i], std::floor(width - 2 * padding.x - mark));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(name.c_str());
    ImGui::BeginDisabled(state.answered());
    const bool chosen = ImGui::Button("##choose", {width, float(std::ceil(text.height)) + 2 * padding.y});
    ImGui::EndDisabled();
    ImGui::PopID();
    note_place(c.ui, "lesson." + name);
    const ImVec2 below = ImGui::GetCursorScreenPos();
    const bool truth = state.answered() && int(i) == question.answer_index, mine = state.choice == int(i);
    const ImVec2 middle(at.x + padding.x + 0.45f * ImGui::GetFontSize(), at.y + padding.y + 0.58f * ImGui::GetFontSize());
    const float radius = 0.3f * ImGui::GetFontSize();
    const Color tone = truth  ? line_color(Role::texel_grid, c.ui.theme)
                       : mine ? color(warning_color(c.ui.theme))
                              : text_color(0.6);
    if (truth)
      ImGui::GetWindowDrawList()->AddCircleFilled(middle, radius, tone);
    else
      ImGui::GetWindowDrawList()->AddCircle(middle, radius, tone, 0, mine ? 3.0f : 1.5f);
    ImGui::SetCursorScreenPos({at.x + padding.x + mark, at.y + padding.y});
    show_page(c.ui, text, name);
    ImGui::SetCursorScreenPos(below);
    if (chosen) c.commands.push_back({Kind::choose, index, "", int(i), 0.0});
  }
}

void LessonPanel::number_answer(Context& c, std::size_t index) {
  const Question& question = c.run().step().questions[index];
  if (c.run().state().questions[index].answered()) return;
  const std::string name = name_of_question(index);
  double& typed = typed_.emplace(c.run().lesson().name + "/" + std::to_string(c.run().index()) + name, 0.0).first->second;
  ImGui::SetNextItemWidth(7.0f * ImGui::GetFontSize());
  const bool entered = ImGui::InputDouble(("##" + name).c_str(), &typed, 0.0, 0.0, "%.6g", ImGuiInputTextFlags_EnterReturnsTrue);
  note_place(c.ui, "lesson." + name);
  if (!question.unit.empty()) {
    ImGui::SameLine();
    ImGui::TextUnformatted(question.unit.c_str());
  }
  ImGui::SameLine();
  const bool pressed = c.button("Answer", "lesson." + name + ".answer");
  if ((entered || pressed) && std::isfinite(typed)) c.commands.push_back({Kind::answer, index, "", 0, typed});
}

void LessonPanel::verdict(Context& c, std::size_t index) {
  const Question& question = c.run().step().questions[index];
  const QuestionState& state = c.run().state().questions[index];
  const bool right = is_right(question, state);
  const glm::vec3 tone = right ? role_text_color(Role::texel_grid) : warning_color(c.ui.theme);
  const glm::vec3 shown = right && c.ui.theme == Theme::dark ? role_color(Role::texel_grid) : tone;
  std::string text = right ? "● As you predicted." : "○ Not as you predicted.";
  if (question.kind == Question::Kind::number)
    text += " You said " + shown_number(*state.number) + ", it is " + shown_number(state.truth) + " " + question.unit;
  toned(shown, text);
  prose(c, name_of_question(index) + ".why", question.why);
}

void LessonPanel::task(Context& c, std::size_t index) {
  const Task& task = c.run().step().tasks[index];
  const TaskState& state = c.run().state().tasks[index];
  const std::string name = "task." + std::to_string(index);
  part_heading(state.done ? "Task: done" : "Task");
  prose(c, name, task.prompt);
  for (std::size_t i = 0; i < std::min(state.hints, task.hints.size()); ++i) {
    ImGui::TextDisabled("Hint %d", int(i + 1));
    prose(c, name + ".hint." + std::to_string(i), task.hints[i]);
  }
  if (state.done) {
    const glm::vec3 green = c.ui.theme == Theme::dark ? role_color(Role::texel_grid) : role_text_color(Role::texel_grid);
    toned(green, state.shown ? "● Reached, with the solution shown." : "● Reached.");
    return prose(c, name + ".done", task.done);
  }
  if (state.hints < task.hints.size()) {
    if (c.button("Hint", "lesson." + name + ".hint")) c.ask(Kind::hint, index);
    ImGui::SameLine();
  }
  if (c.button("Show me", "lesson." + name + ".solve")) c.ask(Kind::solve, index);
  rest_tooltip("Sets the experiment to a solution. Undo takes it back.");
}

}  // namespace psm
