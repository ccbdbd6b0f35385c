// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson in the window: opened, stepped through, answered, solved, left, and read again when its files change.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "harness.h"

namespace psm::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kJson = R"({
  "psmlab_lesson": 1, "title": "A small lesson", "summary": "For the test.", "base": {"scene": {"source": "ground"}},
  "steps": [
    {"heading": "Ahead", "experiment": {"light": {"type": "directional", "to_light": [0, 1, -0.5]}}, "views": ["world", "cube"],
     "controls": ["light.theta_deg", "shadow.resolution"], "highlight": ["light"], "hide": ["vanishing_plane"],
     "questions": [{"kind": "choice", "prompt": "Which?", "choices": ["one", "two"], "answer": 1, "cover": ["cube"],
                    "why": "So.", "reveal": {"light": {"to_light": [0, 1, 0]}}}]},
    {"heading": "Behind", "continues": true, "views": ["world"],
     "animation": {"path": "light.theta_deg", "from": 20, "to": 60, "seconds": 1},
     "tasks": [{"prompt": "Invert it.", "goal": [{"value": "light_case.post", "is": "inverted_point"}], "hints": ["Turn."],
                "done": "Well done.", "solution": {"light": {"to_light": [0, 1, 1]}}}]}
  ]
})";
constexpr const char* kText =
    "# A small lesson\n\n## Ahead\n\nSee [above](set:light.to_light=0,1,-1) where $w$ is `=light_case.w`.\n\n## Behind\n\nTurn "
    "it.\n";

/// A lessons folder with one lesson, and the window beside it.
class LessonPanelTest : public ::testing::Test {
 protected:
  LessonPanelTest() {
    fs::create_directories(folder());
    write(kJson, kText);
    bench_ = std::make_unique<Bench>("chessboard", std::vector<std::string>{}, glm::ivec2(1152, 720), lessons_.path());
  }
  fs::path folder() const { return lessons_.path() / "00_small"; }
  void write(const std::string& json, const std::string& text) const {
    std::ofstream(folder() / "lesson.json") << json;
    std::ofstream(folder() / "text.md") << text;
  }
  void open() {
    bench_->key('L');
    bench_->click(bench_->at("lesson.open=00_small"));
  }
  const LessonRun& run() { return *bench_->work().lessons().run(); }
  void click(const std::string& place) { bench_->click(bench_->at(place)); }

  ScratchFolder lessons_;
  std::unique_ptr<Bench> bench_;
};

TEST_F(LessonPanelTest, AStepHidesWhatItNames) {
  const auto plane_shows = [&] {
    const DrawList& list = bench_->work().images().picture(ViewId::world).list;
    return std::any_of(list.lines.begin(), list.lines.end(), [](const DrawLine& l) { return l.role == Role::vanishing_plane; });
  };
  open();
  EXPECT_FALSE(plane_shows());
  click("lesson.next");
  EXPECT_TRUE(plane_shows());
}

TEST_F(LessonPanelTest, OpensFromTheListAndGivesTheStudentsExperimentBack) {
  const Experiment own = bench_->experiment();
  open();
  ASSERT_TRUE(bench_->work().lessons().run());
  EXPECT_EQ(bench_->experiment().scene.source, "ground");
  EXPECT_EQ(bench_->experiment().view.tiles, (std::vector<ViewId>{ViewId::world, ViewId::cube}));
  EXPECT_FALSE(bench_->on_screen("view.eye"));
  EXPECT_FALSE(bench_->on_screen("pane.fields")) << "the step has its own controls";
  click("lesson.close");
  EXPECT_EQ(bench_->experiment(), own);
  EXPECT_FALSE(bench_->work().lessons().run());
  EXPECT_TRUE(bench_->on_screen("pane.fields"));
  bench_->key('Z', {true, false, false});
  EXPECT_EQ(bench_->experiment(), own) << "undo goes on in the student's own history";
}

