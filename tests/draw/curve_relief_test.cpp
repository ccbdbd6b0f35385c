// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/curve_relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "draw/curves_view.h"

namespace psm {
namespace {

const glm::dvec2 kPage(900.0, 600.0);

CurveSetting papers(Warp warp, double theta_deg = 60.0) {
  CurveSetting setting;
  setting.theta_deg = theta_deg;
  setting.current = warp;
  return setting;
}

double area(const DrawFill& fill) {
  double twice = 0.0;
  for (std::size_t i = 0; i < fill.corners.size(); ++i) {
    const glm::dvec4 &a = fill.corners[i], &b = fill.corners[(i + 1) % fill.corners.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

bool contains(const DrawFill& fill, const glm::dvec2& p) {
  for (std::size_t i = 0; i < fill.corners.size(); ++i) {
    const glm::dvec4 &a = fill.corners[i], &b = fill.corners[(i + 1) % fill.corners.size()];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0.0) return false;
  }
  return true;
}

std::multiset<std::string> words(const DrawList& list) {
  std::multiset<std::string> out;
  for (const DrawText& text : list.texts) out.insert(text.text);
  return out;
}

TEST(CurveRelief, EveryOutputDrawsItsFillsInTheirOrder) {
  const DrawList list = relief_list(papers(Warp::gmnpr), kPage);
  ASSERT_GT(list.fills.size(), 1000u);
  for (std::size_t i = 0; i < list.fills.size(); ++i) {
    const DrawFill& fill = list.fills[i];
    EXPECT_TRUE(fill.covers);
    EXPECT_GT(area(fill), 0.0) << "one winding";
    EXPECT_LT(std::abs(fill.corners[0].z), 1.0);
    if (i > 0) {
      EXPECT_LT(fill.corners[0].z, list.fills[i - 1].corners[0].z);
    }
    for (const glm::dvec4& corner : fill.corners) {
      EXPECT_TRUE(corner.x > 0.0 && corner.x < kPage.x && corner.y > 0.0 && corner.y < kPage.y);
      EXPECT_EQ(corner.z, fill.corners[0].z);
    }
  }
}

TEST(CurveRelief, WhatIsNearerCoversWhatIsHigherBehindIt) {
  // Along any column of the page, upwards from the front corner: floor's edge, curtain, relief, wall. The last fill at a pixel is
  // what shows there.
  const DrawList list = relief_list(papers(Warp::lispsm), kPage);
  const auto shown = [&](const glm::dvec2& p) {
    const auto found = std::find_if(list.fills.rbegin(), list.fills.rend(), [&](const DrawFill& f) { return contains(f, p); });
    return found == list.fills.rend() ? std::optional<Role>() : found->role;
  };
  glm::dvec2 front(0.0);
  for (const DrawLine& line : list.lines)
    for (const glm::dvec4& end : {line.a, line.b})
      if (end.y > front.y) front = end;
  EXPECT_EQ(shown(front + glm::dvec2(0.0, 4.0)), std::nullopt);
  EXPECT_EQ(shown(front + glm::dvec2(1.0, -4.0)), Role::neutral) << "the curtain, not the relief behind it";
  bool relief = false;
  for (double y = front.y - 4.0; y > 70.0; y -= 1.0) relief |= shown({front.x + 1.0, y}) == Role::curve_gmnpr;
  EXPECT_TRUE(relief);
}

TEST(CurveRelief, BothTechniquesOfTheFigureHaveOneScale) {
  const auto a = words(relief_list(papers(Warp::lispsm), kPage)), b = words(relief_list(papers(Warp::gmnpr), kPage));
  EXPECT_EQ(a, b);
  EXPECT_EQ(a.count("θ = 60°"), 1u);
  EXPECT_EQ(a.count("θ = φ = 30°"), 1u);
  EXPECT_GE(a.count("5") + a.count("10") + a.count("50"), 2u);
}

TEST(CurveRelief, TheLightsAngleIsALineOnIt) {
  for (const double theta : {20.0, 60.0, 120.0}) {
    const DrawList list = relief_list(papers(Warp::gmnpr, theta), kPage);
    EXPECT_TRUE(std::any_of(list.fills.begin(), list.fills.end(), [](const DrawFill& f) { return f.role == Role::light; }))
        << theta;
  }
}

}  // namespace
}  // namespace psm
