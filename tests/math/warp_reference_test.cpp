// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the reference table, which was computed at 60 to 200 digits.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "math/warp.h"

namespace psm {
namespace {

struct Row {
  double n, f, phi_deg, theta_deg;
  std::string technique;
  double lambda, F_n, F_f, F_max, z_at_min, F_min;
};

std::vector<Row> read_table() {
  std::ifstream in(PSMLAB_TEST_DATA "/math/lambda_reference.csv");
  std::string line;
  std::getline(in, line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream s(line);
    std::string text[11];
    for (std::string& t : text) s >> t;
    const auto number = [&](int i) { return std::stod(text[i]); };
    rows.push_back(
        {number(0), number(1), number(2), number(3), text[4], number(5), number(6), number(7), number(8), number(9), number(10)});
  }
  return rows;
}

Warp warp_named(const std::string& name) {
  for (int i = 0; i < 8; ++i)
    if (csv_name(Warp(i)) == name) return Warp(i);
  ADD_FAILURE() << "no technique " << name;
  return Warp::uniform;
}

// The table holds 12 significant digits, so its own rounding is 5e-12 relative.
bool close(double a, double b, double tolerance = 1e-11) {
  return (std::isinf(a) && std::isinf(b)) || std::abs(a - b) <= tolerance * std::abs(b);
}

TEST(WarpReference, EveryRow) {
  const std::vector<Row> rows = read_table();
  ASSERT_EQ(rows.size(), 4732u);
  for (const Row& r : rows) {
    SCOPED_TRACE(::testing::Message() << r.n << " " << r.f << " phi " << r.phi_deg << " theta " << r.theta_deg << " "
                                      << r.technique);
    const auto model = WarpModel<double>::from_degrees(r.n, r.f, r.phi_deg, r.theta_deg);
    const auto strength = warp_strength(warp_named(r.technique), model);
    if (std::isnan(r.F_n)) {
      EXPECT_FALSE(strength.exists);
      continue;
    }
    ASSERT_TRUE(strength.exists);
    // The one Eq. 4 row at theta_0 is what two terms of size g S leave when they cancel: one rounding of them is what can be had.
    const bool at_theta0 = r.technique == "GMNPR_EQ4" && r.lambda < 1e-6;
    const double g_S = std::sqrt(r.f * r.n) * model.S;
    const double tolerance = at_theta0 ? epsilon<double>() * g_S / (r.lambda * model.W()) : 1e-11;
    EXPECT_TRUE(close(strength.lambda(), r.lambda, tolerance)) << strength.lambda() << " " << r.lambda;
    const double rho = std::isinf(r.lambda) ? 1.0 : r.lambda / (1.0 + r.lambda);
    EXPECT_TRUE(close(strength.rho, rho, tolerance)) << strength.rho << " " << rho;
    const auto e = warp_error(model, strength.rho, model.tan_phi);
    EXPECT_TRUE(close(e.F_near, r.F_n, tolerance)) << e.F_near << " " << r.F_n;
    EXPECT_TRUE(close(e.F_far, r.F_f, tolerance)) << e.F_far << " " << r.F_f;
    EXPECT_TRUE(close(e.F_max, r.F_max, tolerance)) << e.F_max << " " << r.F_max;
    EXPECT_TRUE(close(e.F_min, r.F_min, tolerance)) << e.F_min << " " << r.F_min;
    if (std::isnan(r.z_at_min)) continue;  // theta = 0: F is infinite everywhere
    EXPECT_TRUE(close(e.z_at_min, r.z_at_min, 1e-9)) << e.z_at_min << " " << r.z_at_min;
  }
}

}  // namespace
}  // namespace psm
