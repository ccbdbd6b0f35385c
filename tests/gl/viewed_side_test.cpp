// SPDX-License-Identifier: GPL-3.0-or-later
// What the processor decides about a box before it is drawn; no OpenGL.
#include "gl/viewed_side.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace psm::gl {
namespace {

using glm::dmat4, glm::dvec3, glm::dvec4;

Bounds box(const dvec3& min, const dvec3& max) { return {min, max}; }

const dmat4 kEye = glm::perspectiveRH_NO(1.0, 1.5, 0.1, 100.0);  // at the origin, looking along -z

TEST(ViewedSide, WhatIsOutsideThePictureIsNotDrawn) {
  const ViewedSide side(kEye, 1.0);
  EXPECT_TRUE(side.of(box({-1, -1, -6}, {1, 1, -4})).at_all);
  EXPECT_TRUE(side.of(box({-1, -1, -6}, {1, 1, 4})).at_all) << "around the eye";
  EXPECT_FALSE(side.of(box({-1, -1, 4}, {1, 1, 6})).at_all) << "behind";
  EXPECT_FALSE(side.of(box({20, -1, -6}, {22, 1, -4})).at_all) << "to the right";
  EXPECT_FALSE(side.of(box({-1, -1, -300}, {1, 1, -200})).at_all) << "beyond far";
  EXPECT_FALSE(side.of(Bounds{}).at_all);
}

TEST(ViewedSide, KnowsWhatTheNearPlaneCuts) {
  const ViewedSide side(kEye, 1.0);
  EXPECT_TRUE(side.of(box({-1, -1, -6}, {1, 1, -4})).uncut);
  EXPECT_TRUE(side.of(box({-9, -1, -300}, {1, 1, -4})).uncut) << "the other planes may cut it";
  EXPECT_FALSE(side.of(box({-1, -1, -6}, {1, 1, -0.05})).uncut);
  EXPECT_FALSE(side.of(box({-1, -1, -6}, {1, 1, 1})).uncut);
}

TEST(ViewedSide, EachBoxIsDrawnOnTheSidesOfInfinityThatItReaches) {
  const dmat4 cube = glm::perspectiveRH_NO(1.0, 1.0, 1.0, 10.0), from_afar = glm::scale(dmat4(1.0), dvec3(0.2)) * cube;
  const CubeLimit limit{cube, 2.25, 3.0};
  const ViewedSide front(from_afar, 1.0, limit), back(from_afar, -1.0, limit);
  const Bounds inside = box({-1, -1, -9}, {1, 1, -5}), behind = box({-1, -1, 2}, {1, 1, 5}),
               across = box({-9, -9, -9}, {9, 9, 9});
  EXPECT_TRUE(front.of(inside).at_all);
  EXPECT_TRUE(front.of(inside).clear);
  EXPECT_FALSE(back.of(inside).at_all);
  EXPECT_FALSE(front.of(behind).at_all);
  EXPECT_TRUE(back.of(behind).at_all);
  for (const ViewedSide& side : {front, back}) {
    EXPECT_TRUE(side.of(across).at_all);
    EXPECT_FALSE(side.of(across).clear);
    EXPECT_FALSE(side.of(across).uncut);
  }
  // Behind the eye z' = (11 d - 20) / (9 d), d < 0, is beyond 11 / 9: a picture that ends at 1 shows nothing of it.
  EXPECT_FALSE(ViewedSide(cube, -1.0, limit).of(behind).at_all);
}

TEST(ViewedSide, BeyondTheLimitNothingIsDrawn) {
  const CubeLimit limit{dmat4(1.0), 0.75, 1.0};
  const ViewedSide side(glm::scale(dmat4(1.0), dvec3(0.1)), 1.0, limit);
  EXPECT_TRUE(side.of(box(dvec3(-0.5), dvec3(0.5))).clear);
  EXPECT_FALSE(side.of(box(dvec3(-0.5), dvec3(0.9))).clear);
  EXPECT_FALSE(side.of(box({1.5, -0.5, -0.5}, {2, 0.5, 0.5})).at_all);
}

/// No point that a box holds is lost: whatever a picture shows of it, the box is drawn; where it fades, the box is not clear.
TEST(ViewedSide, NoVisiblePointIsLost) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&](double size) { return size * dvec3(number(random), number(random), number(random)); };
  int visible = 0, fading = 0;
  for (int i = 0; i < 4000; ++i) {
    const dvec3 a = vector(8.0), b = vector(8.0);
    const Bounds bounds = box(glm::min(a, b), glm::max(a, b));
    const dmat4 cube = glm::perspectiveRH_NO(1.0, 1.0, 0.5, 20.0);
    const dmat4 clip = glm::perspectiveRH_NO(1.0, 1.0, 0.1, 20.0) *
                       glm::lookAtRH(vector(4.0) + dvec3(0, 0, 6), vector(1.0), dvec3(0, 1, 0)) * cube;
    const CubeLimit limit{cube, 2.25, 3.0};
    for (const double sign : {1.0, -1.0}) {
      const Shown shown = ViewedSide(clip, sign, limit).of(bounds);
      for (int k = 0; k < 8; ++k) {
        const dvec4 p(glm::mix(bounds.min, bounds.max, 0.5 + 0.5 * vector(1.0)), 1.0);
        const dvec4 q = sign * (clip * p), c = sign * (cube * p);
        if (!(q.w > 0.0) || glm::any(glm::greaterThan(glm::abs(dvec3(q)), dvec3(q.w)))) continue;
        const dvec3 place = glm::abs(dvec3(c)) / std::abs(c.w);
        const double reach = std::max({place.x, place.y, place.z});
        if (reach > 3.0) continue;
        ++visible;
        EXPECT_TRUE(shown.at_all);
        if (reach <= 2.25) continue;
        ++fading;
        EXPECT_FALSE(shown.clear);
      }
    }
  }
  EXPECT_GT(visible, 100);
  EXPECT_GT(fading, 10);
}

}  // namespace
}  // namespace psm::gl
