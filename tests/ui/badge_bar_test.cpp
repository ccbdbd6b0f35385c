// SPDX-License-Identifier: GPL-3.0-or-later
// The badges use the lines that their bar has.
#include "harness.h"

namespace psm::test {
namespace {

TEST(BadgeBar, NoLineIsEmptyAtAnyScale) {
  for (const int width : {1024, 1280, 1600, 1920}) {
    Bench bench("ground", {}, {width, 768});
    for (const int percent : {100, 125, 150}) {
      Settings settings = bench.work().settings();
      settings.scale_percent = percent;
      bench.work().set_settings(settings);
      bench.settle();
      const Rect light = bench.work_places().at("badge.light"), time = bench.work_places().at("badge.time");
      const int views_end = bench.work_places().at("view.map").max.y, line = light.size().y;
      EXPECT_LT(768 - time.max.y, line) << width << " wide, " << percent << " %: an empty line below";
      EXPECT_LT(light.min.y - views_end, line) << width << " wide, " << percent << " %: an empty line above";
      EXPECT_LE(time.max.x, width);
    }
  }
}

TEST(BadgeBar, PresentsInAWindowOfAFewPixels) {
  for (const glm::ivec2 size : {glm::ivec2(4, 600), glm::ivec2(600, 4), glm::ivec2(1, 1)}) {
    Bench bench;
    bench.key(key::f11);
    bench.resize(size);
    bench.resize({1024, 768});
    EXPECT_TRUE(bench.on_screen("badge.light"));
  }
}

}  // namespace
}  // namespace psm::test
