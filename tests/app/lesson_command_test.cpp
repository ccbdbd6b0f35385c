// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab lesson: the program's own lessons pass its own check, and a broken one does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "lesson/lesson.h"
#include "run_program.h"

namespace psm::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

void write_lesson(const fs::path& folder, const std::string& link) {
  fs::create_directories(folder);
  std::ofstream(folder / "lesson.json") << R"({"psmlab_lesson": 1, "title": "T", "summary": "S",
  "steps": [{"heading": "H", "views": ["world"]}]})";
  std::ofstream(folder / "text.md") << "# T\n\n## H\n\nSee [this](" << link << ").\n";
}

TEST(TheShippedLessons, AreFine) {
  const Outcome run = run_program({"lesson", "check"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
}

TEST(TheShippedLessons, AreListedInOrder) {
  const Outcome run = run_program({"lesson", "list"});
  EXPECT_EQ(run.code, 0) << run.err;
  std::size_t at = 0;
  for (const fs::path& folder : lesson_folders(fs::path(PSMLAB_TEST_DATA) / "../lessons")) {
    at = run.out.find(folder.filename().string() + ": ", at);
    ASSERT_NE(at, std::string::npos) << folder;
  }
}

TEST(LessonCheck, TakesFoldersAndFiles) {
  const Folder folder;
  write_lesson(folder / "00_one", "lesson:01_two");
  write_lesson(folder / "01_two", "lesson:00_one");
  for (const char* file : {"00_one", "00_one/lesson.json", "00_one/text.md"}) {
    const Outcome run = run_program({"lesson", "check", folder / file});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, "00_one: fine: 1 step, 0 questions, 0 tasks, 0 claims\n");
  }
}

TEST(LessonCheck, SaysALineForEachFaultAndGivesTwo) {
  const Folder folder;
  write_lesson(folder / "00_one", "lesson:01_two");
  write_lesson(folder / "02_three", "set:light.to_light=0");
  const Outcome run = run_program({"lesson", "check", folder / "00_one", folder / "02_three"});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err,
              HasSubstr((folder / "00_one/text.md") + ":5: link lesson:01_two: there is no such lesson; allowed: 00_one, "));
  EXPECT_THAT(run.err,
              HasSubstr((folder / "02_three/text.md") + ":5: link light.to_light: 0 is not allowed; allowed: three numbers"));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 2);
}

TEST(LessonCheck, SaysWhatIsNoLesson) {
  const Outcome none = run_program({"lesson", "check", "/no/such/lesson"});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(is_one_line(none.err));
  EXPECT_THAT(none.err, HasSubstr("/no/such/lesson: is no lesson; allowed: "));
  EXPECT_EQ(run_program({"lesson"}).code, 2);
}

}  // namespace
}  // namespace psm::testing
