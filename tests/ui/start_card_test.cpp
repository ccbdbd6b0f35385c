// SPDX-License-Identifier: GPL-3.0-or-later
// The first run's card says where to begin, once, and covers no picture.
#include "harness.h"

namespace psm::test {
namespace {

Bench first_run() { return Bench("chessboard", {}, {1280, 800}, {}, "", true); }

TEST(StartCard, CoversNoPictureAndNothingOfItIsCut) {
  for (const glm::ivec2 size : {glm::ivec2(1024, 768), glm::ivec2(1280, 800), glm::ivec2(1920, 1080)}) {
    Bench bench("chessboard", {}, size, {}, "", true);
    const Rect card = bench.work_places().at("start");
    for (const char* view : {"view.world", "view.cube", "view.map", "view.eye"})
      EXPECT_LE(bench.work_places().at(view).max.x, card.min.x) << view;
    EXPECT_TRUE(card.max.x <= size.x && card.max.y <= size.y && card.min.y >= 0);
    for (const char* part : {"start.lesson", "start.open", "start.help", "start.close"})
      EXPECT_LE(bench.work_places().at(part).max.y, card.max.y) << part;
  }
}

TEST(StartCard, GoesForGoodByKeyOrClick) {
  for (const int code : {key::escape, key::enter}) {
    Bench bench = first_run();
    ASSERT_TRUE(bench.on_screen("start"));
    bench.key('T');
    EXPECT_TRUE(bench.on_screen("start")) << "other keys do what they always do";
    bench.key(code);
    EXPECT_FALSE(bench.on_screen("start"));
    EXPECT_FALSE(read_settings(bench.folder() / "config" / "settings.txt").start_card);
  }
  Bench bench = first_run();
  bench.click(bench.at("view.world"));
  EXPECT_FALSE(bench.on_screen("start"));
}

TEST(StartCard, DoesWhatItOffers) {
  {
    Bench bench = first_run();
    bench.click(bench.at("start.lesson"));
    EXPECT_TRUE(bench.on_screen("lesson.pane"));
    EXPECT_FALSE(bench.on_screen("start"));
  }
  {
    Bench bench = first_run();
    bench.key(key::f1);
    EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::help);
    bench.key(key::escape);
    EXPECT_FALSE(bench.on_screen("start"));
  }
  Bench bench = first_run();
  bench.click(bench.at("start.open"));
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::open);
}

TEST(StartCard, IsThereOnlyWhereNothingWasAskedFor) {
  Bench bench("ground");
  EXPECT_FALSE(bench.on_screen("start"));
}

}  // namespace
}  // namespace psm::test
