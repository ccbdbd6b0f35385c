// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/curves_view.h"

#include <algorithm>
#include <cmath>

#include "draw/curve_relief.h"
#include "draw/curve_surface.h"
#include "draw/sketch.h"

namespace psm {
namespace {

constexpr double kThetaStep = 0.5;  // degrees
constexpr int kZSteps = 160;
constexpr double kMostRatio = 300.0;  // of errors: beyond, they only say that something is hopeless

struct Look {
  Role role;
  std::vector<double> dash;
  int rank;
};

const Look& look_of(Warp warp) {
  static const Look looks[] = {{Role::curve_uniform, {}, 1},
                               {Role::curve_lispsm, {}, 3},
                               {Role::curve_lispsm_reference, {9, 5}, 6},
                               {Role::curve_glpr, {10, 4, 2, 4}, 5},
                               {Role::curve_gmnpr, {}, 2},
                               {Role::curve_gmnpr_eq4, {3, 4}, 7},
                               {Role::curve_minimax, {}, 4},
                               {Role::curve_minimax_frustum, {9, 5}, 8}};
  return looks[int(warp)];
}

bool is_log(CurveKind kind) { return kind != CurveKind::lambda && kind != CurveKind::rho; }

std::string quantity_text(CurveKind kind) {
  switch (kind) {
    case CurveKind::lambda:
    case CurveKind::log_lambda:
      return "λ (uniform: ∞)";
    case CurveKind::rho:
      return "ρ = λ/(1+λ); 1 is uniform";
    case CurveKind::F_max:
      return "largest F on the central line";
    case CurveKind::E_max:
      return "largest E = F sin θ on the central line";
    case CurveKind::E_frustum:
      return "largest E = F sin θ in the frustum";
    case CurveKind::storage:
      return "storage factor";
    case CurveKind::F_z:
    case CurveKind::surface:
    case CurveKind::relief:
      return "F";
    case CurveKind::E_z:
      return "E = F sin θ";
  }
  return "";
}

ChartCurve curve_over_theta(CurveKind kind, const CurveSetting& setting, Warp warp, const std::vector<CriticalAngle>& critical) {
  std::vector<double> angles;
  for (int i = 0; i * kThetaStep <= 90.0; ++i) angles.push_back(i * kThetaStep);
  for (const CriticalAngle& angle : critical) angles.push_back(angle.theta_deg);
  std::sort(angles.begin(), angles.end());
  ChartCurve curve;
  for (const double theta : angles) curve.points.push_back({theta, curve_value(kind, setting.range, theta, 0.0, warp)});
  return curve;
}

ChartCurve curve_over_z(CurveKind kind, const CurveSetting& setting, Warp warp) {
  const auto& [n, f, phi] = setting.range;
  ChartCurve curve;
  for (int i = 0; i <= kZSteps; ++i) {
    const double z = i == kZSteps ? f : n * std::pow(f / n, double(i) / kZSteps);
    curve.points.push_back({z, curve_value(kind, setting.range, setting.theta_deg, z, warp)});
  }
  return curve;
}

/// What all curves have in sight: errors up to 300 times the smallest; lambda up to twice what it is above phi, where the
/// techniques still differ, and down to a thousandth of that.
void fit_values(CurveKind kind, const CurveSetting& setting, Chart& chart) {
  chart.y.low = 0.0;
  if (kind == CurveKind::rho) {
    chart.y.high = 1.05;
    return;
  }
  double low = INFINITY, high = -INFINITY, above_phi = 0.0;
  for (const ChartCurve& curve : chart.curves)
    for (const glm::dvec2& p : curve.points) {
      if (!std::isfinite(p.y) || !(p.y > 0.0)) continue;
      low = std::min(low, p.y), high = std::max(high, p.y);
      if (p.x >= setting.range.phi_deg) above_phi = std::max(above_phi, p.y);
    }
  if (!(low <= high)) low = 1.0, high = 10.0;
  const bool strength = kind == CurveKind::lambda || kind == CurveKind::log_lambda;
  if (strength) high = std::min(high, (kind == CurveKind::lambda ? 2.0 : 10.0) * (above_phi > 0.0 ? above_phi : high));
  if (kind == CurveKind::lambda) {
    chart.y.high = high;
    return;
  }
  if (strength)
    low = std::max(low, 1e-3 * high);
  else
    high = std::min(high, low * kMostRatio);
  const double room = std::pow(high / low, 0.05);
  chart.y.low = low / room, chart.y.high = high * room;
}

void add_curves(CurveKind kind, const CurveSetting& setting, const std::vector<CriticalAngle>& critical, Chart& chart) {
  for (const Warp warp : kCurveWarps) {
    ChartCurve curve = is_over_z(kind) ? curve_over_z(kind, setting, warp) : curve_over_theta(kind, setting, warp, critical);
    const Look& look = look_of(warp);
    const bool current = setting.current == warp;
    curve.label = display_name(warp);
    curve.role = look.role;
    curve.dash = look.dash;
    curve.width = current ? 4.0 : 1.75;
    curve.rank = current ? 0 : look.rank;
    chart.curves.push_back(std::move(curve));
  }
  // The current one lies over the others.
  std::stable_sort(chart.curves.begin(), chart.curves.end(),
                   [](const ChartCurve& a, const ChartCurve& b) { return a.width < b.width; });
}

void add_cursor(CurveKind kind, const CurveSetting& setting, Chart& chart) {
  const double theta = folded(setting.theta_deg);
  const std::string behind = setting.theta_deg > 90.0 ? " (light behind: " + short_number(setting.theta_deg, 4) + "°)" : "";
  chart.marks.push_back({theta, "θ = " + short_number(theta, 4) + "°" + behind, "θ = " + short_number(theta, 4) + "°",
                         Role::light, 2.5, LineStyle::solid, true});
  if (kind == CurveKind::surface) return;
  for (const Warp warp : kCurveWarps) {
    const double value = curve_value(kind, setting.range, theta, 0.0, warp);
    if (std::isfinite(value)) chart.points.push_back({{theta, value}, look_of(warp).role, setting.current == warp ? 6.0 : 3.5});
  }
}

Chart chart_over_z(CurveKind kind, const CurveSetting& setting) {
  Chart chart;
  chart.x = {"depth z, θ = " + short_number(setting.theta_deg, 4) + "°", "", setting.range.n, setting.range.f, true, false};
  chart.y = {quantity_text(kind), frustum_text(setting), 1.0, 10.0, true, false};
  add_curves(kind, setting, {}, chart);
  fit_values(kind, setting, chart);
  return chart;
}

}  // namespace

const char* display_name(CurveKind kind) {
  constexpr const char* names[] = {"λ(θ)",         "λ(θ), logarithmic",     "ρ(θ)",           "largest F(θ)",
                                   "largest E(θ)", "largest E(θ), frustum", "storage factor", "F(z)",
                                   "E(z)",         "F(θ, z), map",          "F(θ, z), relief"};
  return names[int(kind)];
}

std::string frustum_text(const CurveSetting& s) {
  return "n = " + short_number(s.range.n, 4) + ", f = " + short_number(s.range.f, 4) +
         ", φ = " + short_number(s.range.phi_deg, 4) + "°" + (s.from_papers ? " (papers)" : "");
}

Role curve_role(Warp warp) { return look_of(warp).role; }

Chart curve_chart(CurveKind kind, const CurveSetting& setting) {
  if (kind == CurveKind::F_z || kind == CurveKind::E_z) return chart_over_z(kind, setting);
  Chart chart;
  chart.x = {"θ, between view and light", "", 0.0, 90.0, false, true};
  chart.y = {quantity_text(kind), frustum_text(setting), 0.0, 1.0, is_log(kind), false};
  const std::vector<CriticalAngle> critical = critical_angles(kind, setting);
  if (kind == CurveKind::surface) {
    chart.y = {"depth z; lines: F", frustum_text(setting), setting.range.n, setting.range.f, true, false};
    add_surface(setting, chart);
  } else {
    add_curves(kind, setting, critical, chart);
    fit_values(kind, setting, chart);
  }
  for (const CriticalAngle& angle : critical) chart.marks.push_back({angle.theta_deg, angle.text, angle.short_text});
  add_cursor(kind, setting, chart);
  return chart;
}

CurveReading read_curves(CurveKind kind, const CurveSetting& setting, const glm::dvec2& value) {
  const bool over_z = kind == CurveKind::F_z || kind == CurveKind::E_z;
  const double theta = over_z ? setting.theta_deg : value.x, z = over_z ? value.x : value.y;
  CurveReading reading;
  reading.x = over_z ? "z = " + short_number(z, 4) : "θ = " + short_number(theta, 4) + "°";
  if (kind == CurveKind::surface) reading.x += ", z = " + short_number(z, 4);
  for (const Warp warp : kCurveWarps) reading.rows.push_back({warp, curve_value(kind, setting.range, theta, z, warp)});
  std::stable_partition(reading.rows.begin(), reading.rows.end(),
                        [&](const CurveReading::Row& row) { return setting.current == row.warp; });
  return reading;
}

ViewPicture describe_curves(const Analysis& analysis, const glm::dvec2& page) {
  const CurveKind kind = analysis.experiment.view.curve;
  const CurveSetting setting = curve_setting(analysis);
  ViewPicture picture;
  picture.id = ViewId::curves;
  picture.title = std::string("Curves: ") + display_name(kind);
  if (is_over_both(kind)) picture.title += std::string(", ") + display_name(surface_warp(setting));
  picture.scene = ScenePicture::none;
  picture.clip_from_world = picture.clip_from_list = clip_from_page(page);
  if (kind == CurveKind::relief) {
    picture.list = relief_list(setting, page);
    return picture;
  }
  const Chart chart = curve_chart(kind, setting);
  picture.chart = chart_frame(chart, page);
  picture.list = chart_list(chart, *picture.chart);
  return picture;
}

}  // namespace psm
