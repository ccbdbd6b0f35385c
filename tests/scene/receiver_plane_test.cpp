// SPDX-License-Identifier: GPL-3.0-or-later
// plane_optimal, best_plane, focus on visible points: on a flat ground, where the answers are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "math/texel_footprint.h"
#include "scene/analysis.h"
#include "scene/texel_sampling.h"

namespace psm {
namespace {

using glm::dvec3;

constexpr double kTanY = 0.57735026918962576;  // 30 degrees
const dvec3 kEye{0, 1.7, 0};

/// Ground at y = 0 on a box 10 thick, seen along -z from 1.7 above it: n = 1, f = 100, 640 x 360 pixels, map 1,024.
const Scene kGround = box_scene({-100, -10, -200}, {100, 0, 0});

Experiment sun_at(double theta_deg, bool behind, Technique technique) {
  Experiment x;
  x.camera.position = kEye;
  x.camera.target = kEye + dvec3(0, 0, -1);
  x.camera.near = 1;
  x.camera.far = 100;
  x.image = {640, 360};
  const double theta = glm::radians(theta_deg);
  x.light.to_light = {0, std::sin(theta), (behind ? 1 : -1) * std::cos(theta)};
  x.shadow.technique = technique;
  return x;
}

/// What the eye sees of the ground in the middle of each cell.
std::vector<SurfacePoint> ground_points(int columns, int rows) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < columns * rows; ++i) {
    const double x = (2.0 * (i % columns) + 1) / columns - 1, y = 1 - (2.0 * (i / columns) + 1) / rows;
    const dvec3 along(x * kTanY * 640 / 360, y * kTanY, -1);
    const double depth = along.y < 0 ? -kEye.y / along.y : 1e9;
    const dvec3 p = kEye + depth * along;
    if (depth <= 100 && std::abs(p.x) <= 100) points.push_back({dvec3(p.x, 0, p.z), {0, 1, 0}});
  }
  return points;
}

double p95(const Analysis& a) { return texel_percentile(ground_points(320, 180), *a.map_from_world, a, 0.95); }

double p95(const Experiment& x) { return p95(analyze(x, kGround, ground_points(kVisibleColumns, kVisibleRows))); }

bool has_note(const Analysis& a, const std::string& code) {
  return std::any_of(a.notes.begin(), a.notes.end(), [&](const Note& n) { return n.code == code; });
}

// The limit 640 / 1024, rows along the horizon, at every angle: each texel on the ground has the same size in the image.
TEST(PlaneOptimal, ReachesTheLimitWithTheSunAhead) {
  for (const double theta : {90.0, 75.0, 60.0, 45.0, 35.0, 30.0, 20.0, 10.0, 5.0}) {
    const Experiment x = sun_at(theta, false, Technique::plane_optimal);
    const Analysis a = analyze(x, kGround, ground_points(kVisibleColumns, kVisibleRows));
    ASSERT_EQ(a.technique_used, Technique::plane_optimal) << theta;
    double least = 1e9, most = 0;
    for (const SurfacePoint& p : ground_points(32, 18)) {
      const double m =
          texel_footprint<double>(a.clip_from_world(), *a.map_from_world, p.position, p.normal, 640.0, 360.0, 1024.0).m;
      least = std::min(least, m), most = std::max(most, m);
    }
    EXPECT_NEAR(most, 0.625, 1e-3) << theta;
    EXPECT_NEAR(least / most, 1, 1e-9) << theta;
  }
}

// Behind, that plane would cut the 10 thick box; around the visible ground alone it does not.
TEST(PlaneOptimal, ReachesTheLimitWithTheSunBehindWhereTheWindowHoldsWhatIsVisible) {
  for (const double theta : {90.0, 60.0, 35.0, 20.0, 5.0, 1.0}) {
    Experiment x = sun_at(theta, true, Technique::plane_optimal);
    x.shadow.focus = Focus::visible;
    EXPECT_NEAR(p95(x), 0.625, 1e-3) << theta;
  }
}

TEST(PlaneOptimal, TurnsTowardsTheUniformMapByNameAndContinuously) {
  const auto at = [](double theta) {
    return analyze(sun_at(theta, true, Technique::plane_optimal), kGround, ground_points(kVisibleColumns, kVisibleRows));
  };
  EXPECT_FALSE(has_note(at(60), "plane_turned"));
  EXPECT_TRUE(has_note(at(20), "plane_turned"));
  for (double theta = 25; theta < 60; theta += 1) EXPECT_NEAR(p95(at(theta)) / p95(at(theta + 0.01)), 1, 0.02) << theta;
}

TEST(PlaneOptimal, TakesTheGivenPlane) {
  Experiment x = sun_at(60, false, Technique::plane_optimal);
  x.shadow.receiver_plane = glm::dvec4(0, -3, 0, 0);
  EXPECT_NEAR(p95(analyze(x, kGround)), 0.625, 1e-3);
}

