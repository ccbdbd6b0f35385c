// SPDX-License-Identifier: GPL-3.0-or-later
// From lesson to lesson and back, in one run of the program and over several: nothing that a student did is lost.
#include <gmock/gmock.h>

#include <fstream>

#include "harness.h"

namespace psm::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr Modifiers kControl{true, false, false};

/// Two steps: a question whose answer turns the light, with a link to the other lesson, and one without anything to do.
void write_lesson(const fs::path& folder, const std::string& title, const std::string& link) {
  fs::create_directories(folder);
  std::ofstream(folder / "lesson.json") << R"({"psmlab_lesson": 1, "title": ")" << title << R"(", "summary": "For the test.",
    "base": {"scene": {"source": "ground"}, "light": {"type": "directional", "to_light": [0, 1, -0.5]}},
    "steps": [
      {"heading": "Ask", "views": ["world"], "controls": ["shadow.resolution"],
       "questions": [{"kind": "choice", "prompt": "Which?", "choices": ["one", "two"], "answer": 1, "why": "So.",
                      "reveal": {"light": {"to_light": [0, 1, 0]}}}]},
      {"heading": "Tell", "views": ["eye"]}]})";
  std::ofstream(folder / "text.md") << "# " << title << "\n\n## Ask\n\nSee [there](lesson:" << link
                                    << ").\n\n## Tell\n\nSee [there](lesson:" << link << "/2).\n";
}

class LessonProgressTest : public ::testing::Test {
 protected:
  LessonProgressTest() {
    write_lesson(lessons_.path() / "03_first", "The first", "07_second");
    write_lesson(lessons_.path() / "07_second", "The second", "03_first");
    bench_ = std::make_unique<Bench>("chessboard", std::vector<std::string>{}, glm::ivec2(1152, 720), lessons_.path());
  }
  void open(const std::string& name) {
    if (!bench_->on_screen("lesson.pane")) bench_->key('L');
    if (bench_->on_screen("lesson.list")) click("lesson.list");
    click("lesson.open=" + name);
  }
  void click(const std::string& place) { bench_->click(bench_->at(place)); }
  const LessonSession& session() { return bench_->work().lessons(); }
  const LessonRun& run() { return *session().run(); }
  const std::string& lesson() { return run().lesson().name; }
  /// Answers the first step's question of the first lesson and makes its experiment one's own.
  void work_on_the_first() {
    open("03_first");
    click("lesson.question.0.choice.0");
    bench_->drag(bench_->at("shadow.resolution", 0.3), bench_->at("shadow.resolution", 0.6));
    mine_ = bench_->experiment();
    EXPECT_NE(mine_.shadow.resolution, 1024);
  }
  void expect_the_first_as_left() {
    EXPECT_EQ(lesson(), "03_first");
    EXPECT_EQ(bench_->experiment(), mine_);
    EXPECT_EQ(run().state().questions[0].choice, 0);
    EXPECT_TRUE(run().finished(0));
  }

  ScratchFolder lessons_;
  std::unique_ptr<Bench> bench_;
  Experiment mine_;
};

TEST_F(LessonProgressTest, ALessonThatWasLeftComesBackAsItWas) {
  const Experiment own = bench_->experiment();
  work_on_the_first();
  click("lesson.close");
  EXPECT_EQ(bench_->experiment(), own);
  open("03_first");
  expect_the_first_as_left();
  open("07_second");
  EXPECT_FALSE(run().state().questions[0].answered());
  EXPECT_EQ(bench_->experiment().shadow.resolution, 1024);
  open("03_first");
  expect_the_first_as_left();
  open("03_first");
  expect_the_first_as_left();
  bench_->key('Z', kControl);
  EXPECT_EQ(bench_->experiment(), mine_) << "undo stays in the step";
  click("lesson.reset_lesson");
  EXPECT_FALSE(run().state().questions[0].answered());
  EXPECT_EQ(bench_->experiment().shadow.resolution, 1024);
  click("lesson.close");
  EXPECT_EQ(bench_->experiment(), own);
}

TEST_F(LessonProgressTest, AFileOfALessonMeansItsFolder) {
  const Model& model = bench_->work().model();
  LessonSession session(lessons_.path(), {});
  const std::string file = (lessons_.path() / "07_second" / "lesson.json").string();
  for (const std::string& asked : {file, file + "/2"}) {
    EXPECT_TRUE(session.perform({LessonCommand::Kind::open, 0, asked, 0, 0.0}, model)) << session.error();
    EXPECT_EQ(session.run()->lesson().name, "07_second");
  }
  EXPECT_EQ(session.run()->index(), 1u);
}

