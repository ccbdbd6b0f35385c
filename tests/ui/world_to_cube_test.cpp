// SPDX-License-Identifier: GPL-3.0-or-later
// The slider on the cube view and key W: from the world to the cube and back.
#include "harness.h"

namespace psm::test {
namespace {

TEST(WorldToCubeTool, TheSliderGoesAllTheWay) {
  Bench bench("ground", {}, {1600, 1000});
  const Image cube = bench.view(ViewId::cube), world = bench.view(ViewId::world);
  bench.drag(bench.at("tile.world_to_cube", 0.97), bench.at("tile.world_to_cube", 0.01));
  EXPECT_EQ(bench.experiment().view.world_to_cube, 0.0);
  EXPECT_GT(differing_pixels(bench.view(ViewId::cube), cube, 16), 1000u);
  EXPECT_EQ(differing_pixels(bench.view(ViewId::world), world), 0u);
  bench.key('Z', {true, false, false});
  EXPECT_EQ(bench.experiment().view.world_to_cube, 1.0);
}

TEST(WorldToCubeTool, KeyWPlaysToTheWorldAndBack) {
  Bench bench("ground");
  for (double end : {0.0, 1.0}) {
    bench.input().key('W', true);
    bench.input().key('W', false);
    double last = 1.0 - end;
    int steps = 0;
    for (; bench.experiment().view.world_to_cube != end && steps < 300; ++steps) {
      bench.frame();
      const double now = bench.experiment().view.world_to_cube;
      EXPECT_GE((now - last) * (end - 0.5), 0.0);
      last = now;
    }
    EXPECT_GT(steps, 20) << "gradually";
    EXPECT_EQ(bench.experiment().view.world_to_cube, end);
    bench.settle();
    EXPECT_EQ(bench.work().model().history().undo_count(), end == 0.0 ? 1u : 0u)
        << "there and back at once leaves nothing to undo";
  }
}

TEST(WorldToCubeTool, UndoOnTheWayStopsIt) {
  Bench bench("ground");
  bench.input().key('W', true);
  bench.input().key('W', false);
  for (int i = 0; i < 10; ++i) bench.frame();
  ASSERT_LT(bench.experiment().view.world_to_cube, 1.0);
  bench.key('Z', {true, false, false});
  bench.settle();
  EXPECT_EQ(bench.experiment().view.world_to_cube, 1.0);
}

}  // namespace
}  // namespace psm::test
