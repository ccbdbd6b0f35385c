// SPDX-License-Identifier: GPL-3.0-or-later
// Going through a lesson: each step's experiment, answers, tasks, and what is kept of them.
#include "lesson/lesson_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "lesson/progress_file.h"
#include "lesson_fixture.h"

namespace psm::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Lesson good_lesson() {
  const LessonFolder folder;
  auto lesson = read_lesson(folder.path());
  EXPECT_TRUE(lesson);
  return std::move(*lesson);
}

LessonState analysed(LoadedExperiment& loaded, const Experiment& experiment) {
  loaded.experiment = experiment;
  return state_of(loaded, plain_surroundings().analyze(loaded, false));
}

class Run : public ::testing::Test {
 protected:
  Run() : run_(good_lesson(), Experiment{}) { shown_ = *run_.go_to(0, Experiment{}); }
  LessonRun run_;
  Experiment shown_;
};

TEST_F(Run, EachStepBeginsWithItsExperimentAndComesBackAsItWasLeft) {
  EXPECT_EQ(shown_.scene.source, "ground");
  EXPECT_EQ(shown_.light.to_light, glm::dvec3(0, 1, -0.5));
  Experiment mine = shown_;
  mine.shadow.resolution = 333;
  const Experiment second = *run_.go_to(1, mine);
  EXPECT_EQ(second.shadow.resolution, 333) << "the second step continues";
  Experiment changed = second;
  changed.light.to_light = {0, 1, 2};
  EXPECT_EQ(run_.go_to(0, changed)->shadow.resolution, 333);
  EXPECT_EQ(run_.go_to(1, mine)->light.to_light, glm::dvec3(0, 1, 2));
  EXPECT_EQ(run_.own(), Experiment{});
}

TEST_F(Run, AStepReachedFromElsewhereBeginsWithTheLessonsOwnExperiments) {
  LessonRun run(good_lesson(), Experiment{});
  const Experiment shown = *run.go_to(1, Experiment{});
  EXPECT_EQ(shown.light.to_light, glm::dvec3(0, 1, -0.5));
  EXPECT_EQ(run.go_to(99, shown)->scene.source, "ground") << "the last step";
  EXPECT_EQ(run.index(), 1u);
}

TEST_F(Run, AnAnswerUncovers) {
  EXPECT_THAT(run_.covered(), ElementsAre("cube"));
  run_.state().questions[0].choice = 1;
  EXPECT_THAT(run_.covered(), IsEmpty());
  EXPECT_FALSE(run_.finished(0));
  run_.state().questions[1].number = 60.0;
  EXPECT_TRUE(run_.finished(0));
}

TEST_F(Run, ATaskIsDoneOnceItsGoalHoldsAndStaysDone) {
  const Analyze analyze = plain_surroundings().analyze;
  Experiment experiment = *run_.go_to(1, shown_);
  auto loaded = load_members(run_.lesson().base, "base", ".");
  ASSERT_TRUE(loaded);
  EXPECT_FALSE(run_.check_tasks(analysed(*loaded, experiment), analyze));
  Experiment solved = experiment;
  run_.step().tasks[0].solution.copy_to(solved);
  EXPECT_TRUE(run_.check_tasks(analysed(*loaded, solved), analyze));
  EXPECT_FALSE(run_.check_tasks(analysed(*loaded, experiment), analyze)) << "it was news once";
  EXPECT_TRUE(run_.finished(1));
  EXPECT_EQ(run_.progress(), (LessonProgress{1, 2, 1}));
}

TEST_F(Run, ResetsGoBackToTheStart) {
  run_.state().questions[0].choice = 1;
  Experiment mine = shown_;
  mine.camera.near = 2;
  EXPECT_EQ(*run_.reset_step(), shown_);
  EXPECT_FALSE(run_.state().questions[0].answered());
  (void)run_.go_to(1, mine);
  EXPECT_EQ(*run_.reset_all(), shown_);
  EXPECT_EQ(run_.index(), 0u);
}

TEST_F(Run, ANewVersionKeepsThePlaceAndWhatFits) {
  run_.state().questions[0].choice = 1;
  const LessonFolder folder(replaced(kGoodJson, "[0, 1, -0.5]", "[0, 1, -0.75]"));
  auto next = read_lesson(folder.path());
  ASSERT_TRUE(next);
  EXPECT_EQ(run_.replace(std::move(*next), shown_)->light.to_light, glm::dvec3(0, 1, -0.75));
  EXPECT_TRUE(run_.state().questions[0].answered());
  Experiment mine = run_.start();
  mine.shadow.resolution = 333;
  EXPECT_EQ(*run_.replace(good_lesson(), mine), mine) << "what somebody has changed stays";
}

TEST(Progress, IsWrittenAndReadAndStartsAfreshWhereItCannotBeRead) {
  const LessonFolder folder;
  const auto file = folder.path() / "deep" / "lessons.json";
  EXPECT_TRUE(read_progress(file)->empty());
  const ProgressByLesson progress{{"00_small", {1, 2, 1}}, {"05_other", {3, 9, 2}}};
  EXPECT_FALSE(write_progress(progress, file));
  EXPECT_EQ(*read_progress(file), progress);
  std::ofstream(file) << "{\"psmlab_progress\": 1,\n \"lessons\": {\"a\": {\"step\": -1}}}";
  EXPECT_THAT(read_progress(file).error().text,
              HasSubstr("lessons.json:2: lessons.a.step: -1 is not allowed; allowed: a number in [0, 1000]"));
}

}  // namespace
}  // namespace psm::testing
