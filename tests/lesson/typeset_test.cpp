// SPDX-License-Identifier: GPL-3.0-or-later
// Text set into lines, measured with the real font.
#include "lesson/typeset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "draw/font_face.h"
#include "lesson/formula_box.h"

namespace psm::testing {
namespace {

constexpr double kSize = 20.0;

const FontMetrics& metrics() {
  static const FontFace font = [] {
    std::ifstream stream("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", std::ios::binary);
    return FontFace(std::string(std::istreambuf_iterator<char>(stream), {}));
  }();
  static const FontMetrics measured{[](const std::string& text, const Type& type) { return type.size * font.width(text); },
                                    [](const std::string& text, const Type& type) {
                                      const Reach reach = font.reach(text);
                                      return Reach{type.size * reach.above, type.size * reach.below};
                                    }};
  return measured;
}

TextPage set(const std::string& markdown, double width) {
  const auto blocks = parse_markdown(markdown);
  EXPECT_TRUE(blocks);
  return typeset(*blocks, {width, kSize, 1.4}, metrics(), [](const std::string& path) { return "<" + path + ">"; });
}

TypesetBox formula(const std::string& tex, bool display = false) {
  const auto parsed = parse_formula(tex);
  EXPECT_TRUE(parsed);
  TypesetBox line;
  for (const FormulaPiece& piece : formula_pieces(*parsed, kSize, display, Ink::text, metrics()))
    line.place(piece.box, {line.width, 0.0});
  return line;
}

const GlyphRun& run_of(const TypesetBox& box, const std::string& text) {
  for (const GlyphRun& run : box.runs)
    if (run.text == text) return run;
  ADD_FAILURE() << text << " is not set";
  return box.runs.front();
}

TEST(Text, StaysWithinTheWidthAndBreaksAtBlanksOnly) {
  const std::string words = "Over and over 0.5 and 17.22 texels, over (again and again), until 1.25 lines are full of it.";
  for (double width = 120; width < 600; width += 13) {
    const TextPage page = set(words, width);
    std::string text;
    double baseline = 0.0;
    for (const GlyphRun& run : page.ink.runs) {
      EXPECT_GE(run.baseline.y, baseline);
      baseline = run.baseline.y;
      text += (text.empty() ? "" : " ") + run.text;
      EXPECT_LE(run.baseline.x + metrics().width(run.text, run.type), width);
    }
    EXPECT_EQ(text, words);
    EXPECT_LE(baseline, page.height);
  }
}

TEST(Text, ShareABaselineInALineWhateverTheirFaces) {
  const TextPage page = set("plain **strong** *leaning* `code` $x$ `=a.b`", 2000);
  for (const GlyphRun& run : page.ink.runs) EXPECT_EQ(run.baseline.y, page.ink.runs.front().baseline.y) << run.text;
  EXPECT_EQ(run_of(page.ink, "strong").type.face, Face::bold);
  EXPECT_TRUE(run_of(page.ink, "leaning").type.oblique);
  EXPECT_EQ(run_of(page.ink, "code").type.face, Face::mono);
  EXPECT_TRUE(run_of(page.ink, "x").type.oblique);
  EXPECT_EQ(run_of(page.ink, "<a.b>").ink, Ink::live);
}

TEST(Text, AWordNoLineCanHoldIsDivided) {
  const TextPage page = set("https://an.address.without.any.blank.in.it/that/goes/on/and/on", 90);
  EXPECT_GT(page.ink.runs.size(), 4u);
  for (const GlyphRun& run : page.ink.runs) EXPECT_LE(run.baseline.x + metrics().width(run.text, run.type), 90.0);
}

TEST(Text, ItemsAreIndentedBehindTheirMarkers) {
  const TextPage page = set("1. first\n2. second\n   - inner\n", 400);
  const double marker = run_of(page.ink, "1.").baseline.x, first = run_of(page.ink, "first").baseline.x;
  EXPECT_LT(marker, first);
  EXPECT_EQ(first, run_of(page.ink, "second").baseline.x);
  EXPECT_LT(first, run_of(page.ink, "inner").baseline.x);
  EXPECT_EQ(run_of(page.ink, "2.").baseline.y, run_of(page.ink, "second").baseline.y);
}

TEST(Text, ALinkIsOneAreaForEachOfItsLines) {
  const TextPage wide = set("see [all of these words](lesson:a) there", 2000),
                 narrow = set("see [all of these words](lesson:a) there", 130);
  ASSERT_EQ(wide.links.size(), 1u);
  EXPECT_EQ(wide.links[0].target, "lesson:a");
  EXPECT_GT(narrow.links.size(), 1u);
}

TEST(AFormula, SetsScriptsSmallerAboveAndBelow) {
  const TypesetBox box = formula("x_i^{2^k}");
  const GlyphRun &base = run_of(box, "x"), &below = run_of(box, "i"), &above = run_of(box, "2"), &higher = run_of(box, "k");
  EXPECT_EQ(base.type.size, kSize);
  EXPECT_DOUBLE_EQ(below.type.size, 0.7 * kSize);
  EXPECT_DOUBLE_EQ(above.type.size, 0.7 * kSize);
  EXPECT_DOUBLE_EQ(higher.type.size, 0.5 * kSize);
  EXPECT_GT(below.baseline.y, base.baseline.y);
  EXPECT_LT(above.baseline.y, base.baseline.y);
  EXPECT_LT(higher.baseline.y, above.baseline.y);
}

TEST(AFormula, PutsAFractionAroundItsBar) {
  const TypesetBox box = formula("\\frac{n + f}{g}", true);
  ASSERT_EQ(box.rules.size(), 1u);
  const Rule& bar = box.rules[0];
  const double thickness = bar.max.y - bar.min.y;
  EXPECT_GE(thickness, 1.0);
  EXPECT_LT(run_of(box, "n").baseline.y, bar.min.y);
  EXPECT_GT(run_of(box, "g").baseline.y - metrics().reach("g", run_of(box, "g").type).above, bar.max.y);
  EXPECT_GT(box.ascent, 0.8 * kSize);
  EXPECT_LE(bar.max.x, box.width);
}

TEST(AFormula, CoversWhatIsUnderARoot) {
  const TypesetBox box = formula("\\sqrt{n f}");
  ASSERT_EQ(box.rules.size(), 1u);
  ASSERT_EQ(box.strokes.size(), 1u);
  EXPECT_LT(box.rules[0].min.x, run_of(box, "n").baseline.x);
  EXPECT_GE(box.rules[0].max.x, run_of(box, "f").baseline.x + metrics().width("f", run_of(box, "f").type));
  EXPECT_LT(box.rules[0].max.y, -metrics().reach("f", run_of(box, "f").type).above);
}

TEST(AFormula, GrowsItsFencesWithTheirContent) {
  EXPECT_TRUE(formula("\\left( x \\right)").strokes.empty());
  const TypesetBox tall = formula("\\left( \\frac{a}{b} \\right)", true);
  ASSERT_EQ(tall.strokes.size(), 2u);
  EXPECT_GE(-tall.strokes[0].points.front().y, -run_of(tall, "a").baseline.y);
}

TEST(AFormula, BreaksAtRelationsOnly) {
  const auto parsed = parse_formula("a + b = \\frac{c = d}{e} \\le (f = g)");
  ASSERT_TRUE(parsed);
  const auto pieces = formula_pieces(*parsed, kSize, false, Ink::text, metrics());
  ASSERT_EQ(pieces.size(), 4u);  // each of = <= = stands between two
  EXPECT_EQ(pieces[0].box.runs.back().text, "=");
  EXPECT_EQ(pieces[1].box.runs.back().text, "≤");
  const TextPage page = set("$a + b + c + d = e + f + g + h$", 120);
  double first_line = page.ink.runs.front().baseline.y;
  EXPECT_EQ(run_of(page.ink, "=").baseline.y, first_line);
  EXPECT_GT(run_of(page.ink, "e").baseline.y, first_line);
}

TEST(AFormula, SetsPrimesAtFullSizeOnItsBaseline) {
  const TypesetBox box = formula("x'_v + 1");
  EXPECT_EQ(run_of(box, "′").type.size, run_of(box, "x").type.size);
  EXPECT_EQ(run_of(box, "′").baseline.y, run_of(box, "x").baseline.y);
  EXPECT_GT(run_of(box, "v").baseline.y, run_of(box, "x").baseline.y);
}

TEST(ADisplayedFormula, BreaksBetweenStatementsFirst) {
  const std::string two = "$$a = b + c \\quad d = e$$";
  const auto line_of = [&](const TextPage& page, const char* text) { return run_of(page.ink, text).baseline.y; };
  const TextPage wide = set(two, 400), narrow = set(two, 100);
  EXPECT_EQ(line_of(wide, "d"), line_of(wide, "a"));
  EXPECT_EQ(line_of(narrow, "c"), line_of(narrow, "a"));
  EXPECT_EQ(line_of(narrow, "e"), line_of(narrow, "d"));
  EXPECT_GT(line_of(narrow, "d"), line_of(narrow, "a"));
}

TEST(ADisplayedFormula, StandsInTheMiddleOfALineOfItsOwn) {
  const TextPage page = set("before $$x = y$$ after", 400);
  const GlyphRun &x = run_of(page.ink, "x"), &y = run_of(page.ink, "y");
  const double right = y.baseline.x + metrics().width("y", y.type);
  EXPECT_NEAR(x.baseline.x, 400 - right, 1.0);
  EXPECT_LT(run_of(page.ink, "before").baseline.y, x.baseline.y);
  EXPECT_LT(x.baseline.y, run_of(page.ink, "after").baseline.y);
}

}  // namespace
}  // namespace psm::testing
