// SPDX-License-Identifier: GPL-3.0-or-later
// Where somebody is in a lesson: answers, tasks, and each step's own experiment. Plain state, no widgets: the panel, a
// presentation and tests drive the same one.
#pragma once

#include "lesson/check.h"

namespace psm {

struct QuestionState {
  std::optional<int> choice;     // as answered
  std::optional<double> number;  // as answered
  bool shown = false;            // nobody answered: the right answer was asked for
  double truth = 0.0;            // of a number, when it was answered
  bool answered() const { return choice || number || shown; }
  bool operator==(const QuestionState&) const = default;
};

struct TaskState {
  std::size_t hints = 0;  // shown so far
  bool done = false;
  bool shown = false;  // its solution was asked for
  bool operator==(const TaskState&) const = default;
};

struct StepState {
  std::vector<QuestionState> questions;
  std::vector<TaskState> tasks;
  bool visited = false;
  bool finished_before = false;    // in an earlier run of the program
  std::optional<Experiment> left;  // the experiment when the step was left
};

/// What is kept of a step between runs of the program. What was only shown is asked again.
struct StepProgress {
  std::string heading;  // tells the step where a lesson has changed; empty: not known
  bool finished = false;
  std::vector<QuestionState> answers;
  std::vector<bool> tasks;  // done
  bool operator==(const StepProgress&) const = default;
};

/// How much of a lesson is behind somebody.
struct LessonProgress {
  std::size_t step = 0;  // seen last
  std::vector<StepProgress> steps;
  std::size_t finished() const;
  bool operator==(const LessonProgress&) const = default;
};

class LessonRun {
 public:
  /// At the step that was seen last, with what is known of its steps.
  explicit LessonRun(Lesson lesson, const LessonProgress& known = {});

  const Lesson& lesson() const { return lesson_; }
  std::size_t index() const { return index_; }
  const Step& step() const { return lesson_.steps[index_]; }
  StepState& state() { return states_[index_]; }
  const StepState& state() const { return states_[index_]; }
  const StepState& state(std::size_t step) const { return states_[step]; }
  /// What the current step began with.
  const Experiment& start() const { return start_; }

  /// Goes there, from a step that is left with this experiment; returns the experiment to show: as it was left, else the
  /// step's start. On an error nothing changes.
  Result<Experiment> go_to(std::size_t step, const Experiment& left);
  /// The lesson is left with this experiment.
  void leave(const Experiment& left) { state().left = left; }
  /// The start of the step, its answers and tasks as if never seen.
  Result<Experiment> reset_step();
  /// All steps as if never seen; at the first.
  Result<Experiment> reset_all();
  /// The files have changed. Stays in the same step, as far as there is one, with what fits of its answers. Returns the
  /// experiment to show: `current`, unless nobody had changed the step's start.
  Result<Experiment> replace(Lesson lesson, const Experiment& current);

  /// Views that an unanswered question of this step covers.
  std::vector<ViewId> covered() const;
  /// Tasks whose goals hold are done from now on. Returns whether one has just become so.
  bool check_tasks(const LessonState& state, const Analyze& analyze);

  bool finished(std::size_t step) const;  // visited, all answered, all done
  LessonProgress progress() const;

 private:
  Result<Experiment> start_of(std::size_t step, const Experiment* before) const;
  void fit_states();
  void recall(const LessonProgress& known);

  Lesson lesson_;
  Experiment start_;
  std::size_t index_ = 0;
  std::vector<StepState> states_;
};

}  // namespace psm