TEST(PlaneOptimal, FacesOfTheBoundsStandInForVisiblePoints) {
  const Scene floor_and_wall = box_scene({-5, 0, -30}, {5, 6, -1});
  Experiment x = sun_at(60, true, Technique::plane_optimal);
  const Analysis a = analyze(x, floor_and_wall);
  EXPECT_TRUE(has_note(a, "receiver_plane_from_bounds"));
  EXPECT_EQ(a.technique_used, Technique::plane_optimal);
}

TEST(PlaneOptimal, RefusesByNameWhereNoReceiverSeesTheLight) {
  Experiment x = sun_at(60, false, Technique::plane_optimal);
  x.light.to_light = {0, -1, 0.1};
  const Analysis a = analyze(x, kGround, ground_points(kVisibleColumns, kVisibleRows));
  EXPECT_TRUE(has_note(a, "no_receiver_plane"));
  EXPECT_EQ(a.technique_used, Technique::uniform);
  x.light.to_light = {0, 0, -1};
  x.shadow.receiver_plane = glm::dvec4(0, 1, 0, 0);
  EXPECT_TRUE(has_note(analyze(x, kGround), "receiver_holds_light"));
}

TEST(BestPlane, IsNoWorseThanAnyOtherOnTheGivenPoints) {
  for (const bool behind : {false, true})
    for (const double theta : {90.0, 45.0, 20.0, 5.0}) {
      const auto points = ground_points(kVisibleColumns, kVisibleRows);
      const auto size_of = [&](Technique t) {
        const Analysis a = analyze(sun_at(theta, behind, t), kGround, points);
        return texel_percentile(points, *a.map_from_world, a, 0.95);
      };
      const double best = size_of(Technique::best_plane);
      for (const Technique t :
           {Technique::uniform, Technique::psm, Technique::lispsm, Technique::gmnpr, Technique::plane_optimal})
        EXPECT_LE(best, size_of(t) * (1 + 1e-6)) << name_of(t) << " at " << theta << (behind ? " behind" : " ahead");
    }
}

TEST(BestPlane, FindsTheLimit) {
  for (const double theta : {90.0, 45.0, 5.0})
    EXPECT_NEAR(p95(sun_at(theta, false, Technique::best_plane)), 0.625, 2e-3) << theta;
}

TEST(BestPlane, SameInputsSameBits) {
  const auto points = ground_points(kVisibleColumns, kVisibleRows);
  const Experiment x = sun_at(33, true, Technique::best_plane);
  EXPECT_EQ(*analyze(x, kGround, points).map_from_world, *analyze(x, kGround, points).map_from_world);
}

TEST(BestPlane, WorksForPointLights) {
  Experiment x = sun_at(90, false, Technique::best_plane);
  x.light.type = LightType::point;
  x.light.position = {5, 20, -30};
  const double best = p95(x);
  x.shadow.technique = Technique::uniform;
  EXPECT_LT(best, p95(x));
}

TEST(Focus, TheWindowHoldsAllThatIsVisible) {
  Experiment x = sun_at(40, true, Technique::gmnpr);
  x.shadow.focus = Focus::visible;
  const Analysis a = analyze(x, kGround, ground_points(kVisibleColumns, kVisibleRows));
  EXPECT_LT(a.fitted_body.volume(), 0.1 * a.receivers_body.volume());
  for (const SurfacePoint& p : ground_points(320, 180)) {
    const glm::dvec4 q = *a.map_from_world * glm::dvec4(p.position, 1);
    ASSERT_GT(q.w, 0);
    EXPECT_LE(std::max(std::abs(q.x), std::abs(q.y)), q.w * (1 + 1e-9));
  }
}

TEST(Focus, WithoutVisiblePointsTheBoundsAreUsedByName) {
  Experiment x = sun_at(40, true, Technique::gmnpr);
  x.shadow.focus = Focus::visible;
  const Analysis a = analyze(x, kGround);
  EXPECT_TRUE(has_note(a, "visible_points_missing"));
  EXPECT_EQ(a.fitted_body.vertices, a.receivers_body.vertices);
}

TEST(NearFit, DepthNarrowsTheRangeAndNotTheWindow) {
  const Scene under_a_roof = box_scene({-100, -10, -200}, {100, 5, 0});
  Experiment x = sun_at(60, false, Technique::gmnpr);
  const Analysis bounds = analyze(x, under_a_roof, ground_points(kVisibleColumns, kVisibleRows));
  x.shadow.near_fit = NearFit::depth;
  const Analysis depth = analyze(x, under_a_roof, ground_points(kVisibleColumns, kVisibleRows));
  EXPECT_EQ(*bounds.near, 1);
  // The nearest ground in the picture's bottom row of cells lies at 1.7 / tan 30.
  EXPECT_NEAR(*depth.near, 1.7 / kTanY, 0.02);
  EXPECT_EQ(depth.fitted_body.vertices, bounds.fitted_body.vertices);
}

}  // namespace
}  // namespace psm
