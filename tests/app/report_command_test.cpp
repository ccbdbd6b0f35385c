// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab report, by running the real program: what it leaves, and that it can be stopped, resumed, split and put together.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "measure/study_row.h"
#include "run_program.h"

namespace psm::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<StudyRow> rows_of(const fs::path& csv) {
  std::istringstream lines(contents(csv));
  std::vector<StudyRow> rows;
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line + "\n", csv_header());
  while (std::getline(lines, line)) {
    const auto row = row_from_csv(line);
    EXPECT_TRUE(row) << line;
    if (row) rows.push_back(*row);
  }
  return rows;
}

/// A row as text, without times and machine.
std::string what_repeats(StudyRow row) {
  for (const StudyColumn& column : study_columns())
    if (const auto number = std::get_if<double StudyRow::*>(&column.member); number && !column.repeatable) row.** number = kNone;
  return csv_line(row);
}

std::vector<std::string> what_repeats(const std::vector<StudyRow>& rows) {
  std::vector<std::string> lines;
  for (const StudyRow& row : rows) lines.push_back(what_repeats(row));
  return lines;
}

/// Once for all tests: the quick study, whole.
class ReportCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    whole_ = new Folder;
    const Outcome run = run_program({"report", "--quick", "--out", *whole_ / "a"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, *whole_ / "a/index.html\n");
  }
  static void TearDownTestSuite() { delete whole_; }

  static fs::path whole() { return whole_->path() / "a"; }
  static Folder* whole_;
};
Folder* ReportCommand::whole_ = nullptr;

TEST_F(ReportCommand, LeavesAPageItsPlotsAndEveryRow) {
  for (const char* name : {"index.html", "rows.csv", "ground_time.svg", "ground_texels.svg", "ground_equal.svg", "one_scene.svg",
                           "closed_forms.svg"})
    EXPECT_GT(contents(whole() / name).size(), 1000u) << name;
  const auto rows = rows_of(whole() / "rows.csv");
  const std::string count = std::to_string(rows.size());
  EXPECT_GT(rows.size(), 20u);
  EXPECT_THAT(contents(whole() / "index.html"), HasSubstr(count + " of " + count + " runs"));
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].run, double(i));
}

TEST_F(ReportCommand, GoesOnAfterACutJournalAndMeasuresNothingTwice) {
  const Folder folder;
  fs::create_directories(folder.path() / "a/rows");
  const std::string journal = contents(whole() / "rows/1-of-1.csv");
  std::ofstream(folder.path() / "a/rows/1-of-1.csv") << journal.substr(0, journal.size() / 2);
  const Outcome run = run_program({"report", "--quick", "--out", "a"}, folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string again = contents(folder / "a/rows/1-of-1.csv");
  const std::size_t kept = journal.rfind('\n', journal.size() / 2) + 1;
  EXPECT_EQ(again.substr(0, kept), journal.substr(0, kept));  // times and all: not measured again
  EXPECT_EQ(std::count(again.begin(), again.end(), '\n'), std::count(journal.begin(), journal.end(), '\n'));
  EXPECT_EQ(what_repeats(rows_of(folder / "a/rows.csv")), what_repeats(rows_of(whole() / "rows.csv")));
}

TEST_F(ReportCommand, OfShardsPutTogetherIsTheWhole) {
  const Folder folder;
  std::size_t rows = 0;
  for (const std::string shard : {"1/3", "2/3", "3/3"}) {
    const Outcome run = run_program({"report", "--quick", "--shard", shard, "--out", "part" + shard.substr(0, 1)}, folder.path());
    ASSERT_EQ(run.code, 0) << run.err;
    rows += rows_of(folder / ("part" + shard.substr(0, 1) + "/rows.csv")).size();
  }
  const Outcome run = run_program({"report", "--merge", "part1", "part2", "part3", "--out", "all"}, folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto merged = rows_of(folder / "all/rows.csv"), whole_rows = rows_of(whole() / "rows.csv");
  EXPECT_EQ(rows, whole_rows.size());
  EXPECT_EQ(what_repeats(merged), what_repeats(whole_rows));
  EXPECT_THAT(contents(folder / "all/index.html"), HasSubstr(std::to_string(rows) + " of " + std::to_string(rows) + " runs"));
}

TEST_F(ReportCommand, InterruptedKeepsWhatIsFinished) {
  const Folder folder;
  // TERM is handled as Ctrl-C is; a shell's background job does not hear the latter.
  const Outcome run =
      run_shell("report --out " + folder / "a" + " & pid=$!; while kill -0 $pid 2> /dev/null && [ $(cat " +
                folder / "a/rows/1-of-1.csv" + " 2> /dev/null | wc -l) -lt 3 ]; do :; done; " + "kill -TERM $pid; wait $pid");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the same command goes on"));
  const auto rows = rows_of(folder / "a/rows.csv");
  EXPECT_GE(rows.size(), 2u);
  EXPECT_EQ(contents(folder / "a/rows.csv"), contents(folder / "a/rows/1-of-1.csv"));
}

TEST_F(ReportCommand, RefusesInOneLine) {
  const Folder folder;
  fs::create_directories(folder.path() / "other/rows");
  std::string journal = contents(whole() / "rows/1-of-1.csv");
  const std::string study = rows_of(whole() / "rows.csv")[0].study;
  for (std::size_t at; (at = journal.find(study)) != std::string::npos;) journal.replace(at, study.size(), "0000000000000000");
  std::ofstream(folder.path() / "other/rows/1-of-1.csv") << journal;
  // Somebody's rows would be written wherever they say.
  fs::create_directories(folder.path() / "outside/rows");
  journal = contents(whole() / "rows/1-of-1.csv");
  for (std::size_t at; (at = journal.find(",ground,")) != std::string::npos;) journal.replace(at, 8, ",../../ground,");
  std::ofstream(folder.path() / "outside/rows/1-of-1.csv") << journal;
  fs::create_directories(folder.path() / "taken/rows/1-of-1.csv");
  fs::create_directories(folder.path() / "empty");
  std::ofstream(folder / "file") << "x";
  const std::vector<std::pair<std::vector<std::string>, const char*>> bad{
      {{"report"}, "--out"},
      {{"report", "--out", ""}, "--out"},
      {{"report", "--quick", "--out", "file/x"}, "--out"},
      {{"report", "--quick", "--out", "x", "--shard", "3/2"}, "--shard: '3/2'"},
      {{"report", "--quick", "--out", "x", "--shard", "0/2"}, "--shard"},
      {{"report", "--quick", "--out", "x", "--shard", "1/2/3"}, "--shard"},
      {{"report", "--quick", "--out", "other"}, "other/rows/1-of-1.csv: line 2: a row of another study"},
      {{"report", "--quick", "--out", "taken"}, "taken/rows/1-of-1.csv: cannot be opened"},
      {{"report", "--out", "x", "--merge", "empty"}, "--merge: 'empty'"},
      {{"report", "--out", "x", "--merge", "other", "--quick"}, "--merge"},
      {{"report", "--out", "x", "--merge", whole().string(), "other"}, "other/rows/1-of-1.csv: line 2: a row of another study"},
      {{"report", "--out", "x", "--merge", "outside"}, "outside/rows/1-of-1.csv: line 2: not what run 0"}};
  for (const auto& [arguments, expected] : bad) {
    const Outcome run = run_program(arguments, folder.path());
    EXPECT_EQ(run.code, 2) << expected;
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(expected));
    EXPECT_THAT(run.err, HasSubstr("allowed"));
    EXPECT_FALSE(fs::exists(folder.path() / "x")) << expected;
  }
}

}  // namespace
}  // namespace psm::testing
