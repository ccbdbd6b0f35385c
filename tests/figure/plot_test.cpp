// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "markup.h"

namespace psm::testing {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Plot example() {
  Plot plot;
  plot.title = "Errors & <others>";
  plot.x.title = "x";
  plot.y = {"y", true, {}};
  plot.curves = {{"first", {{0, 1}, {1, 10}, {2, 100}}, 0x0072B2, "3 5", 3, true},
                 {"second", {{0, 2}, {1, -1}, {2, 101}}, 0xD55E00, "", 3, false},
                 {"nothing", {{0, NAN}, {1, 0}}, 0x222222, "", 3, false}};
  plot.levels = {{5, "level"}};
  return plot;
}

TEST(XmlText, HasNoControlCharacters) { EXPECT_EQ(xml_text("a\x01<b>\n\"&"), "a &lt;b&gt;\n&quot;&amp;"); }

TEST(Svg, IsWellFormedAndHoldsItsText) {
  const std::string svg = plot_svg(example(), true);
  EXPECT_EQ(unclosed_tags(svg), "");
  EXPECT_THAT(svg, HasSubstr("Errors &amp; &lt;others&gt;"));
  EXPECT_THAT(svg, HasSubstr(">first</text>"));
  EXPECT_THAT(svg, HasSubstr(">level</text>"));
  EXPECT_THAT(svg, HasSubstr("stroke-dasharray=\"3 5\""));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(svg, Not(HasSubstr(">nothing<")));
}

TEST(Svg, InAPageNamesNoAddress) { EXPECT_THAT(plot_svg(example(), false), Not(HasSubstr("http"))); }

TEST(Svg, KeepsLabelsApart) {
  Plot plot;
  for (int i = 0; i < 8; ++i) plot.curves.push_back({"curve" + std::to_string(i), {{0, 0}, {1, 1e-3 * i}}});
  plot.curves.push_back({"other", {{0, 5}, {1, 5}}});
  const std::string svg = plot_svg(plot, false);
  std::vector<double> heights;
  const std::regex label("y=\"([0-9.]+)\" font-weight=\"bold\" fill");
  for (std::sregex_iterator i(svg.begin(), svg.end(), label), end; i != end; ++i) heights.push_back(std::stod((*i)[1]));
  ASSERT_EQ(heights.size(), 9u);
  std::sort(heights.begin(), heights.end());
  for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_GE(heights[i] - heights[i - 1], 23.9);
  EXPECT_THAT(heights, Each(::testing::AllOf(::testing::Gt(0), ::testing::Lt(kPlotHeight))));
}

TEST(Svg, OfNothingIsAPicture) {
  EXPECT_EQ(unclosed_tags(plot_svg(Plot{}, true)), "");
  Plot point;
  point.x.log = point.y.log = true;
  point.curves = {{"point", {{3, 4}}}};
  EXPECT_EQ(unclosed_tags(plot_svg(point, true)), "");
  EXPECT_THAT(plot_svg(point, true), HasSubstr("<circle"));
}

}  // namespace
}  // namespace psm::testing
