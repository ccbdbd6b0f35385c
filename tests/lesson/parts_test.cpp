// SPDX-License-Identifier: GPL-3.0-or-later
// JSON with lines, Markdown, formulas: what they are made into.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lesson/formula.h"
#include "lesson/json_tree.h"
#include "lesson/markdown.h"
#include "lesson_fixture.h"

namespace psm::testing {
namespace {

using ::testing::HasSubstr;

TEST(Json, KeepsTheLineOfEachValue) {
  const auto tree = parse_json("{\n \"a\": [1,\n 2.5\n ],\n \"b\": {\"c\":\n null, \"d\": \"x\\ny\"}\n}");
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->line, 1);
  EXPECT_EQ(tree->at("a")->line, 2);
  EXPECT_EQ(tree->at("a.0")->line, 2);
  EXPECT_EQ(tree->at("a.1")->line, 3);
  EXPECT_EQ(tree->at("a.1")->number, 2.5);
  EXPECT_EQ(tree->at("b.c")->line, 6);
  EXPECT_EQ(tree->at("b.d")->text, "x\ny");
  EXPECT_EQ(tree->at("a.2"), nullptr);
  EXPECT_EQ(tree->at("b.d.e"), nullptr);
  EXPECT_EQ(tree->to_text(), R"({"a": [1, 2.5], "b": {"c": null, "d": "x\ny"}})");
}

TEST(Json, ErrorsStartWithTheLine) {
  const auto error = [](const char* text) { return parse_json(text).error().text; };
  EXPECT_EQ(error("{\n\"a\": 1,\n\"a\": 2}"), "3: a: given twice; allowed: once");
  EXPECT_EQ(error(""), "1: not JSON: it ends too early; allowed: all of it");
  EXPECT_THAT(error("{\n\n  a: 1}"), HasSubstr("3: not JSON: a is no value; allowed: "));
  EXPECT_THAT(error("[1e999]"), HasSubstr("1: "));
}

TEST(Markdown, BecomesBlocksAndRuns) {
  const auto blocks =
      parse_markdown("# A\n\nword *em* **st** `code` `=a.b`\nmore $x_1$ [to](lesson:b)\n\n1. one\n2. two\n   - in\n\n> said\n");
  ASSERT_TRUE(blocks);
  ASSERT_EQ(blocks->size(), 6u);
  EXPECT_EQ((*blocks)[0].heading, 1);
  const Block& text = (*blocks)[1];
  EXPECT_EQ(plain_text(text), "word em st code a.b more $x_1$ to");
  EXPECT_EQ(text.line, 3);
  const auto run = [&](const std::string& words) -> const Inline& {
    for (const Inline& r : text.runs)
      if (r.text == words) return r;
    ADD_FAILURE() << words;
    return text.runs[0];
  };
  EXPECT_TRUE(run("em").emphasis);
  EXPECT_TRUE(run("st").strong);
  EXPECT_EQ(run("code").kind, Inline::Kind::code);
  EXPECT_EQ(run("a.b").kind, Inline::Kind::live);
  EXPECT_EQ(run("x_1").kind, Inline::Kind::formula);
  EXPECT_EQ(run("x_1").line, 4);
  EXPECT_EQ(run("to").link, "lesson:b");
  EXPECT_EQ((*blocks)[2].marker, "1.");
  EXPECT_EQ((*blocks)[3].marker, "2.");
  EXPECT_EQ((*blocks)[4].marker, "\u2022");
  EXPECT_EQ((*blocks)[4].indent, 2);
  EXPECT_TRUE((*blocks)[5].quote);
}

TEST(Formulas, BecomeTrees) {
  const auto formula = parse_formula("\\lambda_1' = \\frac{\\sqrt{n f}}{17.22} + \\text{far away}^{2}");
  ASSERT_TRUE(formula);
  ASSERT_EQ(formula->parts.size(), 5u);
  const Formula& lambda = formula->parts[0];
  EXPECT_EQ(lambda.kind, Formula::Kind::scripts);
  EXPECT_EQ(lambda.parts[0].text, "λ");
  EXPECT_TRUE(lambda.parts[0].italic);
  EXPECT_EQ(lambda.parts[1].parts[0].text, "1");
  EXPECT_EQ(lambda.parts[2].parts[0].text, "′");
  EXPECT_EQ(formula->parts[1].role, Formula::Role::relation);
  EXPECT_EQ(formula->parts[2].kind, Formula::Kind::fraction);
  EXPECT_EQ(formula->parts[2].parts[1].parts[0].text, "17.22");
  EXPECT_EQ(formula->parts[4].parts[0].text, "far away");
}

TEST(Formulas, ErrorsSayWhatIsAllowed) {
  const auto error = [](const char* tex) { return parse_formula(tex).error().text; };
  EXPECT_EQ(error("F_{"), "formula \"F_{\": '}' is missing at the end of a group");
  EXPECT_EQ(error("a_1_2"), "formula \"a_1_2\": two scripts '_' on the same base");
  EXPECT_EQ(error("a}"), "formula \"a}\": '}' without its partner");
  EXPECT_EQ(error("^2"), "formula \"^2\": a script that stands on nothing");
  EXPECT_EQ(error("\\left( x"), "formula \"\\left( x\": \\left without \\right");
  EXPECT_EQ(error("x \\right)"), "formula \"x \\right)\": \\right without \\left");
  EXPECT_THAT(error("\\vec{x}"), HasSubstr("\\vec: no such command; allowed: "));
  EXPECT_THAT(error("λ"), HasSubstr("'λ' is not allowed in a formula; allowed: "));
  EXPECT_THAT(error(" "), HasSubstr("an empty formula"));
}

TEST(Quantities, ComeFromTheAnalysisAndTheModel) {
  const LessonFolder folder;
  const auto lesson = read_lesson(folder.path());
  ASSERT_TRUE(lesson) << lesson.error().text;
  const Analyze analyze = plain_surroundings().analyze;
  const auto loaded = load_members(members_at_start(*lesson, 0), "experiment", ".");
  ASSERT_TRUE(loaded);
  const LessonState state = state_of(*loaded, analyze(*loaded, false));
  const auto value = [&](const Quantity& quantity) { return std::get<double>(*evaluate(quantity, state, analyze)); };
  const double theta = value(AnalysisQuantity{"theta_deg", std::nullopt});
  AnalysisQuantity other{"theta_deg", ExperimentMembers{}};
  const auto members = members_of_link("set:light.to_light=0,1,1");
  ASSERT_TRUE(members);
  other.with = *members;
  EXPECT_GT(std::abs(value(other) - theta), 1.0);
  const CurveQuantity curve{Warp::uniform, {1, 100, 30}, 90, &CurveRow::F_max};
  EXPECT_EQ(value(curve), curve_row({1, 100, 30}, 90, Warp::uniform).F_max);
  EXPECT_FALSE(evaluate(AnalysisQuantity{"nowhere", std::nullopt}, state, analyze));

  Condition condition;
  condition.quantity = 2.0, condition.test = Condition::Test::above, condition.bound = 1.0;
  EXPECT_TRUE(*holds(condition, state, analyze));
  condition.bound = AnalysisQuantity{"error.texels", std::nullopt};  // null: neither above nor below
  EXPECT_FALSE(*holds(condition, state, analyze));
  EXPECT_EQ(live_text(state.analysis, "technique_used"), "gmnpr");
  EXPECT_EQ(live_text(state.analysis, "error.texels"), "-");
  EXPECT_EQ(live_text(state.analysis, "light_case.inside_receivers"), "no");
  EXPECT_EQ(live_text(state.analysis, "experiment.shadow.resolution"), "1024");
  EXPECT_EQ(live_text(state.analysis, "experiment.light.to_light"), "(0, 1, -0.5)");
}

}  // namespace
}  // namespace psm::testing
