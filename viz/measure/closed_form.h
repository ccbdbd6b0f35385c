// SPDX-License-Identifier: GPL-3.0-or-later
// The two-dimensional model's closed forms beside what the real maps do, where the model's assumptions hold: the receivers fill
// the camera's frustum, and the sun stands in the plane of the view's vertical.
#pragma once

#include <vector>

#include "measure/study_row.h"
#include "scene/experiment.h"

namespace psm {

struct ClosedFormSetting {
  double near = 1.0, far = 100.0, phi_deg = 30.0;
};

/// Largest values on the central line; kNone where the technique has no closed form, or does not exist at this angle.
struct ClosedFormRow {
  Technique technique = Technique::uniform;
  double theta_deg = 0;
  double model_F = kNone, model_E = kNone;  // closed forms (viz/math/warp.h)
  double map_F = kNone, map_E = kNone;      // measured in the map that the analysis made
  double bound_E = kNone;                   // no map can have less
};

/// For every technique, at each angle in (0, 90].
std::vector<ClosedFormRow> compare_with_closed_forms(const ClosedFormSetting& setting, const std::vector<double>& theta_deg);

}  // namespace psm