TEST_F(LessonPanelTest, StepsByButtonsAndKeysAndKeepsEachStepsExperiment) {
  open();
  bench_->drag(bench_->at("shadow.resolution", 0.3), bench_->at("shadow.resolution", 0.6));
  const int mine = bench_->experiment().shadow.resolution;
  EXPECT_NE(mine, 1024);
  bench_->key(key::page_down);
  EXPECT_EQ(run().index(), 1u);
  EXPECT_EQ(bench_->experiment().view.tiles, std::vector<ViewId>{ViewId::world});
  EXPECT_EQ(bench_->experiment().shadow.resolution, mine) << "this step continues";
  bench_->key(key::left);
  EXPECT_EQ(run().index(), 0u);
  EXPECT_EQ(bench_->experiment().shadow.resolution, mine);
  bench_->key(key::left);
  EXPECT_EQ(run().index(), 0u);
  bench_->key(key::right);
  bench_->key(key::right);
  EXPECT_EQ(run().index(), 1u);
  click("lesson.back");
  click("lesson.reset_step");
  EXPECT_EQ(bench_->experiment().shadow.resolution, 1024);
}

TEST_F(LessonPanelTest, AnAnswerUncoversTheViewAndReveals) {
  open();
  EXPECT_TRUE(bench_->on_screen("cover.cube"));
  EXPECT_FALSE(bench_->on_screen("tile.cube")) << "what is covered has no tools";
  const Image covered = bench_->screen();
  click("lesson.question.0.choice.0");
  EXPECT_FALSE(bench_->on_screen("cover.cube"));
  EXPECT_EQ(run().state().questions[0].choice, 0);
  EXPECT_EQ(bench_->experiment().light.to_light, glm::dvec3(0, 1, 0));
  EXPECT_GT(differing_pixels(covered, bench_->screen()), 1000u);
  click("lesson.question.0.choice.1");
  EXPECT_EQ(run().state().questions[0].choice, 0) << "an answer stands";
}

/// The button goes up, the answer is taken in the next frame, and the clock goes on by this much.
void answer_and_wait(Bench& bench, double seconds) {
  bench.press(bench.at("lesson.question.0.choice.0"));
  bench.input().mouse_button(0, false);
  bench.frame();
  bench.frame();
  bench.frame(seconds);
}

TEST_F(LessonPanelTest, ARevealTakesAMomentAndIsOneStepOfTheHistory) {
  open();
  const glm::dvec3 before = bench_->experiment().light.to_light;
  answer_and_wait(*bench_, 0.2);
  const double way = bench_->experiment().light.to_light.z;
  EXPECT_TRUE(way > -0.5 && way < 0.0) << way;
  bench_->settle();
  EXPECT_EQ(bench_->experiment().light.to_light, glm::dvec3(0, 1, 0));
  bench_->key('Z', {true, false, false});
  EXPECT_EQ(bench_->experiment().light.to_light, before);
}

TEST_F(LessonPanelTest, AKeySkipsARevealAndDoesNothingElse) {
  open();
  answer_and_wait(*bench_, 0.1);
  bench_->input().key(key::page_down, true);
  bench_->frame();
  EXPECT_EQ(bench_->experiment().light.to_light, glm::dvec3(0, 1, 0));
  EXPECT_EQ(run().index(), 0u);
}

TEST_F(LessonPanelTest, WithoutMotionARevealIsThereAtOnce) {
  Settings still = bench_->work().settings();
  still.reduced_motion = true;
  bench_->work().set_settings(still);
  open();
  answer_and_wait(*bench_, 0.001);
  EXPECT_EQ(bench_->experiment().light.to_light, glm::dvec3(0, 1, 0));
}

