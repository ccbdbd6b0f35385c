// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "draw/utf8.h"
#include "lesson/formula.h"
#include "scene/control.h"
#include "scene/share_text.h"

namespace psm {
namespace {

/// What one step is checked with.
class StepCheck {
 public:
  StepCheck(const Lesson& lesson, std::size_t index, const LessonSurroundings& surroundings, std::vector<InputError>& errors)
      : lesson_(lesson), step_(lesson.steps[index]), index_(index), surroundings_(surroundings), errors_(errors) {}

  void run() {
    check_texts();
    const auto loaded = load_members(members_at_start(lesson_, index_), "experiment", lesson_.folder);
    if (!loaded) return fail(step_.line, loaded.error().text);
    loaded_ = &*loaded;
    state_ = state_of(*loaded, surroundings_.analyze(*loaded, false));
    for_each_run([&](const Inline& run, const char* file) { check_live_value(run, file); });
    for_each_run([&](const Inline& run, const char* file) { check_set_link(run, file); });
    check_controls();
    if (step_.animation) check_animation(*step_.animation);
    for (const Question& question : step_.questions) check_question(question);
    for (const Task& task : step_.tasks) check_task(task);
    for (const Claim& claim : step_.claims) check_claim(claim);
  }

 private:
  static constexpr const char* kJson = "lesson.json";
  static constexpr const char* kText = "text.md";

  void fail(int line, const std::string& what, const char* file = kJson) {
    errors_.push_back({quotable((lesson_.folder / file).string()) + ":" + std::to_string(line) + ": " +
                       (file == std::string(kJson) ? "step " + std::to_string(index_ + 1) + ": " : "") + what});
  }

  template <class Visit>
  void for_each_run(Visit visit) {
    const auto in = [&](const Prose& prose, const char* file) {
      for (const Block& block : prose)
        for (const Inline& run : block.runs) visit(run, file);
    };
    in(step_.text, kText);
    for (const Question& question : step_.questions) {
      in(question.prompt, kJson), in(question.why, kJson);
      for (const Prose& choice : question.choices) in(choice, kJson);
    }
    for (const Task& task : step_.tasks) {
      in(task.prompt, kJson), in(task.done, kJson);
      for (const Prose& hint : task.hints) in(hint, kJson);
    }
  }

  void check_texts() {
    bool has_formula = false;
    for_each_run([&](const Inline& run, const char* file) {
      check_link(run, file);
      if (run.kind != Inline::Kind::formula && run.kind != Inline::Kind::display_formula)
        return check_glyphs(run.text, run.line, file);
      has_formula = true;
      if (const auto formula = parse_formula(run.text)) check_formula_glyphs(*formula, run.line, file);
    });
    check_glyphs(step_.heading + step_.source, step_.line, kJson);
    if (has_formula && step_.source.empty())
      fail(step_.line, "source: is missing; allowed: where the formulas of this step come from");
  }

  void check_glyphs(const std::string& text, int line, const char* file) {
    for (const char32_t point : decode_utf8(text)) {
      if (surroundings_.has_glyph(point)) continue;
      char name[16];
      std::snprintf(name, sizeof name, "U+%04X", unsigned(point));
      fail(line, std::string("the font has no glyph ") + name + "; allowed: what DejaVu Sans shows", file);
    }
  }
  void check_formula_glyphs(const Formula& formula, int line, const char* file) {
    check_glyphs(formula.text, line, file);
    for (const Formula& part : formula.parts) check_formula_glyphs(part, line, file);
  }

  void check_link(const Inline& run, const char* file) {
    const std::string& link = run.link;
    if (link.empty() || link.starts_with("set:") || link.starts_with("https://")) return;
    if (!link.starts_with("lesson:"))
      return fail(run.line, "link " + quotable(link) + ": leads nowhere; allowed: lesson:NAME, set:PATH=VALUE, https://...",
                  file);
    const auto& names = surroundings_.lessons;
    std::string asked = link.substr(7);
    (void)take_lesson_step(asked);
    if (std::find(names.begin(), names.end(), asked) != names.end()) return;
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    fail(run.line, "link " + quotable(link) + ": there is no such lesson; allowed: " + known, file);
  }
  void check_set_link(const Inline& run, const char* file) {
    if (!run.link.starts_with("set:")) return;
    const auto members = members_of_link(run.link);
    if (!members) return fail(run.line, "link " + members.error().text, file);
    if (const auto result = with_members(*loaded_, *members, "link"); !result) fail(run.line, result.error().text, file);
  }
  void check_live_value(const Inline& run, const char* file) {
    if (run.kind != Inline::Kind::live) return;
    if (const auto value = evaluate(AnalysisQuantity{run.text, std::nullopt}, state_, surroundings_.analyze); !value)
      fail(run.line, "live value " + value.error().text, file);
  }

