// SPDX-License-Identifier: GPL-3.0-or-later
// The profile says what a frame computed and why it left out the rest; visible points come from rays or from the card's depth.
#include <algorithm>

#include "harness.h"
#include "ui/keys.h"

namespace psm::test {
namespace {

const StageRun& busy(Bench& bench, Stage stage) { return bench.work().profile().busy()[std::size_t(stage)]; }

Settings with_points(Bench& bench, PointsSource source) {
  Settings settings = bench.work().settings();
  settings.points_from = source;
  return settings;
}

void use_depth(Bench& bench) {
  bench.work().set_settings(with_points(bench, PointsSource::depth));
  bench.settle();
}

TEST(Profile, AMovedLightLeavesTheVisiblePointsAlone) {
  Bench bench;
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.7), 0, 1);
  EXPECT_TRUE(busy(bench, Stage::analysis).ran);
  EXPECT_TRUE(busy(bench, Stage::map).ran);
  for (ViewId id : kMainViews) EXPECT_TRUE(busy(bench, stage_of(id)).ran) << name_of(stage_of(id));
  EXPECT_FALSE(busy(bench, Stage::points).ran);
  EXPECT_EQ(busy(bench, Stage::points).why, "unchanged: same eye, same scene");
  EXPECT_FALSE(busy(bench, Stage::scene).ran);
}

TEST(Profile, AHiddenViewIsNotDrawn) {
  Bench bench;
  bench.key('4');
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.7), 0, 1);
  EXPECT_TRUE(busy(bench, Stage::view_eye).ran);
  for (const Stage stage : {Stage::view_world, Stage::view_cube, Stage::view_map}) {
    EXPECT_FALSE(busy(bench, stage).ran) << name_of(stage);
    EXPECT_EQ(busy(bench, stage).why, "hidden");
  }
}

TEST(Profile, AViewThatTurnsLeavesMapAndAnalysisAlone) {
  Bench bench;
  bench.drag(bench.at("view.cube"), bench.at("view.cube", 0.7), 0, 1);
  EXPECT_TRUE(busy(bench, Stage::view_cube).ran);
  for (const Stage stage : {Stage::points, Stage::analysis, Stage::scene, Stage::map, Stage::view_world, Stage::view_eye}) {
    EXPECT_FALSE(busy(bench, stage).ran) << name_of(stage);
    EXPECT_FALSE(busy(bench, stage).why.empty()) << name_of(stage);
  }
}

TEST(Profile, AMapThatWouldComeOutAsItIsIsNotDrawn) {
  Bench bench;
  const int maps = bench.work().renderer().maps_drawn();
  const auto analyses = bench.work().model().analysis_revision();
  use_depth(bench);  // analyzed again, with points of another source that the uniform map has no use for
  EXPECT_GT(bench.work().model().analysis_revision(), analyses);
  EXPECT_EQ(bench.work().renderer().maps_drawn(), maps);
  EXPECT_FALSE(busy(bench, Stage::map).ran);
}

TEST(Profile, NoMapWhereNoCasterReachesAReceiver) {
  Bench bench("ground", {"camera.position=0,3,0", "camera.target=0,9,-1"});
  ASSERT_EQ(bench.work().renderer().map_triangles(), 0u);
  EXPECT_FALSE(busy(bench, Stage::map).ran);
  EXPECT_EQ(busy(bench, Stage::map).why, "no caster reaches a receiver");
}

TEST(Profile, HoveringComputesNothing) {
  Bench bench;
  const auto analyses = bench.work().model().analysis_revision(), points = bench.work().model().points_revision();
  bench.move(bench.at("view.eye"));
  bench.move(bench.at("view.eye", 0.6));
  bench.move(bench.at("view.map", 0.6));
  EXPECT_GT(bench.work().profile().frames_since_busy(), 2u);
  for (const Stage stage : {Stage::points, Stage::analysis, Stage::scene, Stage::map})
    EXPECT_FALSE(bench.work().profile().last()[std::size_t(stage)].ran) << name_of(stage);
  EXPECT_EQ(bench.work().model().analysis_revision(), analyses);
  EXPECT_EQ(bench.work().model().points_revision(), points);
}

TEST(Profile, F3ShowsAndHidesIt) {
  Bench bench;
  EXPECT_FALSE(bench.work().profile().watched());
  bench.key('H');
  bench.key(key::f3);
  EXPECT_TRUE(bench.work().profile().watched());
  const Rect pane = bench.work_places().at("pane.fields"), header = bench.work_places().at("profile");
  EXPECT_TRUE(header.min.y >= pane.min.y && header.max.y <= pane.max.y) << "the pane is there, scrolled to it";
  bench.key(key::f3);
  EXPECT_FALSE(bench.work().profile().watched());
}

