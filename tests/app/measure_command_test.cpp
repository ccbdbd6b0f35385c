// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab measure, by running the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "measure/study_row.h"
#include "run_program.h"

namespace psm::testing {
namespace {

using ::testing::HasSubstr;

TEST(Measure, PrintsTheHardCasesInThreeFormats) {
  const Outcome text = run_program({"measure", "--hard-cases"}), csv = run_program({"measure", "--hard-cases", "--csv"}),
                json = run_program({"measure", "--hard-cases", "--json"});
  for (const Outcome* run : {&text, &csv, &json}) {
    EXPECT_EQ(run->code, 0) << run->err;
    EXPECT_EQ(run->err, "");
  }
  EXPECT_THAT(text.out, HasSubstr("BROKEN: 0"));
  EXPECT_EQ(csv.out.rfind("case,name,computed,", 0), 0u);
  std::set<int> numbers;
  const auto parsed = nlohmann::json::parse(json.out);
  for (const auto& row : parsed["hard_cases"]) numbers.insert(row["case"].get<int>());
  for (int number = 1; number <= 43; ++number) EXPECT_EQ(numbers.count(number), 1u) << number;
  EXPECT_FALSE(parsed["machine"]["cpu"].get<std::string>().empty());
}

const std::vector<std::string> kSmall{"--set", "image.width=96", "--set", "image.height=54", "--set", "light.type=directional"};

std::vector<std::string> small_measure(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"measure", "ground"};
  arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Measure, InterruptedPrintsWhatIsFinished) {
  const Folder folder;
  const std::string out = folder / "rows.csv";
  std::string small;
  for (const std::string& argument : small_measure({"--techniques", "all", "--theta-deg", "1:179:1", "--csv"}))
    small += argument + " ";
  std::ofstream{out};  // so that the loop finds it
  // TERM is handled as Ctrl-C is; a shell's background job does not hear the latter.
  const Outcome run = run_shell(small + ">> " + out + " & pid=$!; while kill -0 $pid 2> /dev/null && [ $(wc -l < " + out +
                                ") -lt 3 ]; do :; done; kill -TERM $pid; wait $pid");
  EXPECT_EQ(run.code, 1) << run.err;
  std::istringstream lines(contents(out));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line + "\n", csv_header());
  std::size_t rows = 0;
  for (; std::getline(lines, line); ++rows) EXPECT_TRUE(row_from_csv(line)) << line;
  EXPECT_GE(rows, 2u);
  EXPECT_EQ(run.err, "interrupted: " + std::to_string(rows) + " of 2327 runs are measured and printed\n");
}

TEST(Measure, PrintsARowForEachRunWithErrorsAndTimes) {
  const Outcome run = run_program(
      small_measure({"--techniques", "uniform,gmnpr", "--resolutions", "128,256", "--theta-deg", "30:90:60", "--far", "50,100"}));
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["psmlab"], 1);
  for (const char* member : {"cpu", "compiler", "opengl", "tracer"}) EXPECT_NE(json["machine"][member], "") << member;
  ASSERT_EQ(json["rows"].size(), 16u);
  for (const auto& row : json["rows"]) {
    EXPECT_GT(row["compared"].get<double>(), 0);
    EXPECT_EQ(row["wrongly_lit"].get<double>() + row["wrongly_dark"].get<double>(),
              row["outside"].get<double>() + row["by_resolution"].get<double>() + row["acne"].get<double>() +
                  row["leak"].get<double>());
    EXPECT_GE(row["error_fraction"].get<double>(), 0);
    EXPECT_LT(row["error_fraction"].get<double>(), 0.2);
    for (const char* time : {"analysis_us", "bodies_us", "map_us", "eye_us"}) EXPECT_GT(row[time].get<double>(), 0) << time;
    EXPECT_GE(row["timing_runs"].get<int>(), 5);
    EXPECT_GT(row["m_p95"].get<double>(), row["m_p50"].get<double>());
  }
}

