// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "app/numbers.h"
#include "run_program.h"

namespace psm::testing {
namespace {

using Cells = std::vector<std::string>;

std::vector<Cells> read_csv(std::istream& in) {
  std::vector<Cells> rows;
  for (std::string line; std::getline(in, line);) rows.push_back(split(line, ','));
  return rows;
}

std::vector<Cells> curves(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"curves"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Outcome run = run_program(all);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  std::istringstream out(run.out);
  return read_csv(out);
}

bool same_number(const std::string& text, const std::string& reference_text, double tolerance) {
  const double value = std::stod(text), reference = std::stod(reference_text);
  if (std::isnan(reference)) return std::isnan(value);
  if (std::isinf(reference)) return value == reference;
  return std::abs(value - reference) <= tolerance * std::abs(reference);
}

/// One row of the program's against the same row of the table. Where a technique does not exist, lambda is only at most zero.
void compare(const Cells& row, const Cells& reference) {
  SCOPED_TRACE(::testing::PrintToString(reference));
  ASSERT_EQ(row.size(), 11u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(std::stod(row[i]), std::stod(reference[i]));
  EXPECT_EQ(row[4], reference[4]);
  const bool exists = reference[6] != "nan";
  if (!exists) {
    EXPECT_LE(std::stod(row[5]), 0.0);
  }
  // The one Eq. 4 row at theta_0 is what two terms 1e11 times as large leave when they cancel.
  const double tolerance = reference[4] == "GMNPR_EQ4" && std::stod(reference[5]) < 1e-6 ? 3e-5 : 1e-11;
  for (int i = exists ? 5 : 6; i < 11; ++i)
    EXPECT_TRUE(same_number(row[i], reference[i], i == 9 ? std::max(1e-9, tolerance) : tolerance))
        << row[i] << " " << reference[i];
}

TEST(Curves, AgreeWithTheReferenceTable) {
  std::ifstream file(PSMLAB_TEST_DATA "/math/lambda_reference.csv");
  std::vector<Cells> table = read_csv(file);
  ASSERT_EQ(table.size(), 4733u);
  const Cells header = table.front();
  std::map<Cells, std::vector<Cells>> configurations;  // by n, f, phi
  for (std::size_t i = 1; i < table.size(); ++i)
    configurations[Cells(table[i].begin(), table[i].begin() + 3)].push_back(table[i]);
  for (const auto& [key, rows] : configurations) {
    std::string angles;
    for (std::size_t i = 0; i < rows.size(); i += 7) angles += (i > 0 ? "," : "") + rows[i][3];
    const auto printed = curves({"--n", key[0], "--f", key[1], "--phi-deg", key[2], "--theta-deg", angles});
    ASSERT_EQ(printed.size(), rows.size() + 1);
    EXPECT_EQ(printed[0], header);
    for (std::size_t i = 0; i < rows.size(); ++i) compare(printed[i + 1], rows[i]);
  }
}

TEST(Curves, ARangeReachesBothItsEnds) {
  const auto rows = curves({"--n", "1", "--f", "100", "--phi-deg", "30", "--theta-deg", "0:90:0.1", "--techniques", "SSM"});
  ASSERT_EQ(rows.size(), 902u);
  EXPECT_EQ(std::stod(rows[1][3]), 0.0);
  EXPECT_EQ(std::stod(rows[901][3]), 90.0);
  EXPECT_EQ(rows[1][9], "nan");
  EXPECT_EQ(rows[1][6], "inf");
}

TEST(Curves, AreTheSameForALightFromTheOtherSide) {
  const auto rows =
      curves({"--n", "1", "--f", "100", "--phi-deg", "30", "--theta-deg", "40,140", "--techniques", "GMNPR,MINIMAX_FRUSTUM"});
  ASSERT_EQ(rows.size(), 5u);
  for (const int i : {1, 2})
    for (int column = 4; column < 11; ++column) EXPECT_EQ(rows[i][column], rows[i + 2][column]);
}

TEST(Curves, NumbersHaveSeventeenDigits) {
  const auto rows = curves({"--n", "0.1", "--f", "100", "--phi-deg", "30", "--theta-deg", "60", "--techniques", "LISPSM"});
  EXPECT_EQ(rows[1][0], "0.10000000000000001");
}

}  // namespace
}  // namespace psm::testing
