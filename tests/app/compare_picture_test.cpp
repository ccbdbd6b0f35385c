// SPDX-License-Identifier: GPL-3.0-or-later
// A and B as `psmlab render` writes them.
#include <gtest/gtest.h>

#include "picture.h"
#include "run_program.h"

namespace psm::testing {
namespace {

Image eye(const std::vector<std::string>& settings) {
  const Folder folder;
  std::vector<std::string> arguments{"render",  "ground",  "--view", "eye",
                                     "--size",  "320x180", "--set",  "shadow.resolution=64",
                                     "--theme", "light",   "--out",  folder / "x.png"};
  for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
  EXPECT_EQ(run_program(arguments).code, 0);
  return read_png(folder / "x.png").value_or(Image{});
}

/// The largest difference in the columns from `begin` to before `end`, below the names.
int largest_difference(const Image& a, const Image& b, int begin, int end) {
  if (a.rgba.size() != b.rgba.size()) return 255;
  int largest = 0;
  for (int y = 90; y < a.height; ++y)
    for (std::size_t i = (std::size_t(y) * a.width + begin) * 4; i < (std::size_t(y) * a.width + end) * 4; ++i)
      largest = std::max(largest, std::abs(int(a.rgba[i]) - int(b.rgba[i])));
  return largest;
}

TEST(ComparePicture, EitherSideOfTheLineIsThatTechniquesPicture) {
  const Image psm = eye({"shadow.technique=psm"}), uniform = eye({"shadow.technique=uniform"});
  const Image both = eye({"shadow.technique=psm", "view.compare=uniform", "view.split=0.25"});
  ASSERT_EQ(both.width, 320);
  EXPECT_EQ(largest_difference(both, psm, 0, 75), 0);
  EXPECT_EQ(largest_difference(both, uniform, 85, 320), 0);
  EXPECT_GT(largest_difference(psm, uniform, 85, 320), 50) << "else the test could not tell them apart";
}

TEST(ComparePicture, SideBySideHasBothWhole) {
  const Image both = eye({"view.compare=uniform", "view.compare_layout=side_by_side"});
  ASSERT_EQ(both.width, 320);
  EXPECT_TRUE(shows_something(both, 0, 60, 150, 100));
  EXPECT_TRUE(shows_something(both, 170, 60, 150, 100));
}

}  // namespace
}  // namespace psm::testing