TEST_F(LessonPanelTest, InFrontOfAClassAClickerGoesThroughScreensAnswersAndSteps) {
  open();
  bench_->key(key::f11);
  for (const char* gone : {"lesson.list", "lesson.close", "lesson.next", "lesson.reset_step", "badge.time"})
    EXPECT_FALSE(bench_->on_screen(gone)) << gone;
  const Rect pane = bench_->work_places().at("lesson.pane"), title = bench_->work_places().at("bar.title");
  for (const char* view : {"view.world", "view.cube"}) EXPECT_GE(bench_->work_places().at(view).min.x, pane.max.x);
  EXPECT_GE(title.min.y, pane.max.y);
  EXPECT_LE(bench_->work_places().at("bar.step").max.x, 1152);
  EXPECT_TRUE(bench_->on_screen("cover.cube"));
  bench_->key(key::page_down);
  EXPECT_TRUE(run().state().questions[0].shown);
  EXPECT_FALSE(bench_->on_screen("cover.cube"));
  EXPECT_EQ(run().index(), 0u);
  bench_->key(key::page_down);
  EXPECT_EQ(run().index(), 1u);
  bench_->key(key::enter);
  EXPECT_EQ(run().state().tasks[0].hints, 1u);
  bench_->key(key::enter);
  EXPECT_TRUE(run().state().tasks[0].done);
  bench_->key(key::left);
  EXPECT_EQ(run().index(), 0u);
  bench_->key(key::escape);
  EXPECT_TRUE(bench_->on_screen("lesson.next"));
}

TEST_F(LessonPanelTest, AKeyIsForTheStepOnTheScreenThoughTheFrameLeavesIt) {
  const auto in_one_frame = [&](std::initializer_list<int> keys) {
    for (const int code : keys) bench_->input().key(code, true);
    for (const int code : keys) bench_->input().key(code, false);
    bench_->settle();
  };
  open();
  bench_->key(key::page_down);
  bench_->key(key::f11);
  in_one_frame({key::left, key::enter});
  EXPECT_EQ(run().index(), 0u) << "it has no task that the hint could be for";
  bench_->key(key::page_down);
  bench_->key(key::page_down);
  EXPECT_EQ(run().index(), 1u);
  bench_->key(key::escape);
  bench_->key(key::left);
  in_one_frame({key::f11, key::enter});
  EXPECT_TRUE(bench_->work().presenting());
  EXPECT_EQ(run().index(), 0u);
}

TEST_F(LessonPanelTest, ATaskIsSolvedByHandOrShown) {
  open();
  bench_->key(key::page_down);
  click("lesson.task.0.hint");
  EXPECT_EQ(run().state().tasks[0].hints, 1u);
  EXPECT_FALSE(run().state().tasks[0].done);
  click("lesson.task.0.solve");
  EXPECT_EQ(bench_->experiment().light.to_light, glm::dvec3(0, 1, 1));
  EXPECT_TRUE(run().state().tasks[0].done);
  EXPECT_TRUE(run().finished(1));
  bench_->key('Z', {true, false, false});
  EXPECT_NE(bench_->experiment().light.to_light, glm::dvec3(0, 1, 1));
  const auto progress = bench_->folder() / "config" / "lessons.json";
  EXPECT_TRUE(fs::exists(progress));
}

TEST_F(LessonPanelTest, ALinkSetsMembersAndPlayMovesTheLight) {
  open();
  click("text.link.0");
  EXPECT_EQ(bench_->experiment().light.to_light, glm::dvec3(0, 1, -1));
  bench_->key(key::page_down);
  click("lesson.play");
  EXPECT_NEAR(bench_->analysis().theta.value_or(0), glm::radians(60.0), 1e-6);
}

/// Steps with a short animation each.
constexpr const char* kMoving = R"({
  "psmlab_lesson": 1, "title": "A small lesson", "summary": "For the test.", "base": {"scene": {"source": "ground"}},
  "steps": [
    {"heading": "Ahead", "views": ["world"],
     "animation": {"path": "shadow.camera_shift", "from": 0, "to": 2, "seconds": 0.3}},
    {"heading": "Behind", "views": ["world"],
     "animation": {"path": "light.to_light.x", "from": -1, "to": 3, "seconds": 0.3}}
  ]
})";

