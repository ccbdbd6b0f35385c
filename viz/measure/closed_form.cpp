// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/closed_form.h"

#include "math/warp.h"
#include "measure/line_error.h"
#include "measure/study.h"
#include "scene/curve_quantity.h"

namespace psm {
namespace {

/// Looks along -z from the origin; a box around the whole frustum.
Experiment frustum_experiment(const ClosedFormSetting& s) {
  Experiment x;
  x.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 2 * s.phi_deg, s.near, s.far};
  x.image = {512, 512};
  x.light.to_light = {0, 1, 0};
  return x;
}

ClosedFormRow row_of(Technique technique, const ClosedFormSetting& s, Experiment x, const Scene& scene, double theta_deg) {
  ClosedFormRow row{technique, theta_deg};
  x = with_theta(x, theta_deg);
  x.shadow.technique = technique;
  const auto model = WarpModel<double>::from_degrees(s.near, s.far, s.phi_deg, theta_deg);
  row.bound_E = logarithmic_line_error(s.near, s.far, model.phi, model.theta);
  const Analysis analysis = analyze(x, scene);
  if (const auto warp = warp_of(technique)) {
    const auto strength = warp_strength(*warp, model);
    if (!strength.exists) return row;
    // In three dimensions the LiSPSM authors' code goes by R's depths, not by the model's form.
    const double rho = *warp == Warp::lispsm_reference ? analysis.rho.value_or(kNone) : strength.rho;
    const auto error = warp_error(model, rho, model.tan_phi);
    row.model_F = error.F_max, row.model_E = error.E_max_line;
  }
  if (analysis.technique_used != technique) return row;
  row.map_E = largest_line_error(analysis).value_or(kNone);
  row.map_F = row.map_E / model.S;
  return row;
}

}  // namespace

std::vector<ClosedFormRow> compare_with_closed_forms(const ClosedFormSetting& setting, const std::vector<double>& theta_deg) {
  const Experiment x = frustum_experiment(setting);
  const Scene scene = box_scene(glm::dvec3(-10 * setting.far), glm::dvec3(10 * setting.far));
  std::vector<ClosedFormRow> rows;
  for (const Technique technique : techniques_to_compare())
    for (const double theta : theta_deg) rows.push_back(row_of(technique, setting, x, scene, theta));
  return rows;
}

}  // namespace psm
