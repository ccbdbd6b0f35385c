// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/curve_row.h"

#include <gtest/gtest.h>

#include <cmath>

namespace psm {
namespace {

TEST(CurveRow, EveryTechniqueIsFoundByItsName) {
  for (const Warp warp : kCurveWarps) EXPECT_EQ(warp_from_csv_name(csv_name(warp)), warp);
  EXPECT_FALSE(warp_from_csv_name("gmnpr"));
}

TEST(CurveRow, TheUniformMapsErrorIsLargestAtTheEye) {
  const CurveRow row = curve_row({1, 100, 30}, 60, Warp::uniform);
  EXPECT_TRUE(std::isinf(row.lambda));
  EXPECT_EQ(row.F_max, row.F_n);
  EXPECT_EQ(row.z_at_min, 100);
  EXPECT_NEAR(row.F_n / row.F_f, 100, 1e-11);
}

TEST(CurveRow, WhereATechniqueDoesNotExistOnlyLambdaIsANumber) {
  const CurveRow row = curve_row({1, 100, 30}, 10, Warp::gmnpr_eq4);
  EXPECT_LE(row.lambda, 0);
  EXPECT_TRUE(std::isnan(row.F_max));
}

}  // namespace
}  // namespace psm
