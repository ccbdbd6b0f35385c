// SPDX-License-Identifier: GPL-3.0-or-later
// What lies under a pixel and under a texel, and that each leads back to the other.
#include "measure/pick.h"

#include <gtest/gtest.h>

#include "scene/texel_sampling.h"
#include "scenes.h"

namespace psm {
namespace {

using glm::dvec2, glm::dvec3, glm::dvec4;

/// A plate of 2 x 2 at y = 1 over the middle of a ground, under a light from above, seen from the front and above.
class PickTest : public testing::Test {
 protected:
  PickTest() {
    add_ground(scene_, 5);
    add_ground(scene_, 1, 1.0);
    x_.camera.position = {0, 3, 6};
    x_.camera.target = {0, 0, 0};
    x_.light.to_light = {0.001, 1, 0.002};
    tracer_ = std::make_unique<RayTracer>(scene_);
    a_ = analyze(x_, scene_);
  }

  dvec2 pixel_of(const dvec3& p) const {
    const dvec4 q = a_.clip_from_world() * dvec4(p, 1);
    return {(0.5 + 0.5 * q.x / q.w) * x_.image.width, (0.5 - 0.5 * q.y / q.w) * x_.image.height};
  }
  dvec2 map_of(const dvec3& p) const {
    const dvec4 q = *a_.map_from_world * dvec4(p, 1);
    return dvec2(q) / q.w;
  }

  Scene scene_ = empty_scene();
  Experiment x_;
  Analysis a_;
  std::unique_ptr<RayTracer> tracer_;
};

TEST_F(PickTest, APixelLeadsToItsSurface) {
  const dvec3 wanted(2, 0, 1);
  const auto pick = pick_pixel(*tracer_, a_, pixel_of(wanted));
  ASSERT_TRUE(pick);
  EXPECT_LT(glm::length(pick->receiver.position - wanted), 1e-9);
  EXPECT_GT(pick->receiver.normal.y, 0.99);
  EXPECT_TRUE(pick->seen);
  EXPECT_FALSE(pick->occluder);
}

TEST_F(PickTest, AShadowedPixelNamesItsOccluder) {
  const dvec3 shadowed(0.5, 0, 0.95);
  const auto pick = pick_pixel(*tracer_, a_, pixel_of(shadowed));
  ASSERT_TRUE(pick);
  ASSERT_LT(glm::length(pick->receiver.position - shadowed), 1e-9);
  ASSERT_TRUE(pick->occluder);
  EXPECT_LT(glm::length(*pick->occluder - dvec3(0.501, 1, 0.952)), 1e-9);
}

TEST_F(PickTest, NothingUnderTheSkyOrBesideTheImage) {
  EXPECT_FALSE(pick_pixel(*tracer_, a_, {640, 1}));
  EXPECT_FALSE(pick_pixel(*tracer_, a_, {-3, 360}));
  EXPECT_FALSE(pick_pixel(*tracer_, a_, {640, 721}));
}

TEST_F(PickTest, ATexelLeadsBackToItsPixel) {
  const dvec3 lit(2, 0, 1);
  const auto pick = pick_texel(*tracer_, a_, 0, map_of(lit));
  ASSERT_TRUE(pick);
  EXPECT_LT(glm::length(pick->receiver.position - lit), 1e-6);
  EXPECT_TRUE(pick->seen);
  EXPECT_FALSE(pick->occluder);
}

TEST_F(PickTest, ATexelShowsTheReceiverBehindWhatIsHidden) {
  // The light meets the plate first; the eye, from below the plate, sees only the ground.
  x_.camera.position = {0, 0.5, 6};
  a_ = analyze(x_, scene_);
  const dvec3 ground(0.2, 0, 0.3);
  const auto pick = pick_texel(*tracer_, a_, 0, map_of(ground));
  ASSERT_TRUE(pick);
  EXPECT_LT(glm::length(pick->receiver.position - ground), 1e-6);
  ASSERT_TRUE(pick->occluder);
  EXPECT_NEAR(pick->occluder->y, 1.0, 1e-9);
}

TEST_F(PickTest, ATexelThatTheEyeSeesNothingOfStillHasItsFirstSurface) {
  x_.camera.position = {0, 3, 6};
  const dvec3 far_side(-4.9, 0, -4.9);
  Experiment narrow = x_;
  narrow.camera.vertical_fov_deg = 10;
  narrow.shadow.technique = Technique::uniform;
  a_ = analyze(x_, scene_);
  const auto map = a_.map_from_world;
  a_ = analyze(narrow, scene_);
  a_.map_from_world = map;
  const auto pick = pick_texel(*tracer_, a_, 0, map_of(far_side));
  ASSERT_TRUE(pick);
  EXPECT_LT(glm::length(pick->receiver.position - far_side), 1e-6);
  EXPECT_FALSE(pick->seen);
}

TEST_F(PickTest, WorksWithALightInTheSceneAndWithSixMaps) {
  x_.light.type = LightType::point;
  x_.light.position = {2, 0.5, 2};
  a_ = analyze(x_, scene_);
  ASSERT_TRUE(a_.cube_maps_from_world);
  const dvec3 ground(3, 0, 2);
  const auto there = pick_pixel(*tracer_, a_, pixel_of(ground));
  ASSERT_TRUE(there);
  const auto map = map_at(a_, ground);
  const dvec4 q = map->map_from_world * dvec4(ground, 1);
  const auto pick = pick_texel(*tracer_, a_, map->layer, dvec2(q) / q.w);
  ASSERT_TRUE(pick);
  EXPECT_LT(glm::length(pick->receiver.position - ground), 1e-6);
}

TEST_F(PickTest, NoMapHasNoTexels) {
  a_.map_from_world.reset();
  EXPECT_FALSE(pick_texel(*tracer_, a_, 0, {0, 0}));
  EXPECT_TRUE(pick_pixel(*tracer_, a_, pixel_of({2, 0, 1})));
}

}  // namespace
}  // namespace psm
