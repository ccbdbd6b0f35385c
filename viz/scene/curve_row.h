// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the two-dimensional error model: what a technique chooses at one angle, and the error that follows, under the names
// that `psmlab curves` prints, lessons ask for and plots show.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "math/warp.h"

namespace psm {

/// The frustum of the model: n < f, phi in (0, 90).
struct CurveRange {
  double n = 1.0, f = 100.0, phi_deg = 30.0;  // GMNPR 2007, Figure 5
  bool operator==(const CurveRange&) const = default;
};

/// NaN in all but lambda where the technique does not exist, and in z_at_min at theta = 0, where F is infinite everywhere.
struct CurveRow {
  double lambda, F_n, F_f, F_max, z_at_min, F_min;
};

/// `theta_deg` in [0, 180]; above 90 the model is that of 180 - theta.
CurveRow curve_row(const CurveRange& range, double theta_deg, Warp warp);
WarpModel<double> curve_model(const CurveRange& range, double theta_deg);

struct CurveColumn {
  std::string_view name;
  double CurveRow::*value;
};
inline constexpr std::array<CurveColumn, 6> kCurveColumns{{{"lambda", &CurveRow::lambda},
                                                           {"F_n", &CurveRow::F_n},
                                                           {"F_f", &CurveRow::F_f},
                                                           {"F_max", &CurveRow::F_max},
                                                           {"z_at_min", &CurveRow::z_at_min},
                                                           {"F_min", &CurveRow::F_min}}};

/// Every technique of the model, in the CSV's order; the papers' are all but the last.
inline constexpr std::array kCurveWarps{Warp::uniform, Warp::lispsm,    Warp::lispsm_reference, Warp::glpr,
                                        Warp::gmnpr,   Warp::gmnpr_eq4, Warp::minimax,          Warp::minimax_frustum};
std::optional<Warp> warp_from_csv_name(std::string_view name);

}  // namespace psm
