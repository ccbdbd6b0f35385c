// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the speed-against-error study that need no OpenGL.
#include "measure/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "measure/closed_form.h"
#include "measure/equal_error.h"
#include "measure/journal.h"
#include "measure/line_error.h"
#include "measure/pareto.h"
#include "scene/light_angles.h"

namespace psm {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

// ---- rows ---------------------------------------------------------------------------------------------------------------

StudyRow example(double run) {
  StudyRow row;
  row.version = "1.0", row.study = "abc", row.run = run;
  row.scene = "a \"quoted\", scene", row.technique = "psm", row.resolution = 512;
  row.error_fraction = 1.0 / 3.0, row.equal_error_resolution = INFINITY, row.theta_deg = 60;
  row.cpu = "A, B";
  return row;
}

std::string without_newline(std::string line) {
  line.pop_back();
  return line;
}

TEST(StudyRow, ReadsBackBitForBit) {
  const StudyRow row = example(3);
  const auto again = row_from_csv(without_newline(csv_line(row)));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->scene, row.scene);
  EXPECT_EQ(again->cpu, row.cpu);
  EXPECT_EQ(again->error_fraction, row.error_fraction);
  EXPECT_EQ(again->equal_error_resolution, INFINITY);
  EXPECT_TRUE(std::isnan(again->m_p95));
  EXPECT_EQ(csv_line(*again), csv_line(row));
}

TEST(StudyRow, IsAWholeLineOrNothing) {
  const std::string line = without_newline(csv_line(example(3)));
  EXPECT_FALSE(row_from_csv(line + ",1"));
  EXPECT_FALSE(row_from_csv(line.substr(0, line.size() / 2)));
  EXPECT_FALSE(row_from_csv(""));
  std::string rubbish = line;
  rubbish.replace(rubbish.find("512"), 3, "5x2");
  EXPECT_FALSE(row_from_csv(rubbish));
}

TEST(StudyRow, IsJsonWithoutNaN) {
  const auto json = nlohmann::json::parse(rows_to_json({example(0), example(1)}));
  EXPECT_EQ(json["machine"]["cpu"], "A, B");
  ASSERT_EQ(json["rows"].size(), 2u);
  EXPECT_EQ(json["rows"][1]["error_fraction"], 1.0 / 3.0);
  EXPECT_EQ(json["rows"][1]["equal_error_resolution"], "inf");
  EXPECT_TRUE(json["rows"][1]["m_p95"].is_null());
  EXPECT_FALSE(json["rows"][0].contains("cpu"));
}

// ---- equal error, Pareto, repeats -----------------------------------------------------------------------------------------

TEST(EqualError, FindsTheSmallestResolutionOfAFallingError) {
  int calls = 0;
  const auto error = [&](int resolution) { return ++calls, 1.0 / resolution; };
  for (const int wanted : {16, 17, 100, 1000, 4095, 8192})
    EXPECT_EQ(equal_error_resolution(error, 1.0 / wanted, {16, 8192, 0}), wanted);
  EXPECT_LT(calls, 6 * 18);
  EXPECT_EQ(equal_error_resolution(error, 1.0, {16, 8192, 0}), 16);
  EXPECT_EQ(equal_error_resolution(error, 1e-5, {16, 8192, 0}), std::nullopt);
  EXPECT_EQ(equal_error_resolution(error, std::nan(""), {16, 8192, 0}), std::nullopt);
}

TEST(EqualError, StopsAtTheStepAskedFor) {
  const auto error = [](int resolution) { return 1.0 / resolution; };
  const auto found = equal_error_resolution(error, 1.0 / 1000, {16, 8192, 1.0 / 64});
  ASSERT_TRUE(found);
  EXPECT_GE(*found, 1000);
  EXPECT_LE(*found, 1000 * (1 + 1.0 / 64) + 1);
}

