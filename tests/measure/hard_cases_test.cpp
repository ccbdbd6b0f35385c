// SPDX-License-Identifier: GPL-3.0-or-later
// The hard cases against the table of answers beside this file: exact ones in every bit, float and double within their bounds.
#include "measure/hard_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "measure/hard_case_report.h"

namespace psm {
namespace {

struct Evaluated {
  HardCase row;
  CaseAnswer in_float, in_double;
};

/// Once for all tests.
const std::vector<Evaluated>& runs() {
  static const std::vector<Evaluated> all = [] {
    std::vector<Evaluated> out;
    for (HardCase& row : hard_cases()) {
      CaseAnswer in_float = row.in_float ? row.in_float() : CaseAnswer{}, in_double = row.in_double();
      out.push_back({std::move(row), in_float, in_double});
    }
    return out;
  }();
  return all;
}

std::string shown(const CaseAnswer& a) {
  char text[120];
  std::snprintf(text, sizeof text, "%.17g, %.3g texels, named: ", a.value, a.texels);
  return text + (a.named.empty() ? "no" : a.named);
}

std::string shown(const Evaluated& r) {
  return std::to_string(r.row.number) + " " + r.row.name + ": " + r.row.computed + "\n  float  " + shown(r.in_float) +
         "\n  double " + shown(r.in_double);
}

// ---- the table of answers, hard_cases.csv -----------------------------------------------------------------------------------

/// One line: what must come out, from FORMULAS and from hard_cases_answers.py, which shares no code with the program.
struct Answer {
  int number = 0;
  std::string name, quantity, invariant, exact, demand, in_double, in_float, verdict;
  std::string key() const { return std::to_string(number) + "; " + name + "; " + quantity; }
};

/// Fields of one line; in quotes where they hold a comma.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  EXPECT_FALSE(quoted) << line;
  return fields;
}

const std::vector<Answer>& answers() {
  static const std::vector<Answer> all = [] {
    std::ifstream file(PSMLAB_TEST_DATA "/measure/hard_cases.csv");
    std::vector<Answer> out;
    std::string line;
    std::getline(file, line);  // headings
    while (std::getline(file, line)) {
      const auto f = fields_of(line);
      EXPECT_EQ(f.size(), 9u) << line;
      if (f.size() == 9) out.push_back({std::stoi(f[0]), f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8]});
    }
    return out;
  }();
  return all;
}

/// Each line with the row of the program that it answers.
template <class F>
void for_each_answer(F f) {
  for (const Answer& a : answers())
    for (const Evaluated& r : runs())
      if (r.row.number == a.number && r.row.name == a.name && r.row.computed == a.quantity) f(a, r);
}

TEST(HardCases, TableAndProgramHaveTheSameRows) {
  std::multiset<std::string> table, program;
  std::set<int> numbers;
  for (const Answer& a : answers()) table.insert(a.key()), numbers.insert(a.number);
  for (const Evaluated& r : runs())
    program.insert(Answer{r.row.number, r.row.name, r.row.computed, {}, {}, {}, {}, {}, {}}.key());
  EXPECT_EQ(table, program);
  EXPECT_EQ(std::set<std::string>(table.begin(), table.end()).size(), table.size());
  for (int number = 1; number <= 43; ++number) EXPECT_EQ(numbers.count(number), 1u) << number;
  for (const Answer& a : answers()) EXPECT_FALSE(a.invariant.empty()) << a.key();
}

const char* demand_name(const HardCase& row) {
  if (row.demand == Demand::equals) return row.exact.value == 0 ? "absolute" : "relative";
  constexpr const char* names[] = {"", "texels", "at most", "above", "said", "refused"};
  return names[int(row.demand)];
}

std::string bound_text(double bound) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g", bound);
  return text;
}

/// The row's answer must meet the table's bound, in the arithmetic that may fail only where the verdict says so.
void hold(const HardCase& row, const CaseAnswer& given, const std::string& bound, bool may_fail, const std::string& shown_row) {
  HardCase held = row;
  const bool named = row.demand == Demand::said || row.demand == Demand::refused;
  if (named) held.reason = bound;
  EXPECT_EQ(meets(held, given, named ? 0 : std::stod(bound)), !may_fail) << shown_row;
}

