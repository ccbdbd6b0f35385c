// SPDX-License-Identifier: GPL-3.0-or-later
// Known values of the warp model: hard cases and corrections to the printed papers (n = 1, f = 100, phi = 30 degrees unless
// said).
#include "math/warp.h"

#include <gtest/gtest.h>

namespace psm {
namespace {

using Model = WarpModel<double>;

Model at(double theta_deg, double f = 100) { return Model::from_degrees(1, f, 30, theta_deg); }
WarpError<double> error_of(Warp w, const Model& m) { return warp_error(m, warp_strength(w, m).rho, m.tan_phi); }

TEST(Warp, OverheadLightEqualisesNearAndFar) {
  EXPECT_NEAR(warp_strength(Warp::gmnpr, at(90)).lambda(), 1.0 / 9.0, 1e-15);
  const auto e = error_of(Warp::gmnpr, at(90));
  EXPECT_NEAR(e.F_near / e.F_far, 1.0, 1e-14);
}

TEST(Warp, BothBranchesMeetAtTheCriticalAngle) {
  for (const double offset : {-1e-12, 0.0, 1e-12}) {
    const double theta_deg = 30 + offset * 57.29577951308232;
    EXPECT_NEAR(warp_strength(Warp::gmnpr, at(theta_deg)).lambda(), 0.05, 1e-11) << offset;
  }
  EXPECT_FALSE(warp_strength(Warp::glpr, at(30)).exists);
  EXPECT_TRUE(warp_strength(Warp::glpr, at(30 + 1e-10)).exists);
}

TEST(Warp, LightAlongTheViewIsUniform) {
  for (const Warp w : {Warp::lispsm, Warp::lispsm_reference, Warp::gmnpr, Warp::minimax, Warp::minimax_frustum}) {
    EXPECT_EQ(warp_strength(w, at(0)).rho, 1.0) << csv_name(w);
    EXPECT_NEAR(warp_strength(w, at(1e-10)).rho, 1.0, 1e-9) << csv_name(w);
    EXPECT_TRUE(std::isfinite(error_of(w, at(0)).E_max_line)) << csv_name(w);
  }
}

TEST(Warp, NearlyFlatAndVeryDeepRanges) {
  EXPECT_NEAR(warp_strength(Warp::gmnpr, Model::from_degrees(1, 1.000001, 30, 90)).lambda(), 2.0000005e6, 1e-3);
  EXPECT_NEAR(warp_strength(Warp::gmnpr, Model::from_degrees(1, 1e8, 30, 90)).lambda(), 1.00010001e-4, 1e-12);
}

TEST(Warp, ScaleDoesNotMatter) {
  for (const double scale : {1e-6, 1e6})
    for (const double theta : {10.0, 30.0, 55.0, 90.0})
      for (int w = 0; w < 8; ++w) {
        const auto a = warp_strength(Warp(w), at(theta)),
                   b = warp_strength(Warp(w), Model::from_degrees(scale, 100 * scale, 30, theta));
        EXPECT_EQ(a.exists, b.exists);
        if (a.exists) {
          EXPECT_NEAR(b.rho / a.rho, 1.0, 1e-13) << csv_name(Warp(w)) << " " << theta;
        }
      }
}

// Bisects for the angle below which a technique's largest F exceeds the uniform map's.
double losing_angle_deg(Warp w, double f) {
  double lo = 1, hi = 29;
  for (int i = 0; i < 60; ++i) {
    const double mid = (lo + hi) / 2;
    const Model m = at(mid, f);
    (error_of(w, m).F_max > error_of(Warp::uniform, m).F_max ? lo : hi) = mid;
  }
  return lo;
}

TEST(Warp, UniformWinsBelowTheseAngles) {
  EXPECT_NEAR(losing_angle_deg(Warp::gmnpr, 100), 17.2185, 1e-4);
  EXPECT_NEAR(losing_angle_deg(Warp::gmnpr, 800), 22.7350, 1e-4);
  EXPECT_NEAR(losing_angle_deg(Warp::lispsm, 100), 6.22, 5e-3);
  EXPECT_NEAR(losing_angle_deg(Warp::lispsm, 800), 16.47, 5e-3);
}

TEST(Warp, WholeFrustumErrorAt60Degrees) {
  EXPECT_NEAR(error_of(Warp::gmnpr, at(60)).E_max_frustum, 26.74, 5e-3);
  EXPECT_NEAR(error_of(Warp::lispsm, at(60)).E_max_frustum, 21.65, 5e-3);
  EXPECT_NEAR(error_of(Warp::minimax_frustum, at(60)).E_max_frustum, 20.85, 5e-3);
}

TEST(Warp, MinimaxIsNoWorseThanAnyOther) {
  for (double theta = 1; theta <= 90; theta += 0.5)
    for (const Warp other : {Warp::uniform, Warp::lispsm, Warp::lispsm_reference, Warp::gmnpr}) {
      const Model m = at(theta);
      EXPECT_LE(error_of(Warp::minimax, m).E_max_line, error_of(other, m).E_max_line * (1 + 1e-12)) << theta;
      EXPECT_LE(error_of(Warp::minimax_frustum, m).E_max_frustum, error_of(other, m).E_max_frustum * (1 + 1e-12)) << theta;
    }
}

TEST(Warp, FMaxRisesTowardsTheCriticalAngle) {
  EXPECT_NEAR(error_of(Warp::gmnpr, at(90)).F_max, 17.147, 5e-4);
  EXPECT_NEAR(error_of(Warp::gmnpr, at(30)).F_max, 19.960, 5e-4);
}

TEST(Warp, StorageFactorIsTheSameFromPsmToLispsm) {
  const Model m = at(90);
  for (const double shift : {0.0, 1.0, 5.0, 10.0}) {  // varphi = P_n - n of the warp frustum
    const double P_n = m.n + shift;
    const double rho = P_n / (P_n + m.W());
    EXPECT_NEAR(warp_error(m, rho, m.tan_phi).storage_factor, 171.473, 2e-3) << shift;
  }
  EXPECT_NEAR(warp_error(m, 1.0, m.tan_phi).storage_factor, 100 * 99 / m.tan_phi, 1e-8);
}

TEST(Warp, ShiftsBy5And20AreEquallyBad) {
  const Model m = at(90);
  for (const double shift : {5.0, 20.0})
    EXPECT_NEAR(warp_error(m, (1 + shift) / (100 + shift), m.tan_phi).F_max, 30.00778024, 1e-8);
}

template <class T>
class WarpTyped : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WarpTyped, Scalars);

TYPED_TEST(WarpTyped, FloatFollowsDouble) {
  using T = TypeParam;
  for (const double theta : {3.0, 17.0, 29.0, 31.0, 60.0, 89.0})
    for (int w = 0; w < 8; ++w) {
      const auto exact = warp_strength(Warp(w), Model::from_degrees(1, 100, 30, theta));
      const auto got = warp_strength(Warp(w), WarpModel<T>::from_degrees(1, 100, 30, T(theta)));
      ASSERT_EQ(got.exists, exact.exists) << csv_name(Warp(w)) << " " << theta;
      if (exact.exists) {
        EXPECT_NEAR(double(got.rho) / exact.rho, 1.0, 64.0 * epsilon<T>()) << csv_name(Warp(w)) << " " << theta;
      }
    }
}

}  // namespace
}  // namespace psm