TEST(Pareto, KeepsWhatNobodyBeats) {
  const std::vector<glm::dvec2> points{{1, 5}, {2, 6}, {2, 4}, {3, 4}, {4, 1}, {std::nan(""), 0}, {0.5, INFINITY}, {1, 7}};
  EXPECT_THAT(pareto_front(points), ElementsAre(0u, 2u, 4u));
  EXPECT_THAT(pareto_front(std::vector<glm::dvec2>{{1, 1}, {1, 1}, {2, 1}}), ElementsAre(0u, 1u));
  EXPECT_THAT(pareto_front(std::vector<glm::dvec2>{}), IsEmpty());
}

TEST(Repeats, AreEnoughWhenTheyAgreeOrTimeIsUp) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(relative_spread({1, 2, 3, 4, 5}), 2.0 / 3.0);
  Repeats steady({3, 10, 0.05, 100, 2});
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(steady.enough());
    EXPECT_EQ(steady.wants_eye(), i < 2);
    steady.add({1, 0.5, 2, -1, i < 2 ? 3.0 : -1, -1});
  }
  EXPECT_TRUE(steady.enough());
  EXPECT_EQ(steady.medians().map, 2);
  EXPECT_EQ(steady.medians().eye, 3);
  EXPECT_LT(steady.medians().eye_gpu, 0);
  Repeats restless({3, 10, 0.05, 1000});
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(restless.enough());
    restless.add({1.0 + i, 0, 2, -1, 3, -1});
  }
  EXPECT_TRUE(restless.enough());
  Repeats slow({1, 10, 0.0, 0.5});
  slow.add({1, 0, 0, -1, 0, -1});
  EXPECT_TRUE(slow.enough());
}

// ---- the study ------------------------------------------------------------------------------------------------------------

TEST(Study, TurnsTheSunAboutTheEye) {
  const Study study = default_study(false);
  for (const StudyRun& run : study.runs) {
    const Experiment x = study.experiment(run);
    EXPECT_EQ(check_experiment(x).value_or(InputError{}).text, "");
    EXPECT_NEAR(light_theta(x), *run.theta_deg * kDegree, 1e-12);
    EXPECT_GT(x.light.to_light.y, 0) << "below the horizon";
  }
}

TEST(Study, HoldsTheOneSceneTableAheadAndBehind) {
  const Study study = default_study(false);
  std::set<double> angles;
  for (const StudyRun& run : study.runs)
    if (study.scenes[run.scene].name == kSlab) angles.insert(*run.theta_deg);
  EXPECT_EQ(angles.size(), 19u);
  for (const double theta : {90, 75, 60, 45, 35, 30, 20, 10, 5, 1}) {
    EXPECT_TRUE(angles.count(theta)) << theta;
    EXPECT_TRUE(angles.count(180 - theta)) << theta;
  }
}

TEST(Study, HasAFingerprintOfEverythingThatMatters) {
  const Study study = default_study(true);
  const std::string print = fingerprint(study, "1");
  EXPECT_EQ(fingerprint(default_study(true), "1"), print);
  EXPECT_NE(fingerprint(study, "2"), print);
  EXPECT_NE(fingerprint(default_study(false), "1"), print);
  Study changed = study;
  changed.scenes[0].base.experiment.camera.near *= 2;
  EXPECT_NE(fingerprint(changed, "1"), print);
  changed = study;
  changed.runs[1].resolution *= 2;
  EXPECT_NE(fingerprint(changed, "1"), print);
}

