// SPDX-License-Identifier: GPL-3.0-or-later
// Pages as SVG and PDF, and parameters in PNG files.
#include "figure/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "figure/png.h"
#include "markup.h"

namespace psm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Page page_of(std::vector<PageItem> items) {
  Page page{{200.0, 100.0}, glm::vec3(1.0f), {}, "a < b & c", "{\"near\": 1}"};
  page.panels.push_back({{0.0, 0.0}, page.size, std::move(items)});
  return page;
}

Page one_of_each() {
  return page_of({PageImage{{0, 0}, {50, 50}, {2, 2, std::vector<std::uint8_t>(16, 128)}},
                  PageLine{{10, 10}, {90, 10}, {1, 0, 0}, 1.0, 1.0, 2.0, 5.0, 4.0},
                  PageLine{{10, 20}, {90, 20}, {1, 0, 0}, 1.0, 0.0, 2.0}, PagePolygon{{{0, 0}, {9, 0}, {0, 9}}, {0, 0, 1, 0.5}},
                  PageBox{{20, 20}, {30, 12}, 4.0, {1, 1, 1, 0.85}, {0, 0, 0, 0.2}, 1.0},
                  PageText{{20, 20}, {60, 16}, "\u03b8 = 60\u00b0 <&>", {0, 0, 0}}});
}

TEST(PageSvg, IsWellFormedAndHoldsEverythingAsWhatItIs) {
  const std::string svg = page_svg(one_of_each());
  EXPECT_EQ(testing::unclosed_tags(svg), "");
  EXPECT_THAT(svg, HasSubstr(">\u03b8 = 60\u00b0 &lt;&amp;&gt;</text>"));
  EXPECT_THAT(svg, HasSubstr("font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\""));
  EXPECT_THAT(svg, HasSubstr("stroke-dasharray=\"5 4\""));
  EXPECT_THAT(svg, HasSubstr("<linearGradient"));
  EXPECT_THAT(
      svg, HasSubstr("<polygon points=\"0,0 9,0 0,9\" fill=\"#0000FF\" fill-opacity=\"0.5\" shape-rendering=\"crispEdges\"/>"));
  EXPECT_THAT(svg, HasSubstr("href=\"data:image/png;base64,iVBORw0KGgo"));
  EXPECT_THAT(svg, HasSubstr("<title>a &lt; b &amp; c</title>"));
  EXPECT_THAT(svg, HasSubstr("<metadata>{&quot;near&quot;: 1}</metadata>"));
}

TEST(PageSvg, SetsTypeByTheTextsHeight) {
  const std::string svg = page_svg(page_of({PageText{{20, 40}, {60, 16}, "x", {0, 0, 0}}}));
  EXPECT_THAT(svg, HasSubstr("<text x=\"50\" y=\"52.75\" font-size=\"13.74\""));
}

TEST(PageSvg, HasNoBackgroundWhereItIsTransparent) {
  Page page = page_of({});
  EXPECT_THAT(page_svg(page), HasSubstr("width=\"100%\" height=\"100%\""));
  page.background.reset();
  EXPECT_THAT(page_svg(page), Not(HasSubstr("width=\"100%\"")));
}

TEST(PageSvg, CutsEachPanelOff) {
  Page page = page_of({});
  page.panels.push_back({{100.0, 0.0}, {100.0, 100.0}, {PageLine{{90, 5}, {300, 5}}}});
  const std::string svg = page_svg(page);
  EXPECT_THAT(svg, HasSubstr("<clipPath id=\"panel2\"><rect x=\"100\" y=\"0\" width=\"100\" height=\"100\"/></clipPath>"));
  EXPECT_THAT(svg, HasSubstr("<g clip-path=\"url(#panel2)\">"));
}

TEST(PagePdf, IsAPdfWithAnEmbeddedTypefaceOrSaysWhyNot) {
  const auto pdf = page_pdf(one_of_each());
  if (pdf_missing()) {
    ASSERT_FALSE(pdf);
    EXPECT_THAT(pdf.error().text, HasSubstr("libcairo2-dev"));
    return;
  }
  ASSERT_TRUE(pdf) << pdf.error().text;
  EXPECT_THAT(*pdf, StartsWith("%PDF-1."));
  EXPECT_EQ(pdf->substr(pdf->size() - 6), "%%EOF\n");
  EXPECT_THAT(*pdf, HasSubstr("/FontFile2")) << "no typeface embedded";
  EXPECT_THAT(*pdf, HasSubstr("/ToUnicode")) << "its text cannot be searched";
  EXPECT_THAT(*pdf, HasSubstr("/MediaBox [ 0 0 150 75 ]")) << "three quarters of a point a pixel";
}

TEST(Png, HoldsItsParametersBetweenHeaderAndPixels) {
  const Image image{2, 1, {255, 0, 0, 255, 0, 255, 0, 128}};
  const std::string plain = png_bytes(image), with = png_bytes(image, "{\"near\": 1}");
  const std::string text = std::string("tEXtpsmlab") + '\0' + "{\"near\": 1}";
  const std::size_t at = with.find(text);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(with.substr(0, 33), plain.substr(0, 33));
  EXPECT_EQ(with.substr(at + text.size() + 4), plain.substr(33));
  EXPECT_EQ(with.substr(at - 4, 4), std::string("\0\0\0\x12", 4));
  EXPECT_EQ(with.substr(at + text.size(), 4), "\x0C\xCD\x70\x52") << "the checksum that zlib computes";
}

}  // namespace
}  // namespace psm
