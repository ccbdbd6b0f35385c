// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/annotation.h"

#include <gtest/gtest.h>

namespace psm {
namespace {

TEST(Annotation, ATitleGoesOnInTheNextLineOfANarrowView) {
  ViewPicture picture;
  picture.title = "Shadow map 1024 x 1024";
  const TextSize ten_a_letter = [](const std::string& text) { return glm::dvec2(10.0 * double(text.size()), 16.0); };
  const auto wide = annotate(picture, {{400, 300}, 1.0, Theme::light}, ten_a_letter);
  ASSERT_EQ(wide.texts.size(), 1u);
  const auto narrow = annotate(picture, {{180, 300}, 1.0, Theme::light}, ten_a_letter);
  ASSERT_EQ(narrow.texts.size(), 2u);
  EXPECT_EQ(narrow.texts[0].text, "Shadow map 1024");
  EXPECT_EQ(narrow.texts[1].text, "x 1024");
  EXPECT_EQ(narrow.texts[1].top_left.y, narrow.texts[0].top_left.y + 16.0);
  ASSERT_EQ(narrow.plates.size(), 1u);
  EXPECT_LE(narrow.plates[0].top_left.x + narrow.plates[0].size.x, 180.0);
  EXPECT_EQ(narrow.plates[0].size.y, wide.plates[0].size.y + 16.0);
}

}  // namespace
}  // namespace psm
