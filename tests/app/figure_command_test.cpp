// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as files: figures, vectors, transparency, sweeps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "../figure/markup.h"
#include "figure/page.h"
#include "picture.h"
#include "run_program.h"

namespace psm::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string without_pixels(std::string svg) {
  for (std::size_t at = 0; (at = svg.find("base64,", at)) != std::string::npos; ++at) svg.erase(at, svg.find('"', at) - at);
  return svg;
}

TEST(FigureCommand, ListsIdSourceAndTitle) {
  const Outcome run = run_program({"figure", "--list"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("psm2002_7\tStamminger and Drettakis 2002, Figure 7\t"));
}

TEST(FigureCommand, WritesAnSvgWithItsTextAndItsExperiments) {
  const Folder folder;
  const Outcome run = run_program({"figure", "psm2002_4", "--size", "639x320", "--out", folder / "x.svg"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(folder.names(), ElementsAre("x.svg"));
  const std::string svg = contents(folder / "x.svg");
  EXPECT_EQ(unclosed_tags(without_pixels(svg)), "");
  EXPECT_THAT(svg, HasSubstr("width=\"639\" height=\"320\""));
  for (const char* text : {"From the front", "An inverted point", "eye", "light"})
    EXPECT_THAT(svg, HasSubstr(std::string(">") + text + "</text>"));
  EXPECT_THAT(svg, HasSubstr("&quot;technique&quot;: &quot;psm&quot;"));
  EXPECT_THAT(svg, HasSubstr("Stamminger and Drettakis 2002, Figure 4"));
}

TEST(FigureCommand, WritesAPngOfTheSizeAskedFor) {
  const Folder folder;
  ASSERT_EQ(run_program({"figure", "psm2002_1", "--size", "400x120", "--out", folder / "x.png"}).code, 0);
  const auto image = read_png(folder / "x.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 400);
  EXPECT_EQ(image->height, 120);
  for (int panel = 0; panel < 4; ++panel) EXPECT_TRUE(shows_something(*image, panel * 100, 0, 98, 120)) << panel;
  EXPECT_THAT(contents(folder / "x.png"), HasSubstr("tEXtpsmlab"));
}

TEST(FigureCommand, WritesAPdfOrSaysWhyNot) {
  const Folder folder;
  const Outcome run = run_program({"render", "ground", "--view", "cube", "--size", "320x180", "--out", folder / "x.pdf"});
  if (pdf_missing()) {
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(is_one_line(run.err));
    EXPECT_THAT(folder.names(), IsEmpty());
  } else {
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(contents(folder / "x.pdf").substr(0, 5), "%PDF-");
  }
}

TEST(RenderedSvg, HasTheStatusLineBelowSeveralViews) {
  const Folder folder;
  ASSERT_EQ(run_program({"render", "ground", "--view", "world,map", "--size", "640x200", "--out", folder / "x.svg"}).code, 0);
  EXPECT_THAT(contents(folder / "x.svg"), HasSubstr("gmnpr</text>"));
}

TEST(Transparent, LeavesOutTheGroundAndKeepsTheRest) {
  const Folder folder;
  ASSERT_EQ(
      run_program({"render", "ground", "--view", "world", "--size", "320x180", "--transparent", "--out", folder / "x.png"}).code,
      0);
  const auto image = read_png(folder / "x.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->rgba[(319 + 2 * 320) * 4 + 3], 0) << "the upper right corner is empty";
  int opaque = 0;
  for (std::size_t i = 3; i < image->rgba.size(); i += 4) opaque += image->rgba[i] == 255;
  EXPECT_GT(opaque, 320 * 180 / 20);
}

TEST(Sweep, WritesNumberedPicturesThatDiffer) {
  const Folder folder;
  const Outcome run = run_program({"render", "ground", "--view", "world", "--size", "96x64", "--sweep",
                                   "light.theta_deg=20:160:3", "--out", folder / "turn.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(folder.names(), ElementsAre("turn_0001.png", "turn_0002.png", "turn_0003.png"));
  const auto first = read_png(folder / "turn_0001.png"), last = read_png(folder / "turn_0003.png");
  ASSERT_TRUE(first && last);
  EXPECT_GT(difference(*first, *last, 16).fraction, 0.01);
}

TEST(Sweep, LeavesNothingWhereAValueIsNotAllowed) {
  const Folder folder;
  const Outcome run = run_program(
      {"render", "ground", "--view", "map", "--size", "32x32", "--sweep", "camera.near=1:-1:3", "--out", folder / "x.png"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(is_one_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr("--sweep camera.near"));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Sweep, SaysInOneLineThatAFilmNeedsFfmpeg) {
  const Folder folder;
  const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
  setenv("PATH", folder.path().c_str(), 1);
  const Outcome run = run_program({"render", "ground", "--sweep", "camera.near=1:2:3", "--out", folder / "x.mp4"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(is_one_line(run.err));
  EXPECT_THAT(run.err, HasSubstr("ffmpeg"));
  EXPECT_THAT(folder.names(), IsEmpty());
}

struct Bad {
  std::vector<std::string> arguments;
  const char* says;
};

TEST(FigureCommand, RefusesInOneLine) {
  const Folder folder;
  std::ofstream(folder / "large.figure.json") << R"({"psmlab_figure": 1, "title": "T", "source": "S", "columns": 8,
    "panel_size": [4096, 4096], "panels": [{}, {}, {}, {}, {}]})";
  std::ofstream(folder / "small.figure.json")
      << R"({"psmlab_figure": 1, "title": "T", "source": "S", "panel_size": [4, 4], "panels": [{}]})";
  const std::vector<Bad> all{
      {{}, "no ID"},
      {{"no_such_figure", "--out", "x.png"}, "psmlab figure --list"},
      {{"none.figure.json", "--out", "x.png"}, "cannot be read"},
      {{"large.figure.json", "--out", "x.png"}, "panel_size: 32852x4096 pixels"},
      {{"small.figure.json", "--out", "x.png"}, "panel_size: a panel of 4x4 pixels; allowed: 16 pixels or more"},
      {{"psm2002_1", "--out", "x.jpg"}, ".png, .svg or .pdf"},
      {{"psm2002_1", "--out", "x.mp4"}, ".png, .svg or .pdf"},
      {{"psm2002_1", "--out", "x.png", "--size", "20x20"}, "16 pixels"},
      {{"psm2002_1", "--out", "x.png", "--size", "20"}, "WIDTHxHEIGHT"},
      {{"psm2002_1", "--out", "x.png", "--theme", "blue"}, "light or dark"},
      {{"psm2002_1", "--out", "x.png", "--set", "camera.bear=1"}, "no such member"},
      {{"psm2002_1", "--out", "x.png", "--sweep", "camera.near"}, "PATH=A:B:COUNT"},
      {{"psm2002_1", "--out", "x.png", "--sweep", "camera.near=1:2:1"}, "COUNT in [2, 9999]"},
      {{"psm2002_1", "--out", "x.png", "--size", "400x100", "--sweep", "shadow.filter=1:2:3"}, "not one number"},
      {{"--all", "--out", "x", "--format", "bmp"}, "--format: 'bmp'"},
      {{"psm2002_1", "--all", "--out", "x"}, "together with an ID"}};
  for (const Bad& bad : all) {
    std::vector<std::string> arguments{"figure"};
    arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
    const Outcome run = run_program(arguments, folder.path());
    EXPECT_EQ(run.code, 2) << bad.says;
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(bad.says));
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace psm::testing