TEST_F(LessonProgressTest, ALinkOpensTheFirstStepAndThereIsAWayBack) {
  open("07_second");
  bench_->key(key::page_down);
  work_on_the_first();
  EXPECT_FALSE(bench_->on_screen("lesson.way_back"));
  click("text.link.0");
  EXPECT_EQ(lesson(), "07_second");
  EXPECT_EQ(run().index(), 0u) << "not the step seen last";
  click("lesson.way_back");
  expect_the_first_as_left();
  EXPECT_FALSE(bench_->on_screen("lesson.way_back"));
  click("text.link.0");
  click("text.link.0");
  EXPECT_EQ(lesson(), "03_first");
  bench_->key(key::backspace);
  EXPECT_EQ(lesson(), "07_second");
  bench_->key(key::left);
  expect_the_first_as_left();
  bench_->key(key::backspace);
  EXPECT_EQ(lesson(), "03_first") << "there is no more way back";
}

TEST_F(LessonProgressTest, ALinkMayNameAStepAndTheWayBackLeadsToTheStepOfTheLink) {
  open("03_first");
  bench_->key(key::page_down);
  click("text.link.0");
  EXPECT_EQ(lesson(), "07_second");
  EXPECT_EQ(run().index(), 1u);
  bench_->key(key::backspace);
  EXPECT_EQ(lesson(), "03_first");
  EXPECT_EQ(run().index(), 1u);
}

TEST_F(LessonProgressTest, AfterTheLastStepComesTheNextLesson) {
  open("03_first");
  click("lesson.next");
  EXPECT_EQ(lesson(), "03_first");
  click("lesson.next");
  EXPECT_EQ(lesson(), "07_second");
  EXPECT_EQ(run().index(), 0u);
  bench_->key(key::page_up);
  EXPECT_EQ(lesson(), "03_first");
  EXPECT_EQ(run().index(), 1u);
  bench_->key(key::page_down);
  bench_->key(key::page_down);
  EXPECT_EQ(lesson(), "07_second");
  EXPECT_EQ(run().index(), 1u);
  bench_->key(key::page_down);
  EXPECT_EQ(run().index(), 1u) << "no lesson follows";
}

TEST_F(LessonProgressTest, AClickerGoesOnToTheNextLesson) {
  open("03_first");
  bench_->key(key::f11);
  for (int i = 0; i < 3; ++i) bench_->key(key::page_down);  // the answer, the second step, the next lesson
  EXPECT_EQ(lesson(), "07_second");
  bench_->key(key::page_up);
  EXPECT_EQ(lesson(), "03_first");
  EXPECT_EQ(run().index(), 1u);
}

TEST_F(LessonProgressTest, AnotherStartOfTheProgramKnowsFinishedStepsAndAnswers) {
  work_on_the_first();
  bench_->key(key::page_down);
  click("lesson.close");
  const fs::path kept = lessons_.path() / "kept.json";
  fs::copy_file(bench_->folder() / "config" / "lessons.json", kept);
  LessonSession session(lessons_.path(), kept);
  EXPECT_EQ(session.error(), "");
  EXPECT_EQ(session.progress().at("03_first").finished(), 2u);
  const Model model(*load_experiment("ground", {}));
  const auto second = session.perform({LessonCommand::Kind::open, 0, "03_first", 0, 0.0}, model);
  ASSERT_TRUE(second && session.run());
  EXPECT_EQ(session.run()->index(), 1u) << "where one left off";
  EXPECT_EQ(second->view.tiles, std::vector<ViewId>{ViewId::eye});
  const auto first = session.perform({LessonCommand::Kind::go_to, 0, "", 0, 0.0}, model);
  ASSERT_TRUE(first);
  EXPECT_EQ(session.run()->state().questions[0].choice, 0);
  EXPECT_EQ(first->light.to_light, glm::dvec3(0, 1, 0)) << "what the answer revealed";
  EXPECT_EQ(first->view.tiles, std::vector<ViewId>{ViewId::world});
  (void)session.perform({LessonCommand::Kind::reset_lesson, 0, "", 0, 0.0}, model);
  EXPECT_EQ(read_progress(kept)->at("03_first").finished(), 0u);
}

TEST_F(LessonProgressTest, ADamagedFileIsOneLineAndStartsAfresh) {
  const fs::path kept = lessons_.path() / "kept.json";
  std::ofstream(kept) << "{\"psmlab_progress\": 2, \"lessons\": [1, 2";
  const LessonSession session(lessons_.path(), kept);
  EXPECT_THAT(session.error(), HasSubstr("kept.json:1: "));
  EXPECT_THAT(session.error(), HasSubstr("; progress starts afresh"));
  EXPECT_THAT(session.error(), Not(HasSubstr("\n")));
  EXPECT_TRUE(session.progress().empty());
  EXPECT_TRUE(fs::exists(kept.string() + ".damaged")) << "for a hand that can mend it";
}

}  // namespace
}  // namespace psm::test