TEST(Measure, RowsNameBiasCullingFilterAndTheLightsExtent) {
  const auto row = [](const std::vector<std::string>& more) {
    const Outcome run = run_program(small_measure(more));
    EXPECT_EQ(run.code, 0) << run.err;
    return nlohmann::json::parse(run.out)["rows"][0];
  };
  const auto plain = row({}), soft = row({"--set", "shadow.filter=pcf", "--set", "shadow.filter_size=7", "--set",
                                          "shadow.normal_bias=0.5", "--set", "shadow.cull=front", "--set", "light.radius=0.05"});
  EXPECT_EQ(plain["filter"], "none");
  EXPECT_TRUE(plain["filter_size"].is_null());
  EXPECT_EQ(plain["depth_bias"], 1.5);
  EXPECT_EQ(plain["slope_bias"], 1.0);
  EXPECT_NEAR(plain["lit_difference"].get<double>(), plain["error_fraction"].get<double>(), 1e-12) << "both are 0 or 1 here";
  EXPECT_EQ(soft["filter"], "pcf");
  EXPECT_EQ(soft["filter_size"], 7);
  EXPECT_EQ(soft["normal_bias"], 0.5);
  EXPECT_EQ(soft["cull"], "front");
  EXPECT_EQ(soft["light_radius"], 0.05);
  EXPECT_NE(soft["lit_difference"], soft["error_fraction"]);
}

/// The columns that do not depend on the machine.
std::vector<std::vector<std::string>> errors_of(const std::string& csv) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) {
    if (lines.empty()) {
      lines.emplace_back();
      continue;
    }
    const auto row = row_from_csv(line);
    EXPECT_TRUE(row) << line;
    lines.emplace_back();
    for (const StudyColumn& column : study_columns())
      if (const auto number = std::get_if<double StudyRow::*>(&column.member); row && column.repeatable && number)
        lines.back().push_back(column.name + " " + std::to_string((*row).**number));
  }
  return lines;
}

TEST(Measure, GivesTheSameErrorsEveryTime) {
  const auto arguments = small_measure({"--techniques", "psm,gmnpr", "--resolutions", "128", "--equal-error", "--csv"});
  const Outcome first = run_program(arguments), second = run_program(arguments);
  ASSERT_EQ(first.code, 0) << first.err;
  const auto errors = errors_of(first.out);
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_GT(errors[1].size(), 20u);
  EXPECT_EQ(errors, errors_of(second.out));
}

TEST(Measure, FindsTheUniformMapThatIsNoWorse) {
  const auto rows = [](const std::vector<std::string>& more) {
    return nlohmann::json::parse(run_program(small_measure(more)).out)["rows"];
  };
  const auto warped = rows({"--techniques", "gmnpr", "--resolutions", "128", "--theta-deg", "60", "--equal-error"})[0];
  const double resolution = warped["equal_error_resolution"];
  EXPECT_GT(resolution, 128);  // the warp is worth something here
  const auto uniform =
      rows({"--techniques", "uniform", "--resolutions", std::to_string(int(resolution)), "--theta-deg", "60"})[0];
  EXPECT_LE(uniform["error_fraction"].get<double>(), warped["error_fraction"].get<double>());
}

TEST(Measure, RefusesWhatItCannotMeasure) {
  const std::vector<std::pair<std::vector<std::string>, const char*>> bad{
      {{"measure", "--hard-cases", "--csv", "--json"}, "--csv, --json"},
      {{"measure", "ground", "--techniques", "psm,none"}, "--techniques: 'none'"},
      {{"measure", "ground", "--resolutions", "512,5"}, "--resolutions"},
      {{"measure", "ground", "--resolutions", ""}, "--resolutions"},
      {{"measure", "ground", "--far", "0"}, "--far"},
      {{"measure", "ground", "--theta-deg", "10:5:1"}, "--theta-deg"},
      {{"measure", "chessboard", "--theta-deg", "10"}, "only with a directional light"},
      {{"measure", "ground", "--theta-deg", "0:180:0.001"}, "runs; allowed: at most"},
      {{"measure", "ground", "--set", "image.width=16384", "--set", "image.height=16384"}, "16384 x 16384 pixels"},
      {{"measure", "no_such_scene"}, "no_such_scene"}};
  for (const auto& [arguments, expected] : bad) {
    const Outcome run = run_program(arguments);
    EXPECT_EQ(run.code, 2) << expected;
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(expected));
    EXPECT_THAT(run.err, HasSubstr("allowed"));
  }
}

}  // namespace
}  // namespace psm::testing
