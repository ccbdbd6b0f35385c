// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw/theme.h"

namespace psm {
namespace {

constexpr int role_count = int(Role::text) + 1;

double linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

double luminance(const glm::vec3& c) { return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b); }

/// WCAG 2 contrast with white.
double contrast_on_white(const glm::vec3& c) { return 1.05 / (luminance(c) + 0.05); }

unsigned hex(const glm::vec3& c) {
  const glm::uvec3 b(glm::round(c * 255.0f));
  return b.r << 16 | b.g << 8 | b.b;
}

TEST(Palette, NamedRolesHaveTheDesignsColors) {
  EXPECT_EQ(hex(role_color(Role::frustum)), 0x0072B2u);
  EXPECT_EQ(hex(role_color(Role::light)), 0xE69F00u);
  EXPECT_EQ(hex(role_color(Role::caster_body)), 0xF0E442u);
  EXPECT_EQ(hex(role_color(Role::receivers_body)), 0x56B4E9u);
  EXPECT_EQ(hex(role_color(Role::vanishing_plane)), 0xCC79A7u);
  EXPECT_EQ(hex(role_color(Role::infinity)), 0xD55E00u);
  EXPECT_EQ(hex(role_color(Role::texel_grid)), 0x009E73u);
}

TEST(Palette, LinesAndTextReadOnWhite) {
  for (int i = 0; i < role_count; ++i) {
    EXPECT_GE(contrast_on_white(role_line_color(Role(i))), 3.0) << "role " << i;
    EXPECT_GE(contrast_on_white(role_text_color(Role(i))), 4.5) << "role " << i;
  }
}

TEST(Palette, LinesAndLabelsOfPicturesReadInFrontOfAClassInBothThemes) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    for (int i = 0; i < role_count; ++i) {
      EXPECT_GE(contrast(picture_line_color(Role(i), theme), picture_ground(theme)), 3.0f) << "role " << i;
      EXPECT_GE(contrast(picture_label_color(Role(i), theme), picture_ground(theme)), 7.0f) << "role " << i;
    }
  }
}

TEST(Palette, NoTwoRolesShareAColor) {
  for (int i = 0; i < role_count; ++i) {
    for (int j = 0; j < i; ++j) EXPECT_NE(hex(role_color(Role(i))), hex(role_color(Role(j)))) << "roles " << i << " and " << j;
  }
}

}  // namespace
}  // namespace psm
