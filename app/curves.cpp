// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/curves.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "app/numbers.h"
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

constexpr Warp kAll[] = {Warp::uniform, Warp::lispsm,    Warp::lispsm_reference, Warp::glpr,
                         Warp::gmnpr,   Warp::gmnpr_eq4, Warp::minimax,          Warp::minimax_frustum};
constexpr std::size_t kDefaultCount = 7;  // the whole-frustum minimax is not in the reference table

std::optional<Warp> warp_from_name(const std::string& name) {
  for (const Warp warp : kAll)
    if (csv_name(warp) == name) return warp;
  return std::nullopt;
}

Result<std::vector<Warp>> parse_techniques(const std::optional<std::string>& names) {
  if (!names) return std::vector<Warp>(kAll, kAll + kDefaultCount);
  std::vector<Warp> warps;
  for (const std::string& name : split(*names, ',')) {
    const auto warp = warp_from_name(name);
    std::string allowed = "any of:";
    for (const Warp w : kAll) allowed += " " + std::string(csv_name(w));
    if (!warp) return flag_error("--techniques", name, allowed);
    warps.push_back(*warp);
  }
  return warps;
}

std::string csv_row(const Curves& curves, double theta_deg, Warp warp) {
  const double folded = theta_deg > 90 ? 180 - theta_deg : theta_deg;
  const auto model = WarpModel<double>::from_degrees(curves.n, curves.f, curves.phi_deg, folded);
  const auto strength = warp_strength(warp, model);
  WarpError<double> e;
  if (strength.exists) {
    e = warp_error(model, strength.rho, model.tan_phi);
    if (std::isinf(e.F_min)) e.z_at_min = NAN;  // theta = 0: F is infinite everywhere, and smallest nowhere
  } else {
    e.F_near = e.F_far = e.F_max = e.F_min = e.z_at_min = NAN;
  }
  const double numbers[] = {strength.lambda(), e.F_near, e.F_far, e.F_max, e.z_at_min, e.F_min};
  std::string row;
  for (const double x : {curves.n, curves.f, curves.phi_deg, theta_deg}) row += csv_number(x) + ",";
  row += csv_name(warp);
  for (const double x : numbers) row += "," + csv_number(x);
  return row + "\n";
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
  curves.n = *n, curves.f = *f, curves.phi_deg = *phi;
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
  if (!write("n,f,phi_deg,theta_deg,technique,lambda,F_n,F_f,F_max,z_at_min,F_min\n")) return false;
  for (const double theta_deg : curves.theta_deg) {
    std::string rows;
    for (const Warp warp : curves.techniques) rows += csv_row(curves, theta_deg, warp);
    if (!write(rows)) return false;
  }
  return true;
}

}  // namespace psm