TEST(Study, KnowsItsOwnRows) {
  const Study study = default_study(true);
  const std::size_t far = study.runs.size() - 1;  // of a scene with several far distances
  const auto row_of = [&](std::size_t index) {
    const StudyRun& run = study.runs[index];
    const StudyScene& scene = study.scenes[run.scene];
    StudyRow row;
    row.run = double(index), row.scene = scene.name, row.technique = name_of(run.technique);
    row.resolution = run.resolution, row.theta_deg = *run.theta_deg;
    row.camera_far = run.far.value_or(scene.base.experiment.camera.far);
    row.width = scene.base.experiment.image.width, row.height = scene.base.experiment.image.height;
    return row;
  };
  for (std::size_t i = 0; i < study.runs.size(); ++i) EXPECT_TRUE(is_row_of(study, row_of(i))) << i;
  const auto changed = [&](auto change) {
    StudyRow row = row_of(far);
    change(row);
    return is_row_of(study, row);
  };
  for (const double run : {-1.0, double(far) - 0.5, double(far) + 1, 1e300, double(INFINITY), kNone, 0.0})
    EXPECT_FALSE(changed([&](StudyRow& row) { row.run = run; })) << run;
  EXPECT_FALSE(changed([](StudyRow& row) { row.scene = "../elsewhere"; }));
  EXPECT_FALSE(changed([](StudyRow& row) { row.technique = "custom"; }));
  EXPECT_FALSE(changed([](StudyRow& row) { row.resolution = 0; }));
  EXPECT_FALSE(changed([](StudyRow& row) { row.theta_deg = kNone; }));
  EXPECT_FALSE(changed([](StudyRow& row) { row.camera_far += 1; }));
  EXPECT_FALSE(changed([](StudyRow& row) { row.width = kNone; }));
}

// ---- the error on the central line ----------------------------------------------------------------------------------------

TEST(LineError, OfTheMapsIsTheClosedFormWhereItsAssumptionsHold) {
  int compared = 0;
  for (const double far : {10.0, 100.0, 800.0})
    for (const ClosedFormRow& row : compare_with_closed_forms({1.0, far, 30.0}, {2, 10, 25, 30, 45, 70, 90})) {
      if (std::isnan(row.model_E) || std::isnan(row.map_E)) continue;
      ++compared;
      EXPECT_NEAR(row.map_F / row.model_F, 1.0, 1e-6);
      EXPECT_NEAR(row.map_E / row.model_E, 1.0, 1e-6) << name_of(row.technique) << " theta " << row.theta_deg << " f " << far;
      EXPECT_GE(row.map_E, row.bound_E * (1 - 1e-9));
      EXPECT_NEAR(row.model_E, row.model_F * std::sin(row.theta_deg * kDegree), 1e-9 * row.model_E);
    }
  EXPECT_GT(compared, 120);
}

TEST(LineError, IsThereForEveryTechniqueThatNeedsNoFlatReceiver) {
  std::set<Technique> measured;
  for (const ClosedFormRow& row : compare_with_closed_forms({}, {45}))
    if (std::isfinite(row.map_F) && std::isfinite(row.map_E)) measured.insert(row.technique);
  for (const Technique technique : techniques_to_compare())
    EXPECT_EQ(measured.count(technique), technique == Technique::plane_optimal ? 0u : 1u) << name_of(technique);
}

TEST(LineError, IsNothingWithoutASingleMapOrAlongTheView) {
  EXPECT_EQ(largest_line_error(Analysis{}), std::nullopt);
  Experiment x;
  x.light.to_light = x.camera.target - x.camera.position;
  EXPECT_EQ(largest_line_error(analyze(x, box_scene({-1, -1, -1}, {1, 1, 1}))), std::nullopt);
}

// ---- journals -------------------------------------------------------------------------------------------------------------

std::optional<std::string> any_row(const StudyRow&) { return std::nullopt; }

