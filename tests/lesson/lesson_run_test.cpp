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
  Run() : run_(good_lesson()) { shown_ = *run_.go_to(0, Experiment{}); }
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
}

TEST_F(Run, AStepReachedFromElsewhereBeginsWithTheLessonsOwnExperiments) {
  LessonRun run(good_lesson());
  const Experiment shown = *run.go_to(1, Experiment{});
  EXPECT_EQ(shown.light.to_light, glm::dvec3(0, 1, -0.5));
  EXPECT_EQ(run.go_to(99, shown)->scene.source, "ground") << "the last step";
  EXPECT_EQ(run.index(), 1u);
}

TEST_F(Run, AnAnswerUncovers) {
  EXPECT_THAT(run_.covered(), ElementsAre(ViewId::cube));
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
  EXPECT_EQ(run_.progress().step, 1u);
  EXPECT_EQ(run_.progress().steps.size(), 2u);
  EXPECT_EQ(run_.progress().finished(), 1u);
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

TEST_F(Run, IsRecalledWithAnswersTasksAndFinishedSteps) {
  run_.state().questions[0].choice = 0;
  run_.state().questions[1] = {std::nullopt, 59.0, false, 60.0};
  (void)run_.go_to(1, shown_);
  const LessonRun again(good_lesson(), run_.progress());
  EXPECT_EQ(again.index(), 1u);
  EXPECT_TRUE(again.finished(0));
  EXPECT_FALSE(again.finished(1));
  EXPECT_EQ(again.state(0).questions, run_.state(0).questions);
  EXPECT_EQ(again.progress(), run_.progress());
}

TEST_F(Run, WhatWasOnlyShownIsAskedAgainThoughTheStepStaysFinished) {
  run_.state().questions[0].shown = run_.state().questions[1].shown = true;
  LessonRun again(good_lesson(), run_.progress());
  EXPECT_TRUE(again.finished(0));
  EXPECT_FALSE(again.state(0).questions[0].answered());
  (void)again.go_to(0, Experiment{});
  (void)again.reset_all();
  EXPECT_FALSE(again.finished(0));
}

TEST_F(Run, AChangedLessonFindsItsStepsByTheirHeadings) {
  run_.state().questions[0].choice = 1, run_.state().questions[1].number = 60.0;
  LessonProgress known = run_.progress();
  known.step = 7;
  known.steps.insert(known.steps.begin(), StepProgress{"Gone", false, {{0, {}, false, 0.0}, {}, {}}, {true, true, true}});
  const LessonRun run(good_lesson(), known);
  EXPECT_EQ(run.index(), 0u);
  EXPECT_TRUE(run.finished(0));
  EXPECT_EQ(run.state(0).questions[0].choice, 1);
  EXPECT_FALSE(run.finished(1));
  known.steps[1].answers = {{99, {}, false, 0.0}, {3, {}, false, 0.0}, {}};
  const LessonRun misfit(good_lesson(), known);
  EXPECT_EQ(misfit.state(0).questions, std::vector<QuestionState>(2)) << "no such choice, and a choice for a number";
}

TEST(Lessons, AreNumberedByTheirFolders) {
  EXPECT_EQ(numbered_title("08_which", "Which"), "8\u00a0 Which");
  EXPECT_EQ(numbered_title("00_why", "Why"), "0\u00a0 Why");
  EXPECT_EQ(numbered_title("110_far", "Far"), "110\u00a0 Far");
  for (const char* name : {"mine", "8", "8th", "_8", ""}) EXPECT_EQ(numbered_title(name, "Mine"), "Mine") << name;
}

TEST(Progress, IsWrittenAndReadAndStartsAfreshWhereItCannotBeRead) {
  const LessonFolder folder;
  const auto file = folder.path() / "deep" / "lessons.json";
  EXPECT_TRUE(read_progress(file)->empty());
  const StepProgress finished{"A \"step\"", true, {{1, {}, false, 0.0}, {{}, 0.1, false, 0.2}, {}}, {true, false}};
  const ProgressByLesson progress{{"00_small", {1, {finished, {"B", false, {}, {}}}}}, {"05_other", {3, {}}}};
  EXPECT_FALSE(write_progress(progress, file));
  EXPECT_EQ(*read_progress(file), progress);
  const auto error_of = [&](const std::string& lesson, int version = 2) {
    std::ofstream(file) << "{\"psmlab_progress\": " << version << ",\n \"lessons\": {\"a\": " << lesson << "}}";
    return read_progress(file).error().text;
  };
  EXPECT_THAT(error_of("{\"step\": -1}"),
              HasSubstr("lessons.json:2: lessons.a.step: -1 is not allowed; allowed: a number in [0, 1000]"));
  EXPECT_THAT(error_of("{\"step\": 0, \"steps\": [{}]}"), HasSubstr("lessons.json:2: lessons.a.steps.0.finished: is missing"));
  EXPECT_THAT(error_of("{\"step\": 0, \"steps\": 1e15, \"finished\": 0}", 1), HasSubstr("lessons.a.steps: 1e+15 is not allowed"));
  EXPECT_THAT(error_of("{}", 3), HasSubstr("lessons.json:1: psmlab_progress: 3 is not allowed; allowed: a number in [1, 2]"));
}

TEST(Progress, OfTheFirstVersionIsReadAsFarAsItsCountsTell) {
  const LessonFolder folder;
  const auto file = folder.path() / "lessons.json";
  std::ofstream(file) << R"({"psmlab_progress": 1, "lessons": {"whole": {"step": 1, "steps": 2, "finished": 2},
                                                              "part": {"step": 1, "steps": 2, "finished": 1}}})";
  const auto progress = read_progress(file);
  ASSERT_TRUE(progress) << progress.error().text;
  EXPECT_EQ(progress->at("whole").finished(), 2u);
  EXPECT_EQ(progress->at("part").finished(), 0u) << "nobody knows which";
  const LessonRun whole(good_lesson(), progress->at("whole")), part(good_lesson(), progress->at("part"));
  EXPECT_TRUE(whole.finished(0) && whole.finished(1));
  EXPECT_FALSE(part.finished(0) || part.finished(1));
  EXPECT_EQ(part.index(), 1u);
}

}  // namespace
}  // namespace psm::testing
