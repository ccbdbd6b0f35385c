// SPDX-License-Identifier: GPL-3.0-or-later
// Segments and polygons torn at w = 0.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "draw/split_at_infinity.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4;

const Box kBox{dvec3(-3.0), dvec3(3.0)};

class Split : public testing::Test {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  dvec4 point(double w_low, double w_high) { return {uniform(-2, 2), uniform(-2, 2), uniform(-2, 2), uniform(w_low, w_high)}; }
  std::mt19937 random_{20021};
};

/// The t in [0, 1] at which the segment passes through p, by least squares on (1 - t) a + t b - p w = 0.
double parameter_of(const dvec4& a, const dvec4& b, const dvec3& p, double& residual) {
  const dvec3 at_a = dvec3(a) - p * a.w, at_b = dvec3(b) - p * b.w, d = at_b - at_a;
  const double t = -glm::dot(at_a, d) / glm::dot(d, d);
  residual = glm::length(at_a + t * d);
  return t;
}

TEST_F(Split, PiecesLieOnTheLineInOrderAndLeaveOutW0) {
  int torn = 0;
  for (int i = 0; i < 20000; ++i) {
    const dvec4 a = point(-1, 1), b = point(-1, 1);
    const auto pieces = split_segment(a, b, kBox);
    ASSERT_LE(pieces.size(), 2u);
    double last = -1e-9;
    for (const Piece& piece : pieces) {
      for (const dvec3& p : {piece.a, piece.b}) {
        double residual = 0.0;
        const double t = parameter_of(a, b, p, residual);
        EXPECT_LT(residual, 1e-9);
        EXPECT_GE(t, last - 1e-9) << "the segment's direction must be kept";
        EXPECT_LE(t, 1.0 + 1e-9);
        EXPECT_TRUE(kBox.contains(p));
        last = t;
      }
      // Both ends on the same side: no piece runs across the gap between the two.
      double r = 0.0;
      const double t0 = parameter_of(a, b, piece.a, r), t1 = parameter_of(a, b, piece.b, r);
      EXPECT_GE(glm::mix(a.w, b.w, t0) * glm::mix(a.w, b.w, t1), -1e-12);
    }
    torn += pieces.size() == 2;
  }
  EXPECT_GT(torn, 500) << "the test must meet what it is about";
}

TEST_F(Split, EndsInsideAreKeptAndNotMarkedAsCut) {
  for (int i = 0; i < 5000; ++i) {
    const dvec4 a = point(0.8, 1.0), b = point(0.8, 1.0);
    const auto pieces = split_segment(a, b, kBox);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_LT(glm::distance(pieces[0].a, dvec3(a) / a.w), 1e-12);
    EXPECT_LT(glm::distance(pieces[0].b, dvec3(b) / b.w), 1e-12);
    EXPECT_FALSE(pieces[0].cut_a || pieces[0].cut_b);
  }
}

TEST(SplitSegment, ThroughInfinityLeavesOnOneSideAndReturnsOnTheOther) {
  // From (0, 0, 2), with w < 0, away from the origin, through infinity, to (0, 0, -2).
  const auto pieces = split_segment({0, 0, -2, -1}, {0, 0, -2, 1}, kBox);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].a, dvec3(0, 0, 2));
  EXPECT_LT(glm::distance(pieces[0].b, dvec3(0, 0, 3)), 1e-12);
  EXPECT_LT(glm::distance(pieces[1].a, dvec3(0, 0, -3)), 1e-12);
  EXPECT_EQ(pieces[1].b, dvec3(0, 0, -2));
  EXPECT_TRUE(!pieces[0].cut_a && pieces[0].cut_b && pieces[1].cut_a && !pieces[1].cut_b);
}

TEST(SplitSegment, FromADirectionStartsAtTheWall) {
  const auto pieces = split_segment({1, 0, 0, 0}, {0, 1, 0, 1}, kBox);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_LT(glm::distance(pieces[0].a, dvec3(3, 1, 0)), 1e-12);
  EXPECT_EQ(pieces[0].b, dvec3(0, 1, 0));
}

TEST(SplitSegment, ScalesOfTheEndsDoNotMatter) {
  const dvec4 a(1, 2, 0, -1), b(0.5, 0, 0.25, 1);
  const auto plain = split_segment(a, b, kBox), scaled = split_segment(1e200 * a, 1e-200 * b, kBox);
  ASSERT_EQ(plain.size(), scaled.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_LT(glm::distance(plain[i].b, scaled[i].b), 1e-12);
}

TEST(SplitSegment, WhatCannotBeDrawnGivesNothing) {
  EXPECT_TRUE(split_segment({1, 0, 0, 0}, {0, 1, 0, 0}, kBox).empty());
  EXPECT_TRUE(split_segment(dvec4(0), dvec4(0), kBox).empty());
  EXPECT_TRUE(split_segment({NAN, 0, 0, 1}, {0, 0, 0, 1}, kBox).empty());
  EXPECT_TRUE(split_segment({INFINITY, 0, 0, 1}, {0, 0, 0, 1}, kBox).empty());
}

TEST_F(Split, PolygonPiecesAreInTheBoxAndOnTheirPlane) {
  int both = 0;
  for (int i = 0; i < 5000; ++i) {
    const dvec4 a = point(-1, 1), b = point(-1, 1), c = point(-1, 1);
    int sides = 0;
    for (int side : {1, -1}) {
      const auto polygon = clip_polygon({a, b, c}, kBox, side);
      sides += !polygon.empty();
      for (const dvec3& p : polygon) {
        EXPECT_TRUE(kBox.contains(p));
        EXPECT_LT(std::abs(glm::determinant(glm::dmat4(a, b, c, dvec4(p, 1)))), 1e-8);
      }
    }
    both += sides == 2;
  }
  EXPECT_GT(both, 100);
}

TEST(ClipPolygon, TheNegativeSideIsWoundTheOtherWay) {
  const std::vector<dvec4> corners{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
  std::vector<dvec4> negated;
  for (const dvec4& c : corners) negated.push_back(-c);
  const auto front = clip_polygon(corners, kBox), back = clip_polygon(negated, kBox, -1);
  ASSERT_EQ(front.size(), 3u);
  ASSERT_EQ(back.size(), 3u);
  const dvec3 n = glm::cross(front[1] - front[0], front[2] - front[0]), m = glm::cross(back[1] - back[0], back[2] - back[0]);
  EXPECT_EQ(n, dvec3(0, 0, 1));
  EXPECT_EQ(m, dvec3(0, 0, -1));
}

}  // namespace
}  // namespace psm