TEST_F(LessonPanelTest, PlaysWhateverNumberAControlMoves) {
  write(kMoving, kText);
  open();
  click("lesson.play");
  EXPECT_EQ(bench_->experiment().shadow.camera_shift, CameraShift(2.0)) << "a rule before";
  bench_->key(key::page_down);
  click("lesson.play");
  EXPECT_EQ(bench_->experiment().light.to_light.x, 3.0);
}

TEST_F(LessonPanelTest, UndoOnTheWayStopsAPlay) {
  write(kMoving, kText);
  open();
  const Experiment before = bench_->experiment();
  bench_->press(bench_->at("lesson.play"));
  bench_->input().mouse_button(0, false);
  for (int i = 0; i < 8; ++i) bench_->frame();
  ASSERT_NE(bench_->experiment(), before);
  bench_->key('Z', {true, false, false});
  EXPECT_EQ(bench_->experiment(), before);
}

TEST_F(LessonPanelTest, IsReadAgainWhenItsFilesChange) {
  open();
  bench_->pass_time(2.0);
  bench_->work().look();
  EXPECT_FALSE(bench_->work().needs_redraw()) << "nothing has changed";
  write(kJson, std::string(kText) + "\n## More\n");
  fs::last_write_time(folder() / "text.md", fs::file_time_type::clock::now() + std::chrono::seconds(5));
  bench_->pass_time(2.0);
  bench_->work().look();
  bench_->settle();
  EXPECT_THAT(bench_->work().lessons().error(), HasSubstr("text.md:11: no such step in lesson.json"));
  EXPECT_EQ(run().step().heading, "Ahead");
  std::string json = kJson, text = kText;
  json.replace(json.find("[0, 1, -0.5]"), 12, "[0, 1, -2.0]");
  write(json, text);
  fs::last_write_time(folder() / "text.md", fs::file_time_type::clock::now() + std::chrono::seconds(9));
  bench_->pass_time(2.0);
  bench_->work().look();
  bench_->settle();
  EXPECT_EQ(bench_->work().lessons().error(), "");
  EXPECT_EQ(bench_->experiment().light.to_light, glm::dvec3(0, 1, -2)) << "nobody had changed the step's start";
}

/// What stands in a folder beside what the bench keeps there.
std::vector<std::string> pictures_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != "config") names.push_back(entry.path().filename().string());
  return names;
}

TEST_F(LessonPanelTest, AFilmIsWrittenBetweenFramesAndCanBeGivenUp) {
  if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  open();
  bench_->key(key::page_down);
  const auto begin = [&] {
    bench_->key('P');
    bench_->type((bench_->folder() / "turn.gif").string());
    bench_->input().key(key::enter, true);
    bench_->input().key(key::enter, false);
    for (int i = 0; i < 8; ++i) bench_->frame();
    ASSERT_EQ(bench_->work().dialog(), Dialogs::Kind::progress);
    ASSERT_EQ(pictures_in(bench_->folder()).size(), 1u) << "the frames so far";
  };
  begin();
  bench_->key(key::escape);
  EXPECT_EQ(bench_->work().dialog(), Dialogs::Kind::none);
  EXPECT_THAT(pictures_in(bench_->folder()), ::testing::IsEmpty());
  begin();
  for (int i = 0; i < 5000 && bench_->work().dialog() == Dialogs::Kind::progress; ++i) bench_->frame();
  bench_->settle();
  EXPECT_EQ(bench_->work().last_picture(), bench_->folder() / "turn.gif");
  EXPECT_THAT(pictures_in(bench_->folder()), ::testing::ElementsAre("turn.gif"));
}

}  // namespace
}  // namespace psm::test
