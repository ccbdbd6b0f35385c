// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/seen_rect.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace psm::gl {
namespace {

constexpr glm::ivec2 kSize(200, 100);

PixelRect rect_of(const glm::dmat4& clip, const Bounds& box, int margin = 0) {
  SeenRect seen;
  seen.add_box(clip, box);
  return seen.pixels(kSize, margin);
}

glm::dmat4 from_origin(double near = 0.1) { return glm::perspectiveRH_NO(glm::radians(90.0), 1.0, near, 100.0); }

void expect_rect(const PixelRect& r, int left, int bottom, int right, int top) {
  EXPECT_EQ(r.left, left);
  EXPECT_EQ(r.bottom, bottom);
  EXPECT_EQ(r.right, right);
  EXPECT_EQ(r.top, top);
}

TEST(SeenRect, a_box_in_front_of_the_eye_is_where_its_corners_are) {
  // At depth 2 the picture spans [-2, 2]: a little more than its middle half, and its third quarter.
  const Bounds box{{-1.01, 0.02, -4}, {1.01, 1.02, -2}};
  expect_rect(rect_of(from_origin(), box), 49, 50, 151, 76);
  expect_rect(rect_of(from_origin(), box, 3), 46, 47, 154, 79);
}

TEST(SeenRect, a_box_behind_the_eye_or_without_extent_is_nowhere) {
  EXPECT_TRUE(rect_of(from_origin(), {{-1, -1, 1}, {1, 1, 2}}).empty());
  EXPECT_TRUE(rect_of(from_origin(), Bounds{}).empty());
  EXPECT_TRUE(rect_of(from_origin(), {{8, 8, -2}, {9, 9, -1}}).empty());  // in front, but beside the picture
}

TEST(SeenRect, a_floor_under_the_eye_reaches_to_the_lower_border_and_up_to_its_far_edge) {
  const PixelRect r = rect_of(from_origin(), {{-50, -2, -50}, {50, -1, 50}});
  EXPECT_EQ(r.left, 0);
  EXPECT_EQ(r.right, kSize.x);
  EXPECT_EQ(r.bottom, 0);
  EXPECT_EQ(r.top, 49);  // the far edge: y / w = -1 / 50
}

TEST(SeenRect, every_point_of_a_box_that_is_in_the_picture_lies_in_its_rectangle) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-3.0, 3.0), side(0.0, 2.0), share(0.0, 1.0);
  int in_picture = 0;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 corner(place(random), place(random), place(random));
    const Bounds box{corner, corner + glm::dvec3(side(random), side(random), side(random))};
    const glm::dmat4 clip = from_origin() * glm::lookAtRH(glm::dvec3(place(random), place(random), place(random)),
                                                          glm::dvec3(place(random), 0.0, 0.0), glm::dvec3(0, 1, 0));
    const PixelRect r = rect_of(clip, box, 1);
    for (int k = 0; k < 50; ++k) {
      const glm::dvec4 p =
          clip * glm::dvec4(glm::mix(box.min, box.max, glm::dvec3(share(random), share(random), share(random))), 1.0);
      if (!(p.w > 0.0) || std::abs(p.x) > p.w || std::abs(p.y) > p.w) continue;
      ++in_picture;
      const glm::dvec2 pixel = (glm::dvec2(p) / p.w * 0.5 + 0.5) * glm::dvec2(kSize);
      EXPECT_GE(pixel.x, r.left);
      EXPECT_LE(pixel.x, r.right);
      EXPECT_GE(pixel.y, r.bottom);
      EXPECT_LE(pixel.y, r.top);
    }
  }
  EXPECT_GT(in_picture, 500);
}

TEST(SeenRect, what_overflows_may_be_anywhere) {
  expect_rect(rect_of(1e300 * from_origin(), {{-1e10, -1, -4}, {1e10, 1, -2}}), 0, 0, kSize.x, kSize.y);
}

TEST(SeenRect, rectangles_meet_and_join) {
  const PixelRect a{0, 0, 10, 10}, b{5, 6, 20, 8}, apart{50, 50, 60, 60};
  expect_rect(common(a, b), 5, 6, 10, 8);
  EXPECT_TRUE(common(a, apart).empty());
  expect_rect(joined(a, b), 0, 0, 20, 10);
  expect_rect(joined({}, b), 5, 6, 20, 8);
}

}  // namespace
}  // namespace psm::gl