class JournalTest : public ::testing::Test {
 protected:
  JournalTest() : folder_(fs::temp_directory_path() / ("psmlab-journal-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~JournalTest() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::vector<StudyRow>& rows) {
    auto journal = Journal::open(folder_ / name);
    ASSERT_TRUE(journal) << journal.error().text;
    for (const StudyRow& row : rows) EXPECT_FALSE(journal->append(row));
  }
  std::vector<double> runs() {
    const auto rows = read_journals({folder_}, any_row);
    EXPECT_TRUE(rows) << rows.error().text;
    std::vector<double> numbers;
    for (const StudyRow& row : *rows) numbers.push_back(row.run);
    return numbers;
  }
  std::string error(const RowCheck& check = any_row) {
    const auto rows = read_journals({folder_}, check);
    return rows ? "" : rows.error().text;
  }

  fs::path folder_;
};

TEST_F(JournalTest, GivesEachRunOnceInOrder) {
  write("2-of-2.csv", {example(3), example(1)});
  write("1-of-2.csv", {example(0), example(2), example(1)});
  EXPECT_THAT(runs(), ElementsAre(0, 1, 2, 3));
}

TEST_F(JournalTest, DropsAHalfWrittenLineAndGoesOn) {
  write("a.csv", {example(0), example(1)});
  fs::resize_file(folder_ / "a.csv", fs::file_size(folder_ / "a.csv") - 10);
  EXPECT_THAT(runs(), ElementsAre(0));
  write("a.csv", {example(2)});
  EXPECT_THAT(runs(), ElementsAre(0, 2));
  fs::resize_file(folder_ / "a.csv", 5);  // not even the header
  EXPECT_THAT(runs(), IsEmpty());
  write("a.csv", {example(4)});
  EXPECT_THAT(runs(), ElementsAre(4));
}

TEST_F(JournalTest, RefusesWhatDoesNotBelongTogether) {
  write("a.csv", {example(0)});
  StudyRow other = example(1);
  other.version = "2.0";
  write("b.csv", {other});
  EXPECT_THAT(error(), HasSubstr("b.csv: line 2: rows of versions 1.0 and 2.0"));
  fs::remove(folder_ / "b.csv");
  other = example(1);
  other.study = "xyz";
  write("b.csv", {other});
  EXPECT_THAT(error(), HasSubstr("b.csv: line 2: rows of different studies, abc and xyz"));
}

TEST_F(JournalTest, NamesTheLineOfARowThatIsRefused) {
  write("a.csv", {example(0), example(1)});
  const auto no_first = [](const StudyRow& row) {
    return row.run == 1 ? std::optional<std::string>("not this one") : std::nullopt;
  };
  EXPECT_THAT(error(no_first), HasSubstr("a.csv: line 3: not this one"));
}

TEST_F(JournalTest, LeavesALinkThatLeadsNowhereAlone) {
  write("a.csv", {example(0)});
  fs::create_symlink("loop.csv", folder_ / "loop.csv");
  fs::create_symlink("gone", folder_ / "gone.csv");
  EXPECT_THAT(runs(), ElementsAre(0));
}

TEST_F(JournalTest, SaysWhyARowDoesNotFit) {
  auto journal = Journal::open(folder_ / "a.csv");
  ASSERT_TRUE(journal);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit nearly_full{rlim_t(fs::file_size(folder_ / "a.csv") + 10), before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &nearly_full), 0);
  errno = ENOMEM;  // of something else
  const auto error = journal->append(example(0));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_TRUE(error);
  EXPECT_THAT(error->text, ::testing::AllOf(HasSubstr("a.csv"), HasSubstr(std::strerror(EFBIG)), HasSubstr("allowed:")));
  EXPECT_THAT(runs(), IsEmpty());
}

TEST_F(JournalTest, NamesTheLineThatIsNoRow) {
  write("a.csv", {example(0)});
  std::ofstream(folder_ / "a.csv", std::ios::app) << "rubbish\n";
  EXPECT_THAT(error(), ::testing::AllOf(HasSubstr("a.csv: line 3"), HasSubstr("allowed:")));
  std::ofstream(folder_ / "a.csv") << "x,y\n1,2\n";
  EXPECT_THAT(error(), HasSubstr("a.csv: line 1"));
}

TEST_F(JournalTest, NoFolderHasNoRows) {
  const auto rows = read_journals({folder_ / "none"}, any_row);
  ASSERT_TRUE(rows);
  EXPECT_THAT(*rows, IsEmpty());
}

}  // namespace
}  // namespace psm
