// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/lesson_run.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

bool fits(const Question& question, const QuestionState& state) {
  if (question.kind == Question::Kind::number) return !state.choice;
  return !state.number && state.choice.value_or(0) < int(question.choices.size());
}

/// What is known of a step. A lesson may have got or lost steps since: then its heading finds it.
const StepProgress* find_progress(const LessonProgress& known, std::size_t index, const std::string& heading) {
  const auto has_heading = [&](const StepProgress& step) { return step.heading == heading; };
  if (index < known.steps.size() && (known.steps[index].heading.empty() || has_heading(known.steps[index])))
    return &known.steps[index];
  const auto found = std::find_if(known.steps.begin(), known.steps.end(), has_heading);
  return found == known.steps.end() ? nullptr : &*found;
}

/// A number is kept where a file can hold it.
bool is_kept(const QuestionState& state) { return !state.number || (std::isfinite(*state.number) && std::isfinite(state.truth)); }

}  // namespace

std::size_t LessonProgress::finished() const {
  return std::size_t(std::count_if(steps.begin(), steps.end(), [](const StepProgress& known) { return known.finished; }));
}

LessonRun::LessonRun(Lesson lesson, const LessonProgress& known) : lesson_(std::move(lesson)) {
  if (known.step < lesson_.steps.size()) index_ = known.step;
  recall(known);
}

void LessonRun::fit_states() {
  states_.resize(lesson_.steps.size());
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Step& step = lesson_.steps[i];
    states_[i].questions.resize(step.questions.size());
    states_[i].tasks.resize(step.tasks.size());
    for (std::size_t q = 0; q < step.questions.size(); ++q)
      if (!fits(step.questions[q], states_[i].questions[q])) states_[i].questions[q] = {};
  }
}

void LessonRun::recall(const LessonProgress& known) {
  states_.resize(lesson_.steps.size());
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const StepProgress* step = find_progress(known, i, lesson_.steps[i].heading);
    if (!step) continue;
    states_[i].finished_before = step->finished;
    states_[i].questions = step->answers;
    for (const bool done : step->tasks) states_[i].tasks.push_back({0, done, false});
  }
  fit_states();
}

/// `before`: what the step before was left with, where one comes from there.
Result<Experiment> LessonRun::start_of(std::size_t step, const Experiment* before) const {
  const Step& next = lesson_.steps[step];
  if (next.continues && before) {
    Experiment experiment = *before;
    if (next.experiment) next.experiment->copy_to(experiment);
    // A student may have gone where the step's members mean nothing: then the step begins with its own.
    if (!check_experiment(experiment)) return experiment;
  }
  auto loaded =
      load_members(members_at_start(lesson_, step), lesson_.name + ", step " + std::to_string(step + 1), lesson_.folder);
  if (!loaded) return loaded.error();
  // From here on it no longer depends on the lesson's folder.
  std::string& source = loaded->experiment.scene.source;
  const auto builtin = builtin_scene_ids();
  if (std::find(builtin.begin(), builtin.end(), source) == builtin.end())
    source = std::filesystem::absolute(lesson_.folder / source).lexically_normal().string();
  return loaded->experiment;
}

Result<Experiment> LessonRun::go_to(std::size_t step, const Experiment& left) {
  step = std::min(step, lesson_.steps.size() - 1);
  const bool follows = states_[index_].visited && step == index_ + 1;
  auto start = start_of(step, follows ? &left : nullptr);
  if (!start) return start.error();
  if (states_[index_].visited) states_[index_].left = left;
  index_ = step;
  start_ = *start;
  states_[index_].visited = true;
  return states_[index_].left ? *states_[index_].left : start_;
}

Result<Experiment> LessonRun::reset_step() {
  auto start = start_of(index_, nullptr);
  if (!start) return start.error();
  states_[index_] = {};
  fit_states();
  states_[index_].visited = true;
  return start_ = *start;
}

Result<Experiment> LessonRun::reset_all() {
  auto start = start_of(0, nullptr);
  if (!start) return start.error();
  states_.clear();
  fit_states();
  index_ = 0;
  states_[0].visited = true;
  return start_ = *start;
}

Result<Experiment> LessonRun::replace(Lesson lesson, const Experiment& current) {
  const bool untouched = current == start_;
  std::swap(lesson_, lesson);
  const std::size_t step = std::min(index_, lesson_.steps.size() - 1);
  auto start = start_of(step, nullptr);
  if (!start) {
    std::swap(lesson_, lesson);
    return start.error();
  }
  index_ = step;
  fit_states();
  states_[index_].visited = true;
  start_ = *start;
  return untouched ? start_ : current;
}

std::vector<ViewId> LessonRun::covered() const {
  std::vector<ViewId> views;
  for (std::size_t i = 0; i < step().questions.size(); ++i)
    if (!state().questions[i].answered())
      views.insert(views.end(), step().questions[i].cover.begin(), step().questions[i].cover.end());
  return views;
}

bool LessonRun::check_tasks(const LessonState& analysed, const Analyze& analyze) {
  bool news = false;
  for (std::size_t i = 0; i < step().tasks.size(); ++i) {
    TaskState& task = state().tasks[i];
    if (task.done) continue;
    const auto& goal = step().tasks[i].goal;
    task.done = std::all_of(goal.begin(), goal.end(), [&](const Condition& condition) {
      const auto held = holds(condition, analysed, analyze);
      return held && *held;
    });
    news |= task.done;
  }
  return news;
}

bool LessonRun::finished(std::size_t step) const {
  const StepState& state = states_[step];
  if (state.finished_before) return true;
  return state.visited &&
         std::all_of(state.questions.begin(), state.questions.end(), [](const auto& q) { return q.answered(); }) &&
         std::all_of(state.tasks.begin(), state.tasks.end(), [](const auto& t) { return t.done; });
}

LessonProgress LessonRun::progress() const {
  LessonProgress progress{index_, {}};
  for (std::size_t i = 0; i < states_.size(); ++i) {
    StepProgress step{lesson_.steps[i].heading, finished(i), {}, {}};
    for (const QuestionState& question : states_[i].questions)
      step.answers.push_back(!question.shown && is_kept(question) ? question : QuestionState());
    for (const TaskState& task : states_[i].tasks) step.tasks.push_back(task.done && !task.shown);
    progress.steps.push_back(std::move(step));
  }
  return progress;
}

}  // namespace psm