TEST(Profile, ComesToRestWhileItIsWatched) {
  Bench bench;
  bench.key(key::f3);
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.6), 0, 1);
  EXPECT_FALSE(bench.work().needs_redraw());
  EXPECT_FALSE(bench.work().profile().waiting());
  const auto frames = bench.work().frames();
  bench.settle();
  EXPECT_EQ(bench.work().frames(), frames);
}

TEST(DepthReadback, SeesWhatRaysSee) {
  for (const char* scene : {"ground", "chessboard"}) {
    Bench bench(scene);
    const std::vector<SurfacePoint> rays = bench.work().model().visible_points();
    use_depth(bench);
    const std::vector<SurfacePoint>& depth = bench.work().model().visible_points();
    EXPECT_EQ(bench.work().model().points_sight(), bench.work().model().sight());
    ASSERT_GT(rays.size(), 200u);
    // Each point of one has one of the other close by, but for a few on silhouettes.
    const Bounds& bounds = bench.work().model().scene().bounds;
    const double size = glm::length(bounds.max - bounds.min);
    std::size_t lonely = 0;
    for (const SurfacePoint& p : depth) {
      const bool found = std::any_of(rays.begin(), rays.end(), [&](const SurfacePoint& q) {
        return glm::length(p.position - q.position) < 1e-4 * size && glm::dot(p.normal, q.normal) > 0.999;
      });
      lonely += found ? 0 : 1;
    }
    EXPECT_LE(lonely, rays.size() / 50) << scene;
    EXPECT_NEAR(double(depth.size()), double(rays.size()), double(rays.size()) / 50) << scene;
  }
}

TEST(DepthReadback, FitsAsRaysDoAndComesToRest) {
  Bench bench("chessboard", {"shadow.near_fit=depth", "shadow.focus=visible"});
  const double near = *bench.analysis().near, far = *bench.analysis().far;
  use_depth(bench);
  EXPECT_NEAR(*bench.analysis().near, near, 1e-3 * near);
  EXPECT_NEAR(*bench.analysis().far, far, 1e-3 * far);
  const auto analyses = bench.work().model().analysis_revision(), points = bench.work().model().points_revision();
  bench.work().wake();
  bench.settle();
  EXPECT_EQ(bench.work().model().analysis_revision(), analyses);
  EXPECT_EQ(bench.work().model().points_revision(), points) << "nobody asks twice for the same eye";
  // Another technique asks for nothing, a moved eye does.
  bench.key('T');
  EXPECT_EQ(bench.work().model().points_revision(), points);
  bench.drag(bench.at("view.eye"), bench.at("view.eye", 0.7), 0, 3);
  EXPECT_GT(bench.work().model().points_revision(), points);
  EXPECT_EQ(bench.work().model().points_sight(), bench.work().model().sight());
  bench.work().set_settings(with_points(bench, PointsSource::rays));
  bench.settle();
  EXPECT_EQ(bench.work().model().points_source(), PointsSource::rays);
}

TEST(DepthReadback, OtherScenesAndOtherEyesAreNeverMixed) {
  Bench bench("chessboard", {"shadow.near_fit=depth", "shadow.focus=visible"});
  use_depth(bench);
  bench.work().open("ground");
  bench.settle();
  EXPECT_EQ(bench.work().model().points_sight(), bench.work().model().sight());
  bench.key('Z', {true, false, false});
  EXPECT_EQ(bench.work().model().points_sight(), bench.work().model().sight());
  EXPECT_EQ(bench.experiment().scene.source, "chessboard");
}

TEST(DepthReadback, TheSettingIsRemembered) {
  Bench bench;
  bench.key(',', {true, false, false});
  bench.click(bench.at("settings.points=depth"));
  EXPECT_EQ(bench.work().settings().points_from, PointsSource::depth);
  bench.key(key::escape);
  EXPECT_EQ(read_settings(bench.folder() / "config" / "settings.txt").points_from, PointsSource::depth);
}

TEST(FitGain, VisiblePointsLieWithinTheBounds) {
  Bench bench("chessboard");
  const auto gain = fit_gain(bench.work().model());
  ASSERT_TRUE(gain);
  EXPECT_GE(gain->visible.min, gain->bounds.min * (1 - 1e-6));
  EXPECT_LE(gain->visible.max, gain->bounds.max * (1 + 1e-6));
  EXPECT_LT(gain->visible.size(), gain->bounds.size());
  ASSERT_TRUE(gain->m_bounds && gain->m_visible);
  EXPECT_GT(*gain->m_visible, 0.0);
}

}  // namespace
}  // namespace psm::test