TEST(HardCases, EveryRowMeetsItsAnswer) {
  for_each_answer([](const Answer& a, const Evaluated& r) {
    EXPECT_EQ(demand_name(r.row), a.demand) << shown(r);
    EXPECT_EQ(name_of(judge(r.row, r.in_float, r.in_double)), a.verdict) << shown(r);
    EXPECT_EQ(a.in_float.empty(), !r.row.in_float) << shown(r);
    if (r.row.reason.empty()) {
      EXPECT_EQ(bound_text(r.row.double_bound), a.in_double) << shown(r);
    }
    if (a.verdict == "naive form fails") return;  // in float, in double or in both
    hold(r.row, r.in_double, a.in_double, a.verdict == "known limit", shown(r));
    if (r.row.in_float) hold(r.row, r.in_float, a.in_float, a.verdict == "known limit" || a.verdict == "float fails", shown(r));
  });
}

// The two derivations agree in every bit of the double that they round to.
TEST(HardCases, ExactAnswersAreRoundedCorrectly) {
  int compared = 0;
  for_each_answer([&](const Answer& a, const Evaluated& r) {
    EXPECT_TRUE(r.row.exact.settled) << shown(r);
    if (a.exact.empty()) return;
    EXPECT_EQ(r.row.exact.value, std::strtod(a.exact.c_str(), nullptr)) << shown(r) << "\n  " << a.exact;
    ++compared;
  });
  EXPECT_GT(compared, 60);
}

// What is drawn must not depend on luck: wherever psmlab has a map, float holds it, but in the one row that says what no float
// can hold (0.01 from the eye in a scene of 1e5).
TEST(HardCases, NoMapOfPsmlabShowsAWrongShadow) {
  int maps = 0;
  for (const Evaluated& r : runs()) {
    if (r.row.form != Form::ours || r.row.known_limit || std::isnan(r.in_double.texels)) continue;
    ++maps;
    EXPECT_LE(r.in_double.texels, 0.02) << shown(r);
    const bool beyond_float = r.row.number == 0 && r.row.computed.find("as uploaded") != std::string::npos;
    if (r.row.in_float && !beyond_float) {
      EXPECT_LE(r.in_float.texels, 0.05) << shown(r);
    }
  }
  EXPECT_GT(maps, 15);
}

TEST(HardCases, NothingOfOursIsNotANumber) {
  for (const Evaluated& r : runs()) {
    if (r.row.form != Form::ours) continue;
    EXPECT_FALSE(std::isnan(r.in_double.value) && r.in_double.named.empty()) << shown(r);
    if (r.row.in_float) {
      EXPECT_FALSE(std::isnan(r.in_float.value) && r.in_float.named.empty()) << shown(r);
    }
  }
}

// DESIGN, conventions: one narrowing of the composed matrix. Two matrices in a row by way of clip space lose w where n << f.
TEST(HardCases, TwoMatricesInARowLoseWhatOneKeeps) {
  double composed = -1, by_clip = -1;
  for (const Evaluated& r : runs()) {
    if (r.row.number != 0) continue;
    if (r.row.computed.find("one composed") != std::string::npos) composed = r.in_float.value;
    if (r.row.computed.find("clip space") != std::string::npos) by_clip = r.in_float.value;
  }
  EXPECT_GE(composed, 0);
  EXPECT_LT(composed, 1e-4);
  EXPECT_GT(by_clip, 0.17);
}

// ---- demands and verdicts ---------------------------------------------------------------------------------------------

CaseAnswer gives(double value, double texels = 0) { return {value, texels, ""}; }

TEST(Meets, EveryDemandCanFail) {
  HardCase row;
  row.exact.value = 2;
  EXPECT_TRUE(meets(row, gives(2.0002), 1e-3));
  EXPECT_FALSE(meets(row, gives(2.01), 1e-3));
  EXPECT_FALSE(meets(row, gives(NAN), 1e-3));
  row.exact.value = INFINITY;
  EXPECT_TRUE(meets(row, gives(INFINITY), 0));
  EXPECT_FALSE(meets(row, gives(1e30), 1e-3));
  row.demand = Demand::texels;
  EXPECT_TRUE(meets(row, gives(0, 0.4), 0.5));
  EXPECT_FALSE(meets(row, gives(0, NAN), 0.5));
  row.demand = Demand::at_most;
  EXPECT_FALSE(meets(row, gives(NAN), 1));
  EXPECT_FALSE(meets(row, gives(2), 1));
  row.demand = Demand::above;
  EXPECT_FALSE(meets(row, gives(1), 1));
  EXPECT_FALSE(meets(row, {2, 0, "some_reason"}, 1));  // no answer, where one is due
  row.demand = Demand::refused;
  row.reason = "some_reason";
  EXPECT_TRUE(meets(row, {0, 0, "some_reason"}, 0));
  EXPECT_FALSE(meets(row, {0, 0, "another_reason"}, 0));
  EXPECT_FALSE(meets(row, gives(1), 0));
}

