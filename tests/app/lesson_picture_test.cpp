// SPDX-License-Identifier: GPL-3.0-or-later
// A step of a lesson as a picture, and its animation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "picture.h"
#include "run_program.h"

namespace psm::testing {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

/// Two steps; the second turns the light for a fifth of a second.
std::string write_lesson(const Folder& folder) {
  const std::filesystem::path lesson = folder.path() / "lesson";
  std::filesystem::create_directories(lesson);
  std::ofstream(lesson / "lesson.json") << R"({"psmlab_lesson": 1, "title": "T", "summary": "S",
    "base": {"scene": {"source": "ground"}},
    "steps": [{"heading": "A", "views": ["curves", "body"], "highlight": ["caster_body"]},
              {"heading": "B", "views": ["world"],
               "animation": {"path": "light.theta_deg", "from": 20, "to": 160, "seconds": 0.2}}]})";
  std::ofstream(lesson / "text.md") << "# T\n\n## A\n\nOne.\n\n## B\n\nTwo.\n";
  return lesson.string();
}

Outcome render(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"render", "--size", "320x180"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_program(all);
}

TEST(LessonPicture, HasTheStepsOwnViews) {
  const Folder folder, out;
  const Outcome run = render({"--lesson", write_lesson(folder), "--out", out / "x.svg"});
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = contents(out / "x.svg");
  EXPECT_THAT(svg, HasSubstr(">Curves"));
  EXPECT_THAT(svg, HasSubstr(">Body H"));
  EXPECT_THAT(svg, HasSubstr("&quot;source&quot;: &quot;ground&quot;"));
}

TEST(LessonPicture, AnAnimationIsAFrameForEach25thOfASecond) {
  const Folder folder, out;
  const Outcome run = render({"--lesson", write_lesson(folder) + "/2", "--animation", "--out", out / "turn.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(out.names(), SizeIs(6));
  EXPECT_THAT(out.names(), Each(StartsWith("turn_000")));
  const auto first = read_png(out / "turn_0001.png"), last = read_png(out / "turn_0006.png");
  ASSERT_TRUE(first && last);
  EXPECT_GT(difference(*first, *last, 16).fraction, 0.01);
  EXPECT_THAT(contents(out / "turn_0006.png"), HasSubstr("\"to_light\""));
}

TEST(LessonPicture, AFilmPlaysTheAnimationByItself) {
  if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const Folder folder, out;
  const Outcome run = render({"--lesson", write_lesson(folder) + "/2", "--out", out / "turn.gif"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(contents(out / "turn.gif").substr(0, 4), "GIF8");
}

TEST(LessonPicture, RefusesInOneLine) {
  const Folder folder, out;
  const std::string lesson = write_lesson(folder);
  const struct {
    std::vector<std::string> arguments;
    const char* says;
  } all[] = {{{"--lesson", lesson, "--animation", "--out", out / "x.png"}, "a step that has an animation"},
             {{"--lesson", lesson + "/3", "--out", out / "x.png"}, "a step from 1 to 2"},
             {{"--lesson", "no_such_lesson", "--out", out / "x.png"}, "--lesson no_such_lesson: is no lesson"},
             {{"--lesson", lesson, "--set", "camera.bear=1", "--out", out / "x.png"}, "--set camera.bear: no such member"},
             {{"--lesson", lesson, "ground", "--out", out / "x.png"}, "EXPERIMENT"},
             {{"--animation", "--out", out / "x.png"}, "--lesson"},
             {{"ground", "--out", out / "x.mp4"}, ".png, .svg or .pdf"}};
  for (const auto& bad : all) {
    const Outcome run = render(bad.arguments);
    EXPECT_EQ(run.code, 2) << bad.says;
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(bad.says));
  }
  EXPECT_THAT(out.names(), IsEmpty());
}

}  // namespace
}  // namespace psm::testing
