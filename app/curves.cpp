// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/curves.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "app/numbers.h"
#include "scene/curve_csv.h"
#include "scene/experiment.h"

namespace psm {
namespace {

constexpr std::size_t kMostRows = 1000000;
constexpr const char* kThetaAllowed = "A:B:STEP with A <= B and STEP > 0, or a comma-separated list, of degrees in [0, 180]";

/// A + i STEP, so that no error accumulates; the last one meets B where it misses it by rounding only.
Result<std::vector<double>> theta_range(const std::string& text, const std::vector<std::string>& parts) {
  const auto first = number_from_text(parts[0]), last = number_from_text(parts[1]), step = number_from_text(parts[2]);
  if (!first || !last || !step || !(*first >= 0 && *first <= *last && *last <= 180 && *step > 0 && std::isfinite(*step)))
    return flag_error("--theta-deg", text, kThetaAllowed);
  const double steps = (*last - *first) / *step;
  if (!(steps < double(kMostRows))) return flag_error("--theta-deg", text, "at most 1000000 rows");
  std::vector<double> angles;
  for (double i = 0; i <= steps * (1 + 1e-12); ++i) angles.push_back(std::min(*first + i * *step, *last));
  return angles;
}

Result<std::vector<double>> theta_list(const std::string& text) {
  std::vector<double> angles;
  for (const std::string& part : split(text, ',')) {
    const auto angle = number_from_text(part);
    if (!angle || !(*angle >= 0 && *angle <= 180)) return flag_error("--theta-deg", text, kThetaAllowed);
    angles.push_back(*angle);
  }
  return angles;
}

Result<std::vector<Warp>> parse_techniques(const std::optional<std::string>& names) {
  if (!names) return std::vector<Warp>(kCurveWarps.begin(), kCurveWarps.end() - 1);  // the papers'
  std::vector<Warp> warps;
  for (const std::string& name : split(*names, ',')) {
    const auto warp = warp_from_csv_name(name);
    std::string allowed = "any of:";
    for (const Warp w : kCurveWarps) allowed += " " + std::string(csv_name(w));
    if (!warp) return flag_error("--techniques", name, allowed);
    warps.push_back(*warp);
  }
  return warps;
}

}  // namespace

Result<std::vector<double>> parse_theta_deg(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  return parts.size() == 3 ? theta_range(text, parts) : theta_list(text);
}

Result<Curves> parse_curves(const CurvesText& text) {
  Curves curves;
  const auto n = number_from_text(text.n), f = number_from_text(text.f), phi = number_from_text(text.phi_deg);
  if (!n || !(*n >= 1e-100 && *n <= 1e100)) return flag_error("--n", text.n, "a number in [1e-100, 1e100]");
  if (!f || !(*f > *n && *f <= 1e100)) return flag_error("--f", text.f, "a number greater than --n, up to 1e100");
  if (!phi || !(*phi > 0 && *phi < 90)) return flag_error("--phi-deg", text.phi_deg, "a number in (0, 90)");
  curves.range = {*n, *f, *phi};
  auto theta = parse_theta_deg(text.theta_deg);
  if (!theta) return theta.error();
  curves.theta_deg = std::move(*theta);
  auto techniques = parse_techniques(text.techniques);
  if (!techniques) return techniques.error();
  curves.techniques = std::move(*techniques);
  if (curves.theta_deg.size() > kMostRows / curves.techniques.size())
    return flag_error("--theta-deg", text.theta_deg, "at most 1000000 rows");
  return curves;
}

bool write_curves(const Curves& curves, const std::function<bool(const std::string&)>& write) {
  return write_curve_rows(curves.range, curves.theta_deg, curves.techniques, write);
}

}  // namespace psm