TEST(Judge, DoubleThatFailsIsBrokenUnlessTheFormIsNaive) {
  HardCase row;
  row.demand = Demand::at_most;
  row.double_bound = row.float_bound = 1;
  row.in_float = [] { return CaseAnswer{}; };
  EXPECT_EQ(judge(row, gives(1), gives(1)), Verdict::holds);
  EXPECT_EQ(judge(row, gives(2), gives(1)), Verdict::float_fails);
  EXPECT_EQ(judge(row, gives(1), gives(2)), Verdict::broken);
  row.known_limit = true;
  EXPECT_EQ(judge(row, gives(1), gives(2)), Verdict::known_limit);
  row.form = Form::naive;
  EXPECT_EQ(judge(row, gives(1), gives(2)), Verdict::naive_fails);
  EXPECT_EQ(judge(row, gives(2), gives(1)), Verdict::naive_fails);
}

// ---- what is printed --------------------------------------------------------------------------------------------------

const std::vector<MeasuredCase>& measured() {
  static const std::vector<MeasuredCase> cases = measure_hard_cases();
  return cases;
}
const Machine kMachine{"A \"fast\" processor, new", "Compiler 1"};

TEST(HardCaseReport, EveryEvaluationIsTimed) {
  for (const MeasuredCase& c : measured()) {
    EXPECT_GT(c.double_seconds, 0) << c.row.name;
    EXPECT_EQ(c.float_seconds > 0, bool(c.row.in_float)) << c.row.name;
    EXPECT_NE(c.verdict, Verdict::broken) << c.row.name << ": " << c.row.computed;
  }
}

TEST(HardCaseReport, TextNamesMachineAndVerdicts) {
  const std::string text = hard_cases_text(measured(), kMachine);
  EXPECT_EQ(text.rfind("# A \"fast\" processor, new; Compiler 1; ", 0), 0u);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 161u) << line;
  for (const MeasuredCase& c : measured()) EXPECT_THAT(text, ::testing::HasSubstr("\n      " + c.row.computed));
  for (const char* part : {"holds", "float fails", "refused by name", "naive form fails", "BROKEN: 0", "light_inside_receivers"})
    EXPECT_THAT(text, ::testing::HasSubstr(part));
}

TEST(HardCaseReport, JsonIsJsonAndRoundTrips) {
  const auto json = nlohmann::json::parse(hard_cases_json(measured(), kMachine));
  EXPECT_EQ(json["machine"]["cpu"], kMachine.cpu);
  ASSERT_EQ(json["hard_cases"].size(), measured().size());
  for (std::size_t i = 0; i < measured().size(); ++i) {
    const MeasuredCase& c = measured()[i];
    const auto& row = json["hard_cases"][i];
    EXPECT_EQ(row["case"], c.row.number);
    EXPECT_EQ(row["name"], c.row.name);
    EXPECT_EQ(row["verdict"], name_of(c.verdict));
    const auto& value = row["double"]["value"];
    if (value.is_number()) {
      EXPECT_EQ(value.get<double>(), c.in_double.value);
    } else {
      EXPECT_EQ(value.is_null(), std::isnan(c.in_double.value));
    }
    EXPECT_EQ(row["float"].is_null(), !c.row.in_float);
  }
}

TEST(HardCaseReport, CsvLinesHaveTheColumnsOfTheirHeading) {
  std::istringstream stream(hard_cases_csv(measured(), kMachine));
  std::string heading, line;
  std::getline(stream, heading);
  int rows = 0;
  for (; std::getline(stream, line); ++rows) EXPECT_EQ(fields_of(line).size(), fields_of(heading).size()) << line;
  EXPECT_EQ(rows, int(measured().size()));
}

}  // namespace
}  // namespace psm
