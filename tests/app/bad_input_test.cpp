// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of bad input: exit code 2, exactly one line on standard error that names it, nothing on standard output, nothing
// written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "run_program.h"

namespace psm::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct BadInput {
  std::vector<std::string> arguments;
  const char* expected;  // in the message
};

void PrintTo(const BadInput& bad, std::ostream* out) {
  for (const std::string& argument : bad.arguments) *out << argument << ' ';
}

class BadInputTest : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadInputTest, IsRefusedInOneLine) {
  const Folder folder;
  const Outcome run = run_program(GetParam().arguments, folder.path());
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(is_one_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr(GetParam().expected));
  EXPECT_THAT(run.err, ::testing::AnyOf(HasSubstr("allowed"), HasSubstr("is neither")));
  EXPECT_THAT(folder.names(), IsEmpty());
}

std::vector<std::string> curves(std::vector<std::string> changed) {
  std::vector<std::string> arguments{"curves", "--n", "1", "--f", "100", "--phi-deg", "30", "--theta-deg", "10"};
  arguments.insert(arguments.end(), changed.begin(), changed.end());
  return arguments;
}

/// `curves` with one flag's value replaced.
std::vector<std::string> curves_with(const std::string& flag, const std::string& value) {
  std::vector<std::string> arguments = curves({});
  *(std::find(arguments.begin(), arguments.end(), flag) + 1) = value;
  return arguments;
}

