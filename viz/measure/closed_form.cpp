// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/closed_form.h"

#include <optional>

#include "math/warp.h"
#include "measure/line_error.h"
#include "measure/study.h"

namespace psm {
namespace {

struct Entry {
  Technique technique;
  std::optional<Warp> warp;
};
constexpr Entry kEntries[] = {{Technique::uniform, Warp::uniform}, {Technique::psm, std::nullopt},
                              {Technique::lispsm, Warp::lispsm},   {Technique::glpr, Warp::glpr},
                              {Technique::gmnpr, Warp::gmnpr},     {Technique::minimax, Warp::minimax}};

/// Looks along -z from the origin; a box around the whole frustum.
Experiment frustum_experiment(const ClosedFormSetting& s) {
  Experiment x;
  x.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 2 * s.phi_deg, s.near, s.far};
  x.image = {512, 512};
  x.light.to_light = {0, 1, 0};
  return x;
}

ClosedFormRow row_of(const Entry& entry, const ClosedFormSetting& s, Experiment x, const Scene& scene, double theta_deg) {
  ClosedFormRow row{entry.technique, theta_deg};
  x = with_theta(x, theta_deg);
  x.shadow.technique = entry.technique;
  const auto model = WarpModel<double>::from_degrees(s.near, s.far, s.phi_deg, theta_deg);
  row.bound_E = logarithmic_line_error(s.near, s.far, model.phi, model.theta);
  if (entry.warp) {
    const auto strength = warp_strength(*entry.warp, model);
    if (!strength.exists) return row;
    const auto error = warp_error(model, strength.rho, model.tan_phi);
    row.model_F = error.F_max, row.model_E = error.E_max_line;
  }
  const Analysis analysis = analyze(x, scene);
  if (analysis.technique_used == entry.technique) row.map_E = largest_line_error(analysis).value_or(kNone);
  return row;
}

}  // namespace

std::vector<ClosedFormRow> compare_with_closed_forms(const ClosedFormSetting& setting, const std::vector<double>& theta_deg) {
  const Experiment x = frustum_experiment(setting);
  const Scene scene = box_scene(glm::dvec3(-10 * setting.far), glm::dvec3(10 * setting.far));
  std::vector<ClosedFormRow> rows;
  for (const Entry& entry : kEntries)
    for (const double theta : theta_deg) rows.push_back(row_of(entry, setting, x, scene, theta));
  return rows;
}

}  // namespace psm
