// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/curve_csv.h"

#include <cmath>
#include <cstdio>

namespace psm {
namespace {

constexpr double kThetaStep = 0.5;  // degrees
constexpr int kZSteps = 200;

std::string row_start(const CurveRange& range, double theta_deg, Warp warp) {
  std::string row;
  for (const double x : {range.n, range.f, range.phi_deg, theta_deg}) row += csv_number(x) + ",";
  return row + std::string(csv_name(warp));
}

std::string csv_over_z(const CurveSetting& setting) {
  std::string csv = "n,f,phi_deg,theta_deg,technique,z,F,E\n";
  const CurveRange& range = setting.range;
  for (const Warp warp : kCurveWarps)
    for (int i = 0; i <= kZSteps; ++i) {
      const double z = i == kZSteps ? range.f : range.n * std::pow(range.f / range.n, double(i) / kZSteps);
      csv += row_start(range, setting.theta_deg, warp);
      for (const double x : {z, curve_value(CurveKind::F_z, range, setting.theta_deg, z, warp),
                             curve_value(CurveKind::E_z, range, setting.theta_deg, z, warp)})
        csv += "," + csv_number(x);
      csv += "\n";
    }
  return csv;
}

}  // namespace

bool write_curve_rows(const CurveRange& range, const std::vector<double>& theta_deg, const std::vector<Warp>& warps,
                      const std::function<bool(const std::string&)>& write) {
  std::string header = "n,f,phi_deg,theta_deg,technique";
  for (const CurveColumn& column : kCurveColumns) header += "," + std::string(column.name);
  if (!write(header + "\n")) return false;
  for (const double theta : theta_deg) {
    std::string rows;
    for (const Warp warp : warps) {
      const CurveRow values = curve_row(range, theta, warp);
      rows += row_start(range, theta, warp);
      for (const CurveColumn& column : kCurveColumns) rows += "," + csv_number(values.*column.value);
      rows += "\n";
    }
    if (!write(rows)) return false;
  }
  return true;
}

std::string curve_csv(CurveKind kind, const CurveSetting& setting) {
  if (is_over_z(kind)) return csv_over_z(setting);
  std::vector<double> angles;
  for (int i = 0; i * kThetaStep <= 90.0; ++i) angles.push_back(i * kThetaStep);
  std::string csv;
  write_curve_rows(setting.range, angles, {kCurveWarps.begin(), kCurveWarps.end()},
                   [&](const std::string& lines) { return csv += lines, true; });
  return csv;
}

std::string csv_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace psm
