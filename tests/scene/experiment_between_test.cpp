// SPDX-License-Identifier: GPL-3.0-or-later
// On the way between two experiments: continuous members move, the others are there at once.
#include "scene/experiment_between.h"

#include <gtest/gtest.h>

#include <limits>

namespace psm {
namespace {

TEST(Between, BeginsAndEndsExactly) {
  Experiment from, to;
  to.light.to_light = {1, 0, 0};
  to.camera.far = 4321.0;
  to.shadow.depth_bias = 0.0;
  to.view.world_to_cube = 0.25;
  EXPECT_EQ(between(from, to, 1.0), to);
  const Experiment start = between(from, to, 0.0);
  EXPECT_LT(glm::length(start.light.to_light - from.light.to_light), 1e-12);
  EXPECT_DOUBLE_EQ(start.camera.far, from.camera.far);
  EXPECT_EQ(start.shadow, from.shadow);
}

TEST(Between, DirectionsTurnSteadily) {
  Experiment from, to;
  from.light.to_light = {2, 0, 0}, to.light.to_light = {0, 8, 0};
  const glm::dvec3 half = between(from, to, 0.5).light.to_light;
  EXPECT_NEAR(half.x, half.y, 1e-12);
  EXPECT_NEAR(glm::length(half), 4.0, 1e-12);
  to.light.to_light = {-2, 0, 0};
  EXPECT_NEAR(glm::length(between(from, to, 0.5).light.to_light), 2.0, 1e-12) << "the opposite is not reached through zero";
}

TEST(Between, DistancesThatSpanDecadesChangeByFactors) {
  Experiment from, to;
  from.camera.far = 10.0, to.camera.far = 1000.0;
  EXPECT_NEAR(between(from, to, 0.5).camera.far, 100.0, 1e-9);
  to.camera.far = std::numeric_limits<double>::infinity();
  EXPECT_EQ(between(from, to, 0.1).camera.far, to.camera.far);
}

TEST(Between, WhatHasNoMiddleIsThereAtOnce) {
  Experiment from, to;
  to.shadow.technique = Technique::psm, to.shadow.resolution = 64, to.light.type = LightType::point;
  to.light.position = {9, 9, 9};
  const Experiment early = between(from, to, 0.1);
  EXPECT_EQ(early.shadow, to.shadow);
  EXPECT_EQ(early.light, to.light);
  to.scene.source = "ground";
  EXPECT_EQ(between(from, to, 0.1), to);
}

TEST(Eased, IsGentleAtBothEndsAndStaysThere) {
  EXPECT_EQ(eased(-1.0), 0.0);
  EXPECT_EQ(eased(0.0), 0.0);
  EXPECT_EQ(eased(1.0), 1.0);
  EXPECT_EQ(eased(7.0), 1.0);
  EXPECT_LT(eased(0.01), 0.001);
  EXPECT_GT(eased(0.99), 0.999);
  for (double part = 0.0; part < 1.0; part += 0.125) EXPECT_LT(eased(part), eased(part + 0.125));
}

}  // namespace
}  // namespace psm
