// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/curve_row.h"

#include <cmath>

namespace psm {

WarpModel<double> curve_model(const CurveRange& range, double theta_deg) {
  const double folded = theta_deg > 90 ? 180 - theta_deg : theta_deg;
  return WarpModel<double>::from_degrees(range.n, range.f, range.phi_deg, folded);
}

CurveRow curve_row(const CurveRange& range, double theta_deg, Warp warp) {
  const WarpModel<double> model = curve_model(range, theta_deg);
  const WarpStrength<double> strength = warp_strength(warp, model);
  if (!strength.exists) return {strength.lambda(), NAN, NAN, NAN, NAN, NAN};
  const WarpError<double> e = warp_error(model, strength.rho, model.tan_phi);
  return {strength.lambda(), e.F_near, e.F_far, e.F_max, std::isinf(e.F_min) ? NAN : e.z_at_min, e.F_min};
}

std::optional<Warp> warp_from_csv_name(std::string_view name) {
  for (const Warp warp : kCurveWarps)
    if (csv_name(warp) == name) return warp;
  return std::nullopt;
}

}  // namespace psm
