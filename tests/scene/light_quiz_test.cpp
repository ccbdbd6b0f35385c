// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light_quiz.h"

#include <gtest/gtest.h>

#include <set>

#include "scene/experiment_file.h"

namespace psm {
namespace {

LoadedExperiment ground() { return *load_experiment("ground", {}); }

TEST(LightQuiz, AnswersAgreeWithTheAnalysis) {
  const LoadedExperiment loaded = ground();
  std::mt19937 random(7);
  std::set<std::array<int, 3>> kinds;
  for (int i = 0; i < 1000; ++i) {
    Experiment e = loaded.experiment;
    e.light = random_light(random, e, 40.0);
    const auto questions = light_questions(e, loaded.scene);
    const LightCase now = analyze(e, loaded.scene).light_case;
    ASSERT_EQ(questions[0].right, int(now.post)) << i;
    ASSERT_EQ(questions[1].right, int(now.reversed_order)) << i;
    // The last one by the analysis of an eye that stands where the shift put it.
    e.shadow.technique = Technique::psm_divided;
    e.shadow.camera_shift = ShiftRule::in_front;
    const Analysis shifted = analyze(e, loaded.scene);
    const double w = (shifted.cube_from_world * shifted.light).w,
                 scale = glm::length(glm::dvec3(shifted.light)) + shifted.camera_shift;
    const int after = std::abs(w) <= 1e-12 * scale ? 0 : w > 0 ? 1 : 2;
    ASSERT_EQ(questions[2].right, after) << i << " " << questions[2].why;
    for (const QuizQuestion& q : questions) {
      ASSERT_LT(q.right, int(q.choices.size()));
      ASSERT_FALSE(q.why.empty());
    }
    kinds.insert({questions[0].right, questions[1].right, questions[2].right});
  }
  EXPECT_GE(kinds.size(), 4u) << "all cases come up, and some change by the shift";
}

TEST(LightQuiz, TheSameSeedGivesTheSameLights) {
  const LoadedExperiment loaded = ground();
  LightQuiz a(3), b(3), c(4);
  bool differs = false;
  for (int i = 0; i < 12; ++i) {
    for (LightQuiz* quiz : {&a, &b, &c}) quiz->next(loaded.experiment, loaded.scene);
    EXPECT_EQ(a.light(), b.light());
    EXPECT_EQ(a.question().prompt, b.question().prompt);
    differs |= a.light() != c.light();
  }
  EXPECT_TRUE(differs);
}

TEST(LightQuiz, CountsEachAnswerOnce) {
  const LoadedExperiment loaded = ground();
  LightQuiz quiz(1);
  quiz.next(loaded.experiment, loaded.scene);
  EXPECT_FALSE(quiz.answered());
  quiz.answer(99);
  EXPECT_EQ(quiz.score().answers, 0);
  quiz.answer(quiz.question().right);
  quiz.answer((quiz.question().right + 1) % 2);
  EXPECT_EQ(quiz.score().answers, 1);
  EXPECT_EQ(quiz.score().right, 1);
  const LightSettings light = quiz.light();
  quiz.next(loaded.experiment, loaded.scene);
  EXPECT_EQ(quiz.light(), light) << "three questions for each light";
  quiz.answer((quiz.question().right + 1) % int(quiz.question().choices.size()));
  EXPECT_FALSE(quiz.was_right());
  EXPECT_EQ(quiz.score().right, 1);
  EXPECT_EQ(quiz.score().answers, 2);
  quiz.next(loaded.experiment, loaded.scene);
  EXPECT_TRUE(quiz.is_last_of_light());
  quiz.next(loaded.experiment, loaded.scene);
  EXPECT_NE(quiz.light(), light);
  EXPECT_EQ(quiz.number(), 4);
}

}  // namespace
}  // namespace psm
