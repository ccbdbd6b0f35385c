// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/facet_pick.h"

#include <gtest/gtest.h>

namespace psm {
namespace {

/// Seen along -z from above: pixel (50, 50) is the middle.
ViewPicture from_the_front() {
  ViewPicture picture;
  picture.clip_from_world = glm::dmat4(1.0);
  picture.clip_from_world[2][2] = -1.0;
  return picture;
}

TEST(FacetPick, TheNearestFacetIsNamedByItsPlane) {
  Analysis a;
  a.caster_body = box_body(glm::dvec3(-0.5), glm::dvec3(0.5));
  const auto hit = pick_facet(from_the_front(), a, {100, 100}, {50, 50});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, Role::caster_body);
  EXPECT_EQ(hit->text, "H: S max z");
  ASSERT_EQ(hit->outline.size(), 4u);
  for (const glm::dvec2& p : hit->outline) EXPECT_TRUE((p.x == 25 || p.x == 75) && (p.y == 25 || p.y == 75));
  EXPECT_FALSE(pick_facet(from_the_front(), a, {100, 100}, {10, 50}));
}

TEST(FacetPick, ReceiversWinWhereTheyCoincideAndLoseWhereTheyAreBehind) {
  Analysis a;
  a.caster_body = box_body(glm::dvec3(-0.5), glm::dvec3(0.5));
  a.receivers_body = box_body(glm::dvec3(-0.25, -0.25, -0.5), glm::dvec3(0.25, 0.25, 0.5));
  EXPECT_EQ(pick_facet(from_the_front(), a, {100, 100}, {50, 50})->body, Role::receivers_body);
  a.receivers_body = box_body(glm::dvec3(-0.25, -0.25, -0.5), glm::dvec3(0.25, 0.25, 0.4));
  EXPECT_EQ(pick_facet(from_the_front(), a, {100, 100}, {50, 50})->body, Role::caster_body);
}

TEST(FacetPick, FacetsThroughInfinityArePassedOver) {
  Analysis a;
  a.caster_body = box_body(glm::dvec3(-0.5), glm::dvec3(0.5));
  ViewPicture picture = from_the_front();
  picture.clip_from_world[2][3] = 4.0;  // w = 1 + 4 z: negative at z = -0.5
  const auto hit = pick_facet(picture, a, {100, 100}, {50, 50});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->text, "H: S max z");
}

}  // namespace
}  // namespace psm
