// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab measure, by running the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "run_program.h"

namespace psm::testing {
namespace {

using ::testing::HasSubstr;

TEST(Measure, PrintsTheHardCasesInThreeFormats) {
  const Outcome text = run_program({"measure", "--hard-cases"}), csv = run_program({"measure", "--hard-cases", "--csv"}),
                json = run_program({"measure", "--hard-cases", "--json"});
  for (const Outcome* run : {&text, &csv, &json}) {
    EXPECT_EQ(run->code, 0) << run->err;
    EXPECT_EQ(run->err, "");
  }
  EXPECT_THAT(text.out, HasSubstr("BROKEN: 0"));
  EXPECT_EQ(csv.out.rfind("case,name,computed,", 0), 0u);
  std::set<int> numbers;
  const auto parsed = nlohmann::json::parse(json.out);
  for (const auto& row : parsed["hard_cases"]) numbers.insert(row["case"].get<int>());
  for (int number = 1; number <= 43; ++number) EXPECT_EQ(numbers.count(number), 1u) << number;
  EXPECT_FALSE(parsed["machine"]["cpu"].get<std::string>().empty());
}

TEST(Measure, RefusesWhatIsNotBuilt) {
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"measure"}, {"measure", "--json"}, {"measure", "--hard-cases", "--csv", "--json"}}) {
    const Outcome run = run_program(arguments);
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr("allowed:"));
  }
  EXPECT_THAT(run_program({"measure"}).err, HasSubstr("only --hard-cases is built so far"));
}

}  // namespace
}  // namespace psm::testing
