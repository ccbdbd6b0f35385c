// SPDX-License-Identifier: GPL-3.0-or-later
// Heat map, grid, error view and linked hovering in the window.
#include "harness.h"

namespace psm::test {
namespace {

TEST(TexelView, KeysAndTheTilesControlChooseWhatTheEyeViewShows) {
  Bench bench;
  const Image plain = bench.view(ViewId::eye);
  bench.key('E');
  EXPECT_EQ(bench.experiment().view.eye_overlay, EyeOverlay::texel_size);
  EXPECT_GT(differing_pixels(plain, bench.view(ViewId::eye), 8), 1000u);
  EXPECT_FALSE(bench.work().images().picture(ViewId::eye).legend.lines.empty());
  for (const EyeOverlay next : {EyeOverlay::anisotropy, EyeOverlay::errors, EyeOverlay::penumbra, EyeOverlay::none}) {
    bench.key('E');
    EXPECT_EQ(bench.experiment().view.eye_overlay, next);
  }
  bench.click(bench.at("tile.eye_overlay"));
  bench.click(bench.at("tile.eye_overlay=anisotropy"));
  EXPECT_EQ(bench.experiment().view.eye_overlay, EyeOverlay::anisotropy);
  bench.key('Z', {true, false, false});
  EXPECT_EQ(bench.experiment().view.eye_overlay, EyeOverlay::none);
}

TEST(TexelView, TheGridIsInThreeViewsAndLeavesTheMap) {
  Bench bench;
  const auto drawn = bench.work().views_drawn();
  bench.click(bench.at("tile.texel_grid", 0.1));
  EXPECT_TRUE(bench.experiment().view.texel_grid);
  EXPECT_EQ(bench.work().views_drawn(), drawn + 3);
  for (const ViewId id : {ViewId::world, ViewId::cube, ViewId::eye})
    EXPECT_GT(bench.work().images().picture(id).texel_step, 0) << name_of(id);
  bench.key('G');
  EXPECT_FALSE(bench.experiment().view.texel_grid);
}

TEST(TexelView, FittingTheViewsKeepsWhatTheyShow) {
  Bench bench;
  bench.key('E');
  bench.key('G');
  bench.drag(bench.at("view.world"), bench.at("view.world", 0.7));
  bench.key('F');
  EXPECT_EQ(bench.experiment().view.eye_overlay, EyeOverlay::texel_size);
  EXPECT_TRUE(bench.experiment().view.texel_grid);
  EXPECT_EQ(bench.experiment().view.world, OrbitSettings{});
}

TEST(TexelView, ErrorsAreTracedWhenNothingMoves) {
  Bench bench("ground", {"view.eye_overlay=errors", "shadow.resolution=128"});
  const auto traced = [&] { return bench.work().images().picture(ViewId::eye).cover.has_value(); };
  EXPECT_TRUE(traced());
  const glm::dvec2 from = bench.at("theta", 0.44), to = bench.at("theta", 0.6);
  bench.pass_time(2.0);
  bench.press(from);
  bench.move(to);
  EXPECT_FALSE(traced()) << "not while the slider moves";
  bench.release();
  EXPECT_TRUE(traced());
  const auto drawn = bench.work().views_drawn();
  bench.move(bench.at("view.world"));
  EXPECT_EQ(bench.work().views_drawn(), drawn) << "once is enough";
}

TEST(LinkedHovering, ShowsOneTexelEverywhereAndIsNoEdit) {
  Bench bench;
  bench.move({1.0, 1.0});
  EXPECT_FALSE(bench.work().probe());
  const Image before = bench.screen();
  const auto views = bench.work().views_drawn();
  const glm::dvec2 on_ground = bench.at("view.eye") + glm::dvec2(0, 40);
  bench.move(on_ground);
  ASSERT_TRUE(bench.work().probe());
  const Probe probe = *bench.work().probe();
  EXPECT_TRUE(probe.seen);
  EXPECT_TRUE(probe.inside_map);
  EXPECT_EQ(bench.work().views_drawn(), views) << "drawn over the pictures";
  EXPECT_EQ(bench.work().model().history().undo_count(), 0u);
  const Image after = bench.screen();
  for (const ViewId id : kMainViews) {  // something shows in each view
    const Rect r = bench.work_places().at(std::string("view.") + name_of(id));
    int changed = 0;
    for (int y = r.min.y; y < r.max.y; ++y)
      for (int x = r.min.x; x < r.max.x; ++x) {
        const std::size_t i = (std::size_t(y) * std::size_t(after.width) + std::size_t(x)) * 4;
        changed += !std::equal(&after.rgba[i], &after.rgba[i] + 3, &before.rgba[i]);
      }
    EXPECT_GT(changed, 50) << name_of(id);
  }
  bench.move({1.0, 1.0});
  EXPECT_FALSE(bench.work().probe());
}

TEST(LinkedHovering, GoesFromTheMapBackToTheSurface) {
  Bench bench;
  bench.move(bench.at("view.eye") + glm::dvec2(0, 40));
  ASSERT_TRUE(bench.work().probe());
  const Probe seen = *bench.work().probe();
  // Where that texel is in the map view.
  const glm::dmat4& clip = bench.work().images().picture(ViewId::map).clip_from_list;
  const double n = bench.experiment().shadow.resolution;
  const glm::dvec2 middle = (glm::dvec2(seen.texel) + 0.5) / n * 2.0 - 1.0;
  const glm::dvec4 q = clip * glm::dvec4(middle, 0, 1);
  const Rect map = bench.work_places().at("view.map");
  const glm::dvec2 size = map.size();
  bench.move(glm::dvec2(map.min) + 0.5 * glm::dvec2(1 + q.x / q.w, 1 - q.y / q.w) * size);
  ASSERT_TRUE(bench.work().probe());
  const Probe& back = *bench.work().probe();
  // The mouse is at whole pixels, of several texels each.
  const double texels_a_pixel = n / (0.5 * clip[0][0] * size.x * 2.0) + 1.0;
  EXPECT_LE(std::abs(back.texel.x - seen.texel.x), texels_a_pixel);
  EXPECT_LE(std::abs(back.texel.y - seen.texel.y), texels_a_pixel);
  EXPECT_LT(glm::length(back.receiver.position - seen.receiver.position), 0.2 * seen.r_i);
}

TEST(LinkedHovering, WorksInTheWorldView) {
  Bench bench("chessboard");
  bench.move(bench.at("view.world") + glm::dvec2(0, 30));
  ASSERT_TRUE(bench.work().probe());
  EXPECT_GT(bench.work().probe()->r_i, 0.0);
}

TEST(LinkedHovering, APixelCanBeKept) {
  Bench bench;
  bench.key('X');
  EXPECT_FALSE(bench.experiment().view.probe) << "the mouse is nowhere";
  bench.move(bench.at("view.eye") + glm::dvec2(0, 40));
  const Probe seen = *bench.work().probe();
  bench.key('X');
  ASSERT_TRUE(bench.experiment().view.probe);
  bench.move({1.0, 1.0});
  ASSERT_TRUE(bench.work().probe());
  EXPECT_EQ(bench.work().probe()->texel, seen.texel);
  EXPECT_EQ(bench.work().model().history().undo_count(), 1u);
  bench.key('X');
  EXPECT_FALSE(bench.experiment().view.probe);
  EXPECT_FALSE(bench.work().probe());
}

TEST(TexelView, HoveringCanBeTurnedOffAndKeptTexelsStay) {
  Bench bench;
  const Rect eye = bench.work_places().at("view.eye");
  bench.move({0.5 * (eye.min.x + eye.max.x), eye.min.y + 0.7 * eye.size().y});
  EXPECT_TRUE(bench.work().probe());
  Settings settings = bench.work().settings();
  settings.hovering = false;
  bench.work().set_settings(settings);
  bench.settle();
  EXPECT_FALSE(bench.work().probe());
  bench.key('X');
  EXPECT_TRUE(bench.work().probe()) << "key X keeps the one under the mouse";
  EXPECT_FALSE(read_settings(bench.folder() / "config" / "settings.txt").hovering);
}

}  // namespace
}  // namespace psm::test