std::vector<std::string> render(std::vector<std::string> more) {
  std::vector<std::string> arguments{"render", "--out", "x.png"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

INSTANTIATE_TEST_SUITE_P(Experiments, BadInputTest,
                         ::testing::Values(BadInput{{"no_such_scene"}, "no_such_scene"}, BadInput{{""}, "empty name"},
                                           BadInput{{"analyze", "no_such_scene"}, "chessboard"},
                                           BadInput{{"analyze", "none.glb"}, "none.glb"},
                                           BadInput{{"analyze", "none.psm.json"}, "none.psm.json"},
                                           BadInput{{"analyze", "psmlab:ground?camera.nera=1"}, "camera.nera: no such member"},
                                           BadInput{{"analyze", "."}, "folder"}, BadInput{{"analyze", "/dev/zero"}, "16 MiB"},
                                           BadInput{{"analyze", "a\nb.psm.json"}, "a?b.psm.json"},
                                           BadInput{{"analyze", "--set", "camera.near=-1"}, "--set camera.near: -1"},
                                           BadInput{{"analyze", "--set", "camera.nera=1"}, "camera.nera: no such member"},
                                           BadInput{{"analyze", "--set", "camera.near"}, "PATH=VALUE"},
                                           BadInput{{"analyze", "--set", "light.to_light=0,0,0"}, "light.to_light: 0,0,0"},
                                           BadInput{{"analyze", "--set", "shadow.technique=PSM"}, "gmnpr"},
                                           BadInput{{"--set", "camera.near=x"}, "camera.near: x"}));

INSTANTIATE_TEST_SUITE_P(Flags, BadInputTest,
                         ::testing::Values(BadInput{{"--no-such-flag"}, "--no-such-flag"},
                                           BadInput{{"analyze", "--no-such-flag"}, "psmlab analyze --help"},
                                           BadInput{{"analyze", "ground", "chessboard"}, "chessboard"},
                                           BadInput{{"analyze", "--set"}, "--set"}, BadInput{{"ground", "analyze"}, "after"},
                                           BadInput{{"--present", "analyze"}, "after"}, BadInput{{"scenes", "more"}, "more"},
                                           BadInput{{"scenes", "--write"}, "--write"},
                                           BadInput{{"scenes", "--write", ""}, "--write"},
                                           BadInput{{"scenes", "--write", "/dev/null/x"}, "--write"}));

INSTANTIATE_TEST_SUITE_P(
    Curves, BadInputTest,
    ::testing::Values(
        BadInput{{"curves"}, "required"}, BadInput{curves_with("--n", "0"), "--n: '0'"},
        BadInput{curves_with("--n", "-1"), "--n"}, BadInput{curves_with("--n", "1e400"), "--n"},
        BadInput{curves_with("--n", "nan"), "--n"}, BadInput{curves_with("--n", ""), "--n"},
        BadInput{curves_with("--f", "1"), "greater than --n"}, BadInput{curves_with("--f", "inf"), "--f"},
        BadInput{curves_with("--phi-deg", "0"), "(0, 90)"}, BadInput{curves_with("--phi-deg", "90"), "(0, 90)"},
        BadInput{curves_with("--theta-deg", "181"), "[0, 180]"}, BadInput{curves_with("--theta-deg", "-1"), "[0, 180]"},
        BadInput{curves_with("--theta-deg", "1,,2"), "--theta-deg"}, BadInput{curves_with("--theta-deg", "0:90"), "--theta-deg"},
        BadInput{curves_with("--theta-deg", "0:90:0"), "--theta-deg"},
        BadInput{curves_with("--theta-deg", "0:90:-1"), "--theta-deg"},
        BadInput{curves_with("--theta-deg", "90:0:1"), "--theta-deg"},
        BadInput{curves_with("--theta-deg", "0:90:1e-300"), "1000000 rows"},
        BadInput{curves_with("--theta-deg", "0:90:0.0002"), "1000000 rows"}, BadInput{curves({"--techniques", "gmnpr"}), "GMNPR"},
        BadInput{curves({"--techniques", "SSM,,GLPR"}), "--techniques"}));

INSTANTIATE_TEST_SUITE_P(
    Render, BadInputTest,
    ::testing::Values(BadInput{{"render"}, "--out"}, BadInput{{"render", "--out", "x.jpg"}, "--out: 'x.jpg'"},
                      BadInput{{"render", "--out", ".png"}, "--out"}, BadInput{{"render", "--out", ""}, "--out"},
                      BadInput{{"render", "--out", "none/x.png"}, "existing folder"},
                      BadInput{render({"--view", "wrold"}), "world, cube, map, eye"},
                      BadInput{render({"--view", "world,"}), "--view"}, BadInput{render({"--view", ""}), "--view"},
                      BadInput{render({"--size", ""}), "--size"}, BadInput{render({"--size", "0x10"}), "--size: '0x10'"},
                      BadInput{render({"--size", "640"}), "--size"}, BadInput{render({"--size", "640x480x2"}), "--size"},
                      BadInput{render({"--size", "6.5x480"}), "--size"}, BadInput{render({"--size", "16385x10"}), "16384"},
                      BadInput{render({"--size", "16384x16384"}), "67108864"},
                      BadInput{render({"--size", "64x48"}), "too small for 4 views"},
                      BadInput{render({"--scale", "0"}), "--scale"}, BadInput{render({"--theme", "blue"}), "light or dark"},
                      BadInput{render({"--set", "image.width=0"}), "image.width"}));

TEST(BadFile, IsRefusedWhole) {
  const Folder folder;
  std::ofstream(folder / "x.psm.json") << R"({"camera": {"near": 0.5}, "shadow": {"resolution": 5}})";
  const Outcome run = run_program({"analyze", "x.psm.json"}, folder.path());
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "x.psm.json: shadow.resolution: 5 is not allowed; allowed: a whole number in [16, 8192]\n");
}

TEST(BadFile, RubbishIsRefused) {
  const Folder folder;
  std::string junk(100000, '\0');
  for (std::size_t i = 0; i < junk.size(); ++i) junk[i] = char(i * 7919 >> 3);
  for (const char* name : {"x.psm.json", "x.glb", "x.gltf"}) {
    std::ofstream(folder / name, std::ios::binary) << junk;
    const Outcome run = run_program({"analyze", name}, folder.path());
    EXPECT_EQ(run.code, 2) << name;
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(name));
  }
}

TEST(BadFile, APictureThatCannotBeWrittenLeavesNothing) {
  const Folder folder;
  std::filesystem::create_directory(folder / "x.png");
  const Outcome run = run_program({"render", "--view", "map", "--size", "32x32", "--out", "x.png"}, folder.path());
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(is_one_line(run.err)) << run.err;
  EXPECT_THAT(folder.names(), ::testing::ElementsAre("x.png"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "x.png"));
}

}  // namespace
}  // namespace psm::testing
