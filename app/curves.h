// SPDX-License-Identifier: GPL-3.0-or-later
// The two-dimensional error model as CSV: one row for each angle and technique.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/curve_row.h"
#include "scene/result.h"

namespace psm {

/// As typed: everything is text until parse_curves has checked it.
struct CurvesText {
  std::string n, f, phi_deg, theta_deg;
  std::optional<std::string> techniques;  // none: those of the papers
};

struct Curves {
  CurveRange range;
  std::vector<double> theta_deg;  // in [0, 180]; above 90 the model is that of 180 - theta
  std::vector<Warp> techniques;
};

/// "A:B:STEP" or "a,b,...": angles in [0, 180]. Errors start with --theta-deg.
Result<std::vector<double>> parse_theta_deg(const std::string& text);

/// Errors start with the flag.
Result<Curves> parse_curves(const CurvesText& text);

/// Eleven columns, 17 digits; nan where a technique does not exist. Hands out some lines at a time; stops when `write` returns
/// false, and returns that.
bool write_curves(const Curves& curves, const std::function<bool(const std::string&)>& write);

}  // namespace psm
