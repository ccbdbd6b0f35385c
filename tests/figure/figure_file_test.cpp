// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as files: the shipped ones are in order, and what is wrong with others is said in one line.
#include "figure/figure_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "scene/experiment_file.h"

namespace psm {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

fs::path shipped() { return fs::path(PSMLAB_TEST_DATA) / "../assets/figures"; }

TEST(ShippedFigures, AreReadAndTheirExperimentsAreAllowed) {
  const auto files = figure_files(shipped());
  ASSERT_GE(files.size(), 7u);
  for (const fs::path& file : files) {
    const auto figure = read_figure(file);
    ASSERT_TRUE(figure) << figure.error().text;
    for (const FigurePanel& panel : figure->panels) {
      const auto loaded = parse_experiment(panel.experiment, file.string(), shipped(), {});
      ASSERT_TRUE(loaded) << loaded.error().text;
      for (const Note& note : loaded->scene.notes) EXPECT_NE(note.code, "member_dropped") << file << ": " << note.text;
    }
  }
}

TEST(ShippedFigures, HaveThe2002PapersSeven) {
  for (int i = 1; i <= 7; ++i) {
    const auto figure = read_figure(shipped() / ("psm2002_" + std::to_string(i) + ".figure.json"));
    ASSERT_TRUE(figure) << figure.error().text;
    EXPECT_EQ(figure->id, "psm2002_" + std::to_string(i));
    EXPECT_EQ(figure->source, "Stamminger and Drettakis 2002, Figure " + std::to_string(i));
  }
}

/// What reading this text as a figure says.
std::string complaint(const std::string& text) {
  const fs::path file = fs::path(::testing::TempDir()) / "psmlab_bad.figure.json";
  std::ofstream(file) << text;
  const auto figure = read_figure(file);
  fs::remove(file);
  if (figure) return "nothing";
  EXPECT_EQ(figure.error().text.find('\n'), std::string::npos);
  EXPECT_THAT(figure.error().text, HasSubstr("psmlab_bad.figure.json: "));
  return figure.error().text;
}

std::string figure_with(const std::string& members) {
  return R"({"psmlab_figure": 1, "title": "T", "source": "S", )" + members + "}";
}

TEST(FigureFile, SaysWhatIsWrongAndWhatIsAllowed) {
  EXPECT_EQ(complaint(figure_with(R"("panels": [{"view": "eye"}])")), "nothing");
  EXPECT_THAT(complaint("{"), HasSubstr("not JSON"));
  EXPECT_THAT(complaint("{\"psmlab_figure\": 1, \"title\": \"a\", \"title\": \"b\"}"),
              HasSubstr("title: given twice; allowed: once"));
  EXPECT_THAT(complaint("[]"), HasSubstr("an object with"));
  EXPECT_THAT(complaint(R"({"title": "T"})"), HasSubstr("psmlab_figure: null is not allowed; allowed: 1"));
  EXPECT_THAT(complaint(R"({"psmlab_figure": 1, "source": "S", "panels": [{}]})"), HasSubstr("title: missing"));
  EXPECT_THAT(complaint(figure_with(R"("panels": [])")), HasSubstr("panels: [] is not allowed; allowed: a list of 1 to"));
  EXPECT_THAT(complaint(figure_with(R"("panels": [{"view": "side"}])")), HasSubstr("panels[0].view: \"side\" is not allowed"));
  EXPECT_THAT(complaint(figure_with(R"("panels": [{"look": 1}])")), HasSubstr("panels[0].look: no such member"));
  EXPECT_THAT(complaint(figure_with(R"("panels": [{}], "columns": 0)")), HasSubstr("a whole number in [1, 8]"));
  EXPECT_THAT(complaint(figure_with(R"("panels": [{}], "columns": 1.5)")), HasSubstr("a whole number in [1, 8]"));
  EXPECT_THAT(complaint(figure_with(R"("panels": [{}], "panel_size": [5])")), HasSubstr("[width, height]"));
  EXPECT_THAT(complaint(figure_with(R"("panels": [{}], "hide": ["H"])")), HasSubstr("caster_body"));
  EXPECT_THAT(complaint(figure_with(R"("panels": [{"experiment": 3}])")), HasSubstr("panels[0].experiment: 3 is not allowed"));
}

TEST(FigureFile, DeepNestingIsRefusedHoweverDeep) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  for (const std::size_t levels : {17u, 1000000u}) {
    EXPECT_THAT(complaint(nested(levels)), HasSubstr("nested too deeply; allowed: 16 levels"));
    EXPECT_THAT(complaint(figure_with(R"("panels": [{"view": )" + nested(levels) + "}]")), HasSubstr("nested too deeply"));
  }
  EXPECT_THAT(complaint(nested(16)), HasSubstr("an object with"));
}

TEST(FigureFile, APanelsMembersGoOverTheFigures) {
  const fs::path file = fs::path(::testing::TempDir()) / "psmlab_good.figure.json";
  std::ofstream(file) << figure_with(R"("experiment": {"camera": {"near": 1, "far": 9}}, "hide": ["light"],
    "panels": [{"experiment": {"camera": {"near": 2}}}, {"view": "map", "title": "", "hide": []}])");
  const auto figure = read_figure(file);
  fs::remove(file);
  ASSERT_TRUE(figure) << figure.error().text;
  EXPECT_EQ(figure->id, "psmlab_good");
  EXPECT_EQ(figure->panels[0].experiment, R"({"camera":{"near":2,"far":9}})");
  EXPECT_EQ(figure->panels[1].experiment, R"({"camera":{"near":1,"far":9}})");
  EXPECT_EQ(figure->panels[0].hidden, std::vector<Role>{Role::light});
  EXPECT_TRUE(figure->panels[1].hidden.empty());
  EXPECT_FALSE(figure->panels[0].title);
  EXPECT_EQ(figure->panels[1].title, "");
}

}  // namespace
}  // namespace psm
