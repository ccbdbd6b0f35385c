// SPDX-License-Identifier: GPL-3.0-or-later
// Questions and tasks of a step as parts. In front of a class there is room from the start for what answers bring.
#include <algorithm>
#include <cmath>

#include "ui/lesson_context.h"

namespace psm {
namespace {

using Kind = LessonCommand::Kind;

std::string name_of_question(std::size_t index) { return "question." + std::to_string(index); }
std::string name_of_choice(std::size_t question, std::size_t choice) {
  return name_of_question(question) + ".choice." + std::to_string(choice);
}
std::string name_of_task(std::size_t index) { return "task." + std::to_string(index); }

bool is_right(const Question& question, const QuestionState& state) {
  if (question.kind == Question::Kind::choice) return state.choice == question.answer_index;
  return state.number && std::abs(*state.number - state.truth) <= question.tolerance;
}

glm::vec3 right_color(Theme theme) {
  return theme == Theme::dark ? role_color(Role::texel_grid) : role_text_color(Role::texel_grid);
}

/// The answer shows or changes something.
bool predicts(const Question& question) { return !question.cover.empty() || question.reveal; }

std::string verdict_words(const Question& question, const QuestionState& state) {
  const std::string truth = shown_number(state.truth) + " " + question.unit;
  if (state.shown) return question.kind == Question::Kind::number ? "● It is " + truth : "● The right answer is marked.";
  const bool right = is_right(question, state);
  std::string words =
      predicts(question) ? (right ? "● As you predicted." : "○ Not as you predicted.") : (right ? "● Right." : "○ Not quite.");
  if (question.kind == Question::Kind::number) words += " You said " + shown_number(*state.number) + ", it is " + truth;
  return words;
}

/// No verdict is longer.
std::string longest_verdict(const Question& question) {
  QuestionState state;
  state.choice = -1, state.number = state.truth = -8.888e-88;
  return verdict_words(question, state);
}

constexpr const char* kReached = "● Reached, with the solution shown.";

}  // namespace

void LessonPanel::question_parts(const Context& c, std::size_t index, Parts& parts) {
  const Question& question = c.run().step().questions[index];
  const QuestionState& state = c.run().state().questions[index];
  const bool answered = state.answered();
  Part prompt = prose_part(c, name_of_question(index), question.prompt);
  prompt.begins = true;
  if (!answered) prompt.question = index;
  prompt.height += c.part_heading_height() + c.gap();
  prompt.draw = [first = predicts(question) && !answered, draw = std::move(prompt.draw)](Context& now) {
    part_heading(first ? "Predict first" : "Question");
    draw(now);
  };
  parts.push_back(std::move(prompt));
  if (!question.cover.empty() && !answered && !c.staged) {
    std::string views;
    for (const ViewId view : question.cover) views += (views.empty() ? "" : ", ") + std::string(name_of(view));
    parts.push_back({c.style.size, [views](Context&) { ImGui::TextDisabled("Your answer uncovers: %s", views.c_str()); }});
  }
  for (std::size_t i = 0; i < question.choices.size(); ++i) parts.push_back(choice_part(c, index, i));
  Part verdict{c.words_height(longest_verdict(question)), {}};
  if (question.kind == Question::Kind::number) {
    verdict.height = std::max(verdict.height, c.widget_height());
    verdict.draw = [this, index](Context& now) { number_answer(now, index); };
  }
  if (answered)
    verdict.draw = [&question, &state](Context& now) {
      const bool right = state.shown || is_right(question, state);
      toned_words(right ? right_color(now.ui.theme) : warning_color(now.ui.theme), verdict_words(question, state));
    };
  parts.push_back(std::move(verdict));
  Part why = prose_part(c, name_of_question(index) + ".why", question.why);
  why.draw = [this, index, draw = std::move(why.draw)](Context& now) {
    draw(now);
    if (answered_now_ != index) return;
    answered_now_.reset();
    if (!now.staged) ImGui::SetScrollHereY(1.0f);
  };
  if (!answered) why.draw = {};
  parts.push_back(std::move(why));
}

LessonPanel::Part LessonPanel::choice_part(const Context& c, std::size_t question, std::size_t choice) {
  const Prose& text = c.run().step().questions[question].choices[choice];
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const double width = std::floor(c.style.width - 2.0 * padding.x - 1.4 * c.style.size);
  const CachedPage& set = page(c, name_of_choice(question, choice), text, width);
  return {std::ceil(set.page.height) + 2.0 * padding.y, [=, this](Context& now) { draw_choice(now, question, choice); }, false,
          set.too_wide};
}

/// A button as wide as the pane; once answered it stays, marked.
void LessonPanel::draw_choice(Context& c, std::size_t index, std::size_t choice) {
  const Question& question = c.run().step().questions[index];
  const QuestionState& state = c.run().state().questions[index];
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const float width = float(c.style.width), mark = 1.4f * ImGui::GetFontSize();
  const std::string name = name_of_choice(index, choice);
  const TextPage& text =
      page(c, name, question.choices[choice], std::floor(c.style.width - 2 * padding.x - 1.4 * c.style.size)).page;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(name.c_str());
  ImGui::BeginDisabled(state.answered());
  const bool chosen = ImGui::Button("##choose", {width, float(std::ceil(text.height)) + 2 * padding.y});
  ImGui::EndDisabled();
  ImGui::PopID();
  note_place(c.ui, "lesson." + name);
  const ImVec2 below = ImGui::GetCursorScreenPos();
  const bool truth = state.answered() && int(choice) == question.answer_index, mine = state.choice == int(choice);
  const ImVec2 middle(at.x + padding.x + 0.45f * ImGui::GetFontSize(), at.y + padding.y + 0.58f * ImGui::GetFontSize());
  const float radius = 0.3f * ImGui::GetFontSize();
  const Color tone = truth ? line_color(Role::texel_grid, c.ui.theme) : mine ? color(warning_color(c.ui.theme)) : text_color(0.6);
  if (truth)
    ImGui::GetWindowDrawList()->AddCircleFilled(middle, radius, tone);
  else
    ImGui::GetWindowDrawList()->AddCircle(middle, radius, tone, 0, mine ? 3.0f : 1.5f);
  ImGui::SetCursorScreenPos({at.x + padding.x + mark, at.y + padding.y});
  show_page(c.ui, text, name);
  ImGui::SetCursorScreenPos(below);
  if (!chosen) return;
  c.commands.push_back({Kind::choose, index, "", int(choice), 0.0});
  answered_now_ = index;
}

void LessonPanel::number_answer(Context& c, std::size_t index) {
  const Question& question = c.run().step().questions[index];
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
  if ((!entered && !pressed) || !std::isfinite(typed)) return;
  c.commands.push_back({Kind::answer, index, "", 0, typed});
  answered_now_ = index;
}

void LessonPanel::task_parts(const Context& c, std::size_t index, Parts& parts) {
  const Task& task = c.run().step().tasks[index];
  const TaskState& state = c.run().state().tasks[index];
  const std::string name = name_of_task(index);
  Part prompt = prose_part(c, name, task.prompt);
  prompt.begins = true;
  if (!state.done) prompt.task = index;
  prompt.height += c.part_heading_height() + c.gap();
  prompt.draw = [done = state.done, draw = std::move(prompt.draw)](Context& now) {
    part_heading(done ? "Task: done" : "Task");
    draw(now);
  };
  parts.push_back(std::move(prompt));
  parts.push_back(
      {std::max(c.widget_height(), c.words_height(kReached)), [this, index](Context& now) { task_buttons(now, index); }});
  if (state.done)
    parts.back().draw = [shown = state.shown](Context& now) {
      toned_words(right_color(now.ui.theme), shown ? kReached : "● Reached.");
    };
  // Below the buttons, which stay where they are.
  for (std::size_t i = 0; i < task.hints.size(); ++i) {
    Part hint = prose_part(c, name + ".hint." + std::to_string(i), task.hints[i]);
    hint.height += c.style.size + c.gap();
    hint.draw = [i, draw = std::move(hint.draw)](Context& now) {
      ImGui::TextDisabled("Hint %d", int(i + 1));
      draw(now);
    };
    if (i >= state.hints) hint.draw = {};
    parts.push_back(std::move(hint));
  }
  Part done = prose_part(c, name + ".done", task.done);
  if (!state.done) done.draw = {};
  parts.push_back(std::move(done));
}

void LessonPanel::task_buttons(Context& c, std::size_t index) {
  const std::string name = "lesson." + name_of_task(index);
  if (c.run().state().tasks[index].hints < c.run().step().tasks[index].hints.size()) {
    if (c.button("Hint", name + ".hint")) c.ask(Kind::hint, index);
    ImGui::SameLine();
  }
  if (c.button("Show me", name + ".solve")) c.ask(Kind::solve, index);
  rest_tooltip("Sets the experiment to a solution. Undo takes it back.");
}

}  // namespace psm
