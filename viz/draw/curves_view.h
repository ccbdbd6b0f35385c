// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of the two-dimensional error model, with the experiment as a cursor in them.
#pragma once

#include <string>
#include <vector>

#include "draw/chart.h"
#include "scene/curve_quantity.h"

namespace psm {

/// "λ(θ), logarithmic": for menus and titles.
const char* display_name(CurveKind kind);

/// Its colour in every plot; the family has the colour, the member the dashes.
Role curve_role(Warp warp);

/// "n = 1, f = 100, φ = 30°".
std::string frustum_text(const CurveSetting& setting);

/// Of every kind but the relief.
Chart curve_chart(CurveKind kind, const CurveSetting& setting);

/// Where x is the angle: theta, folded to [0, 90]; the model is the same on both sides.
inline double folded(double theta_deg) { return theta_deg > 90.0 ? 180.0 - theta_deg : theta_deg; }

/// At a place of the chart (theta in degrees, or z): name and value of each technique, the current one first, and what x is.
struct CurveReading {
  std::string x;
  struct Row {
    Warp warp;
    double value;
  };
  std::vector<Row> rows;
};
CurveReading read_curves(CurveKind kind, const CurveSetting& setting, const glm::dvec2& value);

}  // namespace psm
