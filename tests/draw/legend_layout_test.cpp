// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/legend_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace psm {
namespace {

Legend heat_map() {
  Legend legend;
  legend.title = "m: largest extent of a texel, in pixels";
  for (const char* text : {"< 0.5", "0.5 to 1", "1 to 2", "2 to 4", "4 to 8", "> 8"})
    legend.entries.push_back({glm::vec3(0.5f), text, text[0] == '>'});
  legend.lines = {"median 1.3, 95 %: 4.2, largest 11", "62 % of the receivers are undersampled"};
  return legend;
}

glm::dvec2 text_size(const std::string& text) { return {9.0 * double(text.size()), 18.0}; }

TEST(LegendLayout, TakesAtMostAQuarterOfAnyViewOrHalfForTheColorsAlone) {
  for (int width = 20; width <= 1600; width += 20) {
    for (const double shape : {0.5, 0.75, 1.0}) {
      std::vector<TextBox> texts;
      std::vector<Plate> plates;
      std::vector<Mark> marks;
      const PictureFrame frame{{width, shape * width}, 1.0, Theme::light};
      const Occupied taken = lay_out_legend(heat_map(), frame, text_size, texts, plates, marks);
      const double most = texts.size() == heat_map().entries.size() ? 0.5 : 0.25;
      EXPECT_LE(taken.size.x * taken.size.y, most * frame.size.x * frame.size.y) << width << " x " << shape * width;
      EXPECT_EQ(texts.empty(), plates.empty());
    }
  }
}

TEST(LegendLayout, BlanksInARowBreakNoLine) {
  EXPECT_EQ(broken_lines("a  b ", 1.0, text_size), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(broken_lines("ab cd", 100.0, text_size), std::vector<std::string>{"ab cd"});
}

TEST(LegendLayout, ATextIsBrokenFirstWhereBlanksStandTogether) {
  EXPECT_EQ(broken_lines("ab cd    ef gh", 80.0, text_size), (std::vector<std::string>{"ab cd", "ef gh"}));
  EXPECT_EQ(broken_lines("ab  cd  ef", 60.0, text_size), (std::vector<std::string>{"ab  cd", "ef"}));
  EXPECT_EQ(broken_lines("ab cd  ef", 20.0, text_size), (std::vector<std::string>{"ab", "cd", "ef"}));
}

TEST(LegendLayout, AHeadingTakesNoLineOfALowViewThatHasRoomBesideItsTitle) {
  const auto texts_at = [](glm::dvec2 size) {
    ViewPicture picture;
    picture.title = "Eye";
    picture.legend = heat_map();
    std::vector<std::string> texts;
    for (const TextBox& box : annotate(picture, {size, 1.0, Theme::light}, text_size).texts) texts.push_back(box.text);
    return texts;
  };
  EXPECT_EQ(texts_at({900, 400}).front(), "Eye: " + heat_map().title);
  EXPECT_EQ(texts_at({900, 600}).front(), "Eye") << "not low";
  EXPECT_EQ(texts_at({500, 400}).front(), "Eye") << "no room";
}

TEST(LegendLayout, ALowViewHasNumbersBesideEachOther) {
  const auto plate_of = [&](double height) {
    std::vector<TextBox> texts;
    std::vector<Plate> plates;
    std::vector<Mark> marks;
    lay_out_legend(heat_map(), {{1000, height}, 1.0, Theme::light}, text_size, texts, plates, marks);
    return plates.front().size;
  };
  EXPECT_LT(plate_of(400).y, plate_of(800).y);
  EXPECT_LE(plate_of(400).x, 1000.0);
}

TEST(LegendLayout, NumbersLeaveTheGroundOfALowViewFree) {
  std::size_t all = 0;
  for (const double height : {400.0, 300.0, 220.0, 150.0}) {
    std::vector<TextBox> texts;
    std::vector<Plate> plates;
    std::vector<Mark> marks;
    Legend legend = heat_map();
    legend.title.clear();
    const Occupied taken = lay_out_legend(legend, {{900, height}, 1.0, Theme::light}, text_size, texts, plates, marks);
    const bool numbers = texts.size() > legend.entries.size();
    EXPECT_TRUE(!numbers || taken.size.y <= 0.2 * height) << height;
    all = std::max(all, texts.size());
    EXPECT_EQ(texts.size() == all, height >= 300.0) << height;
  }
}

TEST(LegendLayout, NumbersGoFirstThenTheHeadingAndColorsLast) {
  const auto texts_at = [](int width) {
    std::vector<TextBox> texts;
    std::vector<Plate> plates;
    std::vector<Mark> marks;
    lay_out_legend(heat_map(), {{width, 0.6 * width}, 1.0, Theme::light}, text_size, texts, plates, marks);
    return texts.size();
  };
  const std::size_t entries = heat_map().entries.size();
  bool colors_alone = false;
  for (int width = 100; width <= 1600; width += 10) {
    const std::size_t count = texts_at(width);
    EXPECT_TRUE(count == 0 || count >= entries) << width;
    colors_alone = colors_alone || count == entries;
  }
  EXPECT_TRUE(colors_alone);
  EXPECT_GE(texts_at(1600), entries + 3) << "a large view has room for everything";
}

TEST(LegendLayout, TheLastNumbersGoFirst) {
  bool first_alone = false;
  for (int width = 100; width <= 1600; width += 5) {
    std::vector<TextBox> texts;
    std::vector<Plate> plates;
    std::vector<Mark> marks;
    lay_out_legend(heat_map(), {{width, 0.9 * width}, 1.0, Theme::light}, text_size, texts, plates, marks);
    const auto begins = [&](const std::string& start) {
      return std::any_of(texts.begin(), texts.end(), [&](const TextBox& box) { return box.text.rfind(start, 0) == 0; });
    };
    EXPECT_TRUE(begins("median") || !begins("62 %")) << width;
    first_alone = first_alone || (begins("median") && !begins("62 %"));
  }
  EXPECT_TRUE(first_alone);
}

}  // namespace
}  // namespace psm
