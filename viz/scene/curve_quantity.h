// SPDX-License-Identifier: GPL-3.0-or-later
// What the curves view plots over theta or z, and the angles at which something happens.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/analysis.h"
#include "scene/curve_row.h"

namespace psm {

/// The frustum, angle and technique for which curves are drawn.
struct CurveSetting {
  CurveRange range;
  double theta_deg = 90.0;      // of the experiment, in [0, 180]
  std::optional<Warp> current;  // the experiment's technique, where it has a curve
  bool from_papers = false;     // n, f, phi of the papers' figures, not of the experiment
};
/// By the experiment's view.curve_range; the papers' numbers where its technique has no n, f, phi.
CurveSetting curve_setting(const Analysis& analysis);

/// The curve of a technique of the experiment; none for those that are no warp of the 2D model.
std::optional<Warp> warp_of(Technique technique);

/// Over theta and z.
bool is_over_both(CurveKind kind);

/// Over z at the setting's theta, or over both; else over theta.
bool is_over_z(CurveKind kind);

/// NaN where the technique does not exist. `z` counts where the kind is over z.
double curve_value(CurveKind kind, const CurveRange& range, double theta_deg, double z, Warp warp);

/// The angle in degrees below which this technique's error is larger than the uniform map's; none where that never happens. Found
/// by bisection.
std::optional<double> worse_than_uniform_below(CurveKind kind, const CurveRange& range, Warp warp);

struct CriticalAngle {
  double theta_deg;
  std::string text, short_text;
};
/// theta = phi, which is all over depth; for lambda and rho the angle below which GMNPR's Eq. 4 gives no positive lambda; for
/// errors the angles below which GMNPR, LiSPSM and the current technique are worse than the uniform map. What does not happen is
/// left out.
std::vector<CriticalAngle> critical_angles(CurveKind kind, const CurveSetting& setting);

/// Short names for curves: "LiSPSM".
const char* display_name(Warp warp);

}  // namespace psm
