// SPDX-License-Identifier: GPL-3.0-or-later
// Golden images: tests/golden/NAME_VIEW.png. PSMLAB_UPDATE_GOLDENS=1 writes them anew; look at each before it is committed.
#include <gtest/gtest.h>

#include <cstdlib>

#include "figure/png.h"
#include "picture.h"
#include "run_program.h"
#include "scene/experiment.h"

namespace psm::testing {
namespace {

namespace fs = std::filesystem;

struct Golden {
  const char* name;
  ViewId view;
  // What another driver may do differently: each channel by up to this much, but for this fraction of the pixels.
  int largest;
  double fraction;
};

const std::pair<const char*, std::vector<std::string>> kExperiments[] = {
    {"chessboard_spot", {"chessboard"}},
    {"ground_gmnpr", {"ground", "--set", "shadow.technique=gmnpr"}},
    {"texel_size", {"chessboard", "--set", "view.eye_overlay=texel_size", "--set", "shadow.resolution=2048"}},
    {"texel_grid", {"ground", "--set", "view.texel_grid=on"}},
    {"probe", {"chessboard", "--set", "view.probe=760,610"}},
    {"point_behind_psm",
     {"chessboard", "--set", "light.type=point", "--set", "light.position=4,12,26", "--set", "shadow.technique=psm"}},
    {"figure7_two_maps", {PSMLAB_TEST_DATA "/../assets/experiments/psm2002_figure7_two_maps.psm.json"}},
};

const Golden kGoldens[] = {
    {"chessboard_spot", ViewId::world, 16, 0.003},  {"chessboard_spot", ViewId::cube, 16, 0.003},
    {"chessboard_spot", ViewId::map, 8, 0.003},     {"chessboard_spot", ViewId::eye, 16, 0.003},
    {"ground_gmnpr", ViewId::world, 16, 0.003},     {"ground_gmnpr", ViewId::cube, 16, 0.003},
    {"ground_gmnpr", ViewId::map, 8, 0.003},        {"ground_gmnpr", ViewId::eye, 16, 0.003},
    {"point_behind_psm", ViewId::world, 16, 0.003}, {"point_behind_psm", ViewId::cube, 16, 0.003},
    {"point_behind_psm", ViewId::map, 8, 0.003},    {"point_behind_psm", ViewId::eye, 16, 0.003},
    {"figure7_two_maps", ViewId::map, 8, 0.003},    {"figure7_two_maps", ViewId::eye, 16, 0.003},
    {"texel_size", ViewId::eye, 16, 0.003},         {"texel_grid", ViewId::eye, 16, 0.003},
    {"probe", ViewId::world, 16, 0.003},
};

std::vector<std::string> arguments_of(const Golden& golden, const std::string& out) {
  std::vector<std::string> arguments{"render"};
  for (const auto& [name, experiment] : kExperiments)
    if (name == std::string(golden.name)) arguments.insert(arguments.end(), experiment.begin(), experiment.end());
  arguments.insert(arguments.end(), {"--view", name_of(golden.view), "--size", "480x270", "--out", out});
  return arguments;
}

std::string file_name(const Golden& golden) { return std::string(golden.name) + "_" + name_of(golden.view) + ".png"; }

void PrintTo(const Golden& golden, std::ostream* out) { *out << file_name(golden); }

class GoldenImage : public ::testing::TestWithParam<Golden> {};

TEST_P(GoldenImage, IsMet) {
  const Golden& golden = GetParam();
  const fs::path wanted_file = fs::path(PSMLAB_TEST_DATA) / "golden" / file_name(golden);
  const fs::path folder = fs::path(PSMLAB_PROGRAM).parent_path() / "golden";  // beside the program: kept, to be looked at
  fs::create_directories(folder);
  const fs::path actual_file = folder / ("actual_" + file_name(golden)),
                 difference_file = folder / ("difference_" + file_name(golden));
  fs::remove(difference_file);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // the goldens are Mesa's software pictures, whatever graphics card is there
  const Outcome run = run_program(arguments_of(golden, actual_file.string()));
  ASSERT_EQ(run.code, 0) << run.err;
  if (std::getenv("PSMLAB_UPDATE_GOLDENS")) {
    fs::copy_file(actual_file, wanted_file, fs::copy_options::overwrite_existing);
    GTEST_SKIP() << "wrote " << wanted_file;
  }
  const auto actual = read_png(actual_file), wanted = read_png(wanted_file);
  ASSERT_TRUE(actual);
  ASSERT_TRUE(wanted) << wanted_file << " is missing; PSMLAB_UPDATE_GOLDENS=1 writes it";
  ASSERT_EQ(actual->width, wanted->width);
  ASSERT_EQ(actual->height, wanted->height);
  const Difference found = difference(*actual, *wanted, golden.largest);
  if (found.fraction <= golden.fraction) return;
  EXPECT_FALSE(write_png(difference_file, found.image.width, found.image.height, found.image.rgba));
  ADD_FAILURE() << "a fraction of " << found.fraction << " of the pixels differs by more than " << golden.largest << " (allowed "
                << golden.fraction << "), by up to " << found.largest << "\nwanted " << wanted_file << "\nactual " << actual_file
                << "\ndifference " << difference_file;
}

INSTANTIATE_TEST_SUITE_P(All, GoldenImage, ::testing::ValuesIn(kGoldens),
                         [](const auto& golden) { return std::string(golden.param.name) + "_" + name_of(golden.param.view); });

}  // namespace
}  // namespace psm::testing