  void check_controls() {
    for (const std::string& path : step_.controls) {
      const Experiment& experiment = loaded_->experiment;
      const bool applies =
          path == kThetaControl ? experiment.light.type == LightType::directional : find_field(path)->applies(experiment);
      if (!applies)
        fail(step_.line,
             path + ": has no meaning for this step's " + name_of(experiment.light.type) + " light; allowed: a control that has");
    }
  }

  void check_animation(const Animation& animation) {
    const auto control = find_control(animation.path, loaded_->experiment);
    if (!control) return fail(step_.line, "animation: " + control.error().text);
    for (const double end : {animation.from, animation.to}) {
      Experiment experiment = loaded_->experiment;
      if (const auto error = (*control)(experiment, end)) return fail(step_.line, "animation: " + error->text);
    }
  }

  void check_question(const Question& question) {
    for (const ViewId view : question.cover)
      if (std::find(step_.views.begin(), step_.views.end(), view) == step_.views.end())
        fail(question.line, std::string("cover: ") + name_of(view) + " is not among the step's views; allowed: one of its views");
    if (question.reveal)
      if (const auto revealed = with_members(*loaded_, *question.reveal, "reveal"); !revealed)
        fail(question.line, revealed.error().text);
    if (question.kind != Question::Kind::number) return;
    const auto answer = evaluate(question.answer, state_, surroundings_.analyze);
    if (!answer) return fail(question.line, "answer: " + answer.error().text);
    const double* number = std::get_if<double>(&*answer);
    if (!number || !std::isfinite(*number))
      fail(question.line, "answer: is no finite number on this step's experiment; allowed: one that is");
  }

  /// The first condition of the goal that does not hold; null where all do.
  const Condition* unmet(const Task& task, const LessonState& state) {
    for (const Condition& condition : task.goal) {
      const auto held = holds(condition, state, surroundings_.analyze);
      if (!held) fail(condition.line, "goal: " + held.error().text);
      if (!held || !*held) return &condition;
    }
    return nullptr;
  }
  void check_task(const Task& task) {
    const std::size_t before = errors_.size();
    if (!unmet(task, state_)) fail(task.line, "goal: holds already at the step's start; allowed: something left to do");
    if (errors_.size() > before) return;
    const auto solved = with_members(*loaded_, task.solution, "solution");
    if (!solved) return fail(task.line, solved.error().text);
    const LessonState state = state_of(*solved, surroundings_.analyze(*solved, false));
    const Condition* missed = unmet(task, state);
    if (missed && errors_.size() == before)
      fail(missed->line, "solution: does not reach the goal: " + why_not(*missed, state, surroundings_.analyze));
  }

  void check_claim(const Claim& claim) {
    const int line = claim.condition.line;
    const std::string place = "claim \"" + quotable(claim.says) + "\": ";
    if (step_.written.find(claim.says) == std::string::npos)
      fail(line, place + "does not stand in the step's section, questions or tasks; allowed: the text as written there");
    const auto held = holds(claim.condition, state_, surroundings_.analyze);
    if (!held) return fail(line, place + held.error().text);
    if (!*held) fail(line, place + "does not hold: " + why_not(claim.condition, state_, surroundings_.analyze));
  }

  const Lesson& lesson_;
  const Step& step_;
  std::size_t index_;
  const LessonSurroundings& surroundings_;
  std::vector<InputError>& errors_;
  const LoadedExperiment* loaded_ = nullptr;
  LessonState state_;
};

}  // namespace

std::vector<InputError> check_lesson(const Lesson& lesson, const LessonSurroundings& surroundings) {
  std::vector<InputError> errors;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) StepCheck(lesson, i, surroundings, errors).run();
  return errors;
}

ExperimentMembers members_at_start(const Lesson& lesson, std::size_t step) {
  ExperimentMembers members = lesson.steps[step].continues ? members_at_start(lesson, step - 1) : lesson.base;
  if (lesson.steps[step].experiment) members.add(*lesson.steps[step].experiment);
  return members;
}

Result<ExperimentMembers> members_of_link(const std::string& link) {
  return members_from_pairs(link.substr(std::string("set:").size()));
}

}  // namespace psm
