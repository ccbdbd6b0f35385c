// SPDX-License-Identifier: GPL-3.0-or-later
// A quiz about light cases: random lights in world space, three questions each, answers that are computed, and a score. Plain
// data; the same seed gives the same lights.
#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include "scene/analysis.h"

namespace psm {

struct QuizScore {
  int right = 0, answers = 0;
  bool operator==(const QuizScore&) const = default;
};

struct QuizQuestion {
  std::string prompt;
  std::vector<std::string> choices;
  int right = 0;
  std::string why;
};

/// A light that any value of its members could have; some stand exactly in the camera plane. `reach`: how far away positions are.
LightSettings random_light(std::mt19937& random, const Experiment& experiment, double reach);

/// The case, the naive order along rays, and the case after the eye has moved back until all casters are in front of it.
std::array<QuizQuestion, 3> light_questions(const Experiment& experiment, const Scene& scene);

class LightQuiz {
 public:
  /// `score`: of earlier quizzes, to go on from.
  explicit LightQuiz(unsigned seed, const QuizScore& score = {}) : random_(seed), score_(score) {}

  /// The next question of this light, or the first one of another light, for the experiment's camera and scene.
  void next(const Experiment& experiment, const Scene& scene);
  /// Counts once for each question.
  void answer(int choice);

  bool started() const { return asked_ > 0; }
  const LightSettings& light() const { return light_; }
  const QuizQuestion& question() const { return questions_[question_]; }
  bool answered() const { return chosen_ >= 0; }
  int chosen() const { return chosen_; }  // -1: not yet
  bool was_right() const { return answered() && chosen_ == question().right; }
  int number() const { return asked_; }  // of the question
  const QuizScore& score() const { return score_; }
  void reset_score() { score_ = {}; }
  bool is_last_of_light() const { return question_ + 1 == questions_.size(); }

 private:
  std::mt19937 random_;
  LightSettings light_;
  std::array<QuizQuestion, 3> questions_;
  std::size_t question_ = 0;
  int chosen_ = -1, asked_ = 0;
  QuizScore score_;
};

}  // namespace psm
