// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "draw/theme.h"
#include "gl_fixture.h"

namespace psm {
namespace {

class Lists : public GlTest {
 protected:
  /// Coverage of a pixel by something black on white.
  static double ink(const Image& image, int x, int y) {
    const double black = role_line_color(Role::text).g * 255.0;
    return (255.0 - pixel(image, x, y).g) / (255.0 - black);
  }
  static double ink_of_column(const Image& image, int x) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) sum += ink(image, x, y);
    return sum;
  }
  static double total_ink(const Image& image) {
    double sum = 0.0;
    for (int x = 0; x < image.width; ++x) sum += ink_of_column(image, x);
    return sum;
  }
  static DrawLine line(glm::dvec2 a, glm::dvec2 b, double width) {
    return {glm::dvec4(a, 0, 1), glm::dvec4(b, 0, 1), Role::text, width};
  }
};

TEST_P(Lists, a_horizontal_line_is_as_wide_as_it_says) {
  for (const double width : {0.5, 1.0, 1.5, 2.5, 4.0}) {
    for (const double y : {0.0, 0.013, 0.7}) {
      DrawList list;
      list.lines = {line({-1, y}, {1, y}, width)};
      EXPECT_NEAR(ink_of_column(draw_list(list, {64, 64}), 30), width, 0.02 * width + 0.01) << y;
    }
  }
}

TEST_P(Lists, a_diagonal_line_is_as_wide_as_it_says) {
  DrawList list;
  list.lines = {line({-0.5, -0.5}, {0.5, 0.3}, 2.0)};
  const Image image = draw_list(list, {100, 100});
  const double slope = 0.8;
  double mean = 0.0;
  for (int x = 40; x < 60; ++x) mean += ink_of_column(image, x) / 20.0;
  EXPECT_NEAR(mean, 2.0 * std::hypot(1.0, slope), 0.05);
}

TEST_P(Lists, widths_follow_the_scale) {
  DrawList list;
  list.lines = {line({-1, 0}, {1, 0}, 1.5)};
  EXPECT_NEAR(ink_of_column(draw_list(list, {64, 64}, 2.0), 30), 3.0, 0.05);
}

TEST_P(Lists, lines_that_start_behind_the_eye_keep_their_width) {
  ViewPicture picture;
  picture.clip_from_list = glm::perspectiveRH_NO(1.0, 1.0, 0.1, 100.0);
  DrawLine along{{1, -1, 5, 1}, {1, -1, -50, 1}, Role::text, 2.0};
  along.a.w = 1.0;
  picture.list.lines = {along};
  const Image image = draw(empty_scene(), Analysis{}, picture, {200, 200});
  // Perpendicular to the diagonal from the lower right corner to the middle.
  double sum = 0.0;
  for (int x = 0; x < 200; ++x) sum += ink(image, x, 160);
  EXPECT_NEAR(sum, 2.0 * std::sqrt(2.0), 0.1);
}

TEST_P(Lists, dashes_leave_gaps_and_do_not_restart_in_pieces) {
  DrawList whole, pieces;
  whole.lines = {line({-0.9, 0.1}, {0.9, 0.1}, 2.0)};
  whole.lines[0].style = LineStyle::dashed;
  for (int i = 0; i < 6; ++i) {
    pieces.lines.push_back(line({-0.9 + 0.3 * i, 0.1}, {-0.9 + 0.3 * (i + 1), 0.1}, 2.0));
    pieces.lines.back().style = LineStyle::dashed;
  }
  const double one = total_ink(draw_list(whole, {300, 40}));
  EXPECT_NEAR(one, 0.6 * 2.0 * 270.0, 0.03 * 2.0 * 270.0);
  EXPECT_NEAR(total_ink(draw_list(pieces, {300, 40})), one, 0.03 * one);
}

TEST_P(Lists, lines_fade_towards_an_end) {
  DrawList list;
  list.lines = {line({-1, 0}, {1, 0}, 2.0)};
  list.lines[0].fade_b = 0.0;
  const Image image = draw_list(list, {200, 20});
  EXPECT_NEAR(ink_of_column(image, 50), 1.5, 0.05);
  EXPECT_NEAR(ink_of_column(image, 150), 0.5, 0.05);
}

TEST_P(Lists, an_arrow_ends_at_its_tip) {
  DrawList list;
  list.lines = {line({-0.5, 0}, {0.5, 0}, 2.0)};
  list.lines[0].arrow = true;
  const Image image = draw_list(list, {200, 40});
  EXPECT_LT(ink_of_column(image, 151), 0.1);
  EXPECT_GT(ink_of_column(image, 140), 5.0);
  EXPECT_NEAR(ink_of_column(image, 100), 2.0, 0.05);
}

TEST_P(Lists, hidden_parts_are_thinner_dashed_and_paler) {
  Scene scene = empty_scene();
  add_quad(scene, {-1, -1, 0}, {1, 0, 0}, {0, 2, 0});  // the left half, at depth 0
  ViewPicture bare, picture;
  picture.list.lines = {{{-1, 0, 0.5, 1}, {1, 0, 0.5, 1}, Role::text, 3.0}};
  const Image without = draw(scene, Analysis{}, bare, {200, 40});
  const Image with = draw(scene, Analysis{}, picture, {200, 40});
  double hidden = 0.0, seen = 0.0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 20; x < 80; ++x) hidden += (pixel(without, x, y).g - pixel(with, x, y).g) / 60.0;
    for (int x = 120; x < 180; ++x) seen += (pixel(without, x, y).g - pixel(with, x, y).g) / 60.0;
  }
  EXPECT_NEAR(seen, 3.0 * 221.0, 20.0);
  EXPECT_GT(hidden, 20.0);
  EXPECT_LT(hidden, 0.3 * seen);
}

