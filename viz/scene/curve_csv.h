// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as text.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/curve_quantity.h"

namespace psm {

/// 17 significant digits; "inf", "-inf", "nan".
std::string csv_number(double value);

/// What `psmlab curves` prints: eleven columns. Hands out some lines at a time; stops when `write` returns false, and returns
/// that.
bool write_curve_rows(const CurveRange& range, const std::vector<double>& theta_deg, const std::vector<Warp>& warps,
                      const std::function<bool(const std::string&)>& write);

/// What a plot shows: over theta the rows of `psmlab curves` every half degree; over z the columns n, f, phi_deg, theta_deg,
/// technique, z, F, E.
std::string curve_csv(CurveKind kind, const CurveSetting& setting);

}  // namespace psm
