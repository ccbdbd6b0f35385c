// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/curve_quantity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/curve_csv.h"
#include "scene/experiment_file.h"
#include "scene/light_angles.h"

namespace psm {
namespace {

using ::testing::StartsWith;

Analysis analysis_of(const std::vector<std::string>& overrides) {
  const auto loaded = load_experiment("ground", overrides);
  EXPECT_TRUE(loaded) << loaded.error().text;
  return analyze(loaded->experiment, loaded->scene);
}

std::vector<double> angles_of(CurveKind kind, const CurveSetting& setting) {
  std::vector<double> angles;
  for (const CriticalAngle& angle : critical_angles(kind, setting)) angles.push_back(angle.theta_deg);
  return angles;
}

CurveSetting papers(double f) {
  CurveSetting setting;
  setting.range.f = f;
  return setting;
}

// FORMULAS, section 2, items 4 and 5, to the digits printed there.
TEST(CriticalAngles, AreThoseOfTheFormulas) {
  const auto strengths = angles_of(CurveKind::rho, papers(100));
  ASSERT_EQ(strengths.size(), 2u);
  EXPECT_EQ(strengths[0], 30.0);
  EXPECT_NEAR(strengths[1], 27.6934, 5e-5);
  EXPECT_NEAR(worse_than_uniform_below(CurveKind::F_max, {1, 100, 30}, Warp::gmnpr).value(), 17.2185, 5e-5);
  EXPECT_NEAR(worse_than_uniform_below(CurveKind::F_max, {1, 800, 30}, Warp::gmnpr).value(), 22.7350, 5e-5);
  EXPECT_NEAR(worse_than_uniform_below(CurveKind::F_max, {1, 100, 30}, Warp::lispsm).value(), 6.22, 5e-3);
  EXPECT_NEAR(worse_than_uniform_below(CurveKind::F_max, {1, 800, 30}, Warp::lispsm).value(), 16.47, 5e-3);
}

// tan(theta0) = tan(phi) sqrt(f) / (sqrt(f) + sqrt(n)).
TEST(CriticalAngles, OfEquation4HasAClosedForm) {
  for (const double f : {1.5, 10.0, 100.0, 1e4}) {
    const double closed = std::atan(std::tan(glm::radians(30.0)) * std::sqrt(f) / (std::sqrt(f) + 1.0));
    const auto found = angles_of(CurveKind::lambda, papers(f));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[1], glm::degrees(closed), 1e-9) << f;
  }
}

TEST(CriticalAngles, SeparateBetterFromWorse) {
  for (const CurveKind kind : {CurveKind::F_max, CurveKind::E_frustum, CurveKind::storage})
    for (const Warp warp : {Warp::gmnpr, Warp::lispsm, Warp::glpr}) {
      const CurveRange range{1, 300, 25};
      const auto angle = worse_than_uniform_below(kind, range, warp);
      if (!angle || *angle > 89.0) continue;  // worse everywhere
      const auto excess = [&](double theta) {
        return curve_value(kind, range, theta, 0, warp) / curve_value(kind, range, theta, 0, Warp::uniform) - 1.0;
      };
      EXPECT_LT(excess(*angle + 1e-6), 1e-8);
      EXPECT_GT(excess(*angle - 1e-3), 0.0);
    }
}

TEST(CriticalAngles, TheMinimaxIsNeverWorse) {
  EXPECT_FALSE(worse_than_uniform_below(CurveKind::F_max, {1, 100, 30}, Warp::minimax));
  EXPECT_FALSE(worse_than_uniform_below(CurveKind::E_frustum, {1, 100, 30}, Warp::minimax_frustum));
}

TEST(CurveSetting, IsTheExperimentsOwn) {
  for (const char* technique : {"gmnpr", "lispsm", "minimax"})
    for (const double theta : {35.0, 60.0, 100.0}) {
      const auto loaded = load_experiment("ground", {std::string("shadow.technique=") + technique});
      ASSERT_TRUE(loaded);
      const Experiment turned = with_light_at(loaded->experiment, glm::radians(theta), {});
      const Analysis a = analyze(turned, loaded->scene);
      ASSERT_TRUE(a.lambda && a.near);
      const CurveSetting setting = curve_setting(a);
      EXPECT_FALSE(setting.from_papers);
      EXPECT_NEAR(setting.theta_deg, theta, 1e-9);
      ASSERT_TRUE(setting.current);
      const double lambda = curve_value(CurveKind::lambda, setting.range, setting.theta_deg, 0, *setting.current);
      if (a.technique_used == turned.shadow.technique && std::isfinite(*a.lambda)) {
        EXPECT_NEAR(lambda, *a.lambda, 1e-9 * lambda) << technique << " at " << theta;
      }
    }
}

TEST(CurveSetting, FallsBackToThePapersNumbers) {
  const CurveSetting psm = curve_setting(analysis_of({"shadow.technique=psm"}));
  EXPECT_TRUE(psm.from_papers);
  EXPECT_EQ(psm.range, CurveRange{});
  EXPECT_FALSE(psm.current);
  EXPECT_TRUE(curve_setting(analysis_of({"view.curve_range=papers"})).from_papers);
}

TEST(CurveCsv, OverThetaIsWhatTheCommandPrints) {
  const CurveSetting setting = papers(100);
  std::string printed;
  std::vector<double> angles;
  for (int i = 0; i <= 180; ++i) angles.push_back(0.5 * i);
  write_curve_rows(setting.range, angles, {kCurveWarps.begin(), kCurveWarps.end()},
                   [&](const std::string& s) { return printed += s, true; });
  EXPECT_EQ(curve_csv(CurveKind::rho, setting), printed);
  EXPECT_EQ(std::count(printed.begin(), printed.end(), '\n'), 1 + 181 * std::ptrdiff_t(kCurveWarps.size()));
  EXPECT_THAT(printed, StartsWith("n,f,phi_deg,theta_deg,technique,lambda,F_n,F_f,F_max,z_at_min,F_min\n"));
}

TEST(CurveCsv, OverDepthHasBothErrors) {
  CurveSetting setting = papers(100);
  setting.theta_deg = 60;
  const std::string csv = curve_csv(CurveKind::E_z, setting);
  EXPECT_THAT(csv, StartsWith("n,f,phi_deg,theta_deg,technique,z,F,E\n1,100,30,60,SSM,1,"));
}

TEST(Light, TurnsToAnAngleWhateverItsType) {
  for (const char* type : {"directional", "point"}) {
    const auto loaded = load_experiment("ground", {std::string("light.type=") + type});
    ASSERT_TRUE(loaded);
    const Analysis before = analyze(loaded->experiment, loaded->scene);
    const glm::dvec3 middle = before.receivers_body.centroid();
    const Experiment turned = with_light_at(loaded->experiment, glm::radians(40.0), middle);
    EXPECT_NEAR(curve_setting(analyze(turned, loaded->scene)).theta_deg, 40.0, 1e-6) << type;
    if (turned.light.type == LightType::point) {
      EXPECT_NEAR(glm::length(turned.light.position - middle), glm::length(loaded->experiment.light.position - middle), 1e-9);
    }
  }
}

}  // namespace
}  // namespace psm