TEST_P(Lists, lines_on_a_surface_are_seen) {
  Scene scene = empty_scene();
  add_quad(scene, {-4, 0, 4}, {8, 0, 0}, {0, 0, -8});
  ViewPicture bare, picture;
  picture.clip_from_world = picture.clip_from_list = bare.clip_from_world =
      glm::perspectiveRH_NO(0.8, 2.0, 0.1, 100.0) * glm::lookAtRH(glm::dvec3(0, 1, 8), glm::dvec3(0), glm::dvec3(0, 1, 0));
  picture.list.lines = {{{-3, 0, 3, 1}, {3, 0, -3, 1}, Role::text, 2.0}};
  const Image without = draw(scene, Analysis{}, bare, {200, 100});
  const Image with = draw(scene, Analysis{}, picture, {200, 100});
  double least = 1e9;
  for (int x = 80; x < 120; ++x) {
    double column = 0.0;
    for (int y = 0; y < 100; ++y) column += (pixel(without, x, y).g - pixel(with, x, y).g) / (pixel(without, 100, 50).g - 34.0);
    least = std::min(least, column);
  }
  EXPECT_GT(least, 1.7);  // solid everywhere: neither fought nor dashed
}

TEST_P(Lists, a_view_that_grows_is_drawn_whole) {
  DrawList list;
  list.lines = {{{-1, 0, 0, 1}, {1, 0, 0, 1}, Role::text, 4.0}};
  draw_list(list, {60, 40});
  const Image grown = draw_list(list, {240, 80});
  for (const int x : {10, 100, 230}) {
    EXPECT_EQ(pixel(grown, x, 5), glm::ivec3(255)) << x;
    EXPECT_LT(pixel(grown, x, 40).g, 80) << x;
  }
}

TEST_P(Lists, fills_blend) {
  DrawList list;
  list.fills = {{{{-1, -1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 1}, {-1, 1, 0, 1}}, Role::frustum, 0.25}};
  const glm::ivec3 got = pixel(draw_list(list, {8, 8}), 4, 4);
  const glm::vec3 wanted = 255.0f * glm::mix(glm::vec3(1.0f), role_color(Role::frustum), 0.25f);
  EXPECT_NEAR(got.r, wanted.r, 1.5);
  EXPECT_NEAR(got.g, wanted.g, 1.5);
  EXPECT_NEAR(got.b, wanted.b, 1.5);
}

TEST_P(Lists, fills_show_from_both_sides) {
  DrawList list;
  list.fills = {{{{-1, -1, 0, 1}, {-1, 1, 0, 1}, {1, 1, 0, 1}, {1, -1, 0, 1}}, Role::frustum, 0.25}};
  EXPECT_LT(pixel(draw_list(list, {8, 8}), 4, 4).r, 200);
}

TEST_P(Lists, points_are_discs_with_a_rim) {
  DrawList list;
  list.points = {{{0, 0, 0, 1}, Role::light, 8.0}};
  const Image image = draw_list(list, {41, 41});
  const glm::vec3 fill = 255.0f * role_color(Role::light);
  EXPECT_NEAR(pixel(image, 20, 20).r, fill.r, 2);
  EXPECT_NEAR(pixel(image, 20, 20).b, fill.b, 2);
  EXPECT_LT(pixel(image, 20 + 7, 20).r, 120);                // rim
  EXPECT_EQ(pixel(image, 20 + 10, 20), glm::ivec3(255));     // outside
  EXPECT_EQ(pixel(image, 20 + 7, 20 + 7), glm::ivec3(255));  // round
}

TEST_P(Lists, titles_and_labels_stay_on_their_plates) {
  ViewPicture picture;
  picture.title = "Würfel";
  const Image image = draw(empty_scene(), Analysis{}, picture, {200, 60});
  int inside = 0, outside = 0;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 200; ++x) {
      const bool plate = x >= 6 && x < 74 && y >= 6 && y < 30;
      (plate ? inside : outside) += pixel(image, x, y).g < 128;
    }
  }
  EXPECT_GT(inside, 60);
  EXPECT_EQ(outside, 0);
}

TEST_P(Lists, labels_are_read_where_they_were_placed) {
  for (const char* text : {"A", "λ = 0.02", "P′", "∞", "w ≤ 0", "\xff\xc3", "日"}) {
    DrawList list;
    list.labels = {{{0, 0, 0, 1}, text}};
    const Image image = draw_list(list, {160, 120});
    int dark = 0;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) dark += pixel(image, x, y).g < 128;
    }
    EXPECT_GT(dark, 8) << text;
  }
}

TEST_P(Lists, all_roles_are_seen_on_both_grounds) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    for (int i = 0; i <= int(Role::text); ++i) {
      EXPECT_GE(contrast(picture_line_color(Role(i), theme), picture_ground(theme)), 2.99f) << i;
      EXPECT_GE(contrast(picture_label_color(Role(i), theme), picture_ground(theme)), 4.49f) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(profiles, Lists, testing::Values(GlProfile::core_or_es, GlProfile::es));

}  // namespace
}  // namespace psm
