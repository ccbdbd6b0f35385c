// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "figure/report_parts.h"
#include "measure/pareto.h"

namespace psm {
namespace {

const std::vector<double> kAngleTicks{0, 30, 60, 90, 120, 150, 180};

/// What one row says in a plot of error against cost.
glm::dvec2 cost_and_error(const StudyRow& row, bool against_time) {
  return {against_time ? row.shadow_us() / 1000 : std::sqrt(row.texels), 100 * row.error_fraction};
}

/// As steps: with this much to spend, that is the smallest error. A broad band behind the curves.
PlotCurve front_curve(const std::vector<StudyRow>& rows, bool against_time) {
  std::vector<glm::dvec2> points;
  for (const StudyRow& row : rows)
    if (row.compared > 0) points.push_back(cost_and_error(row, against_time));
  PlotCurve curve;
  curve.label = "Pareto front";
  curve.color = 0x555555;
  curve.opacity = 0.3;
  curve.width = 10;
  for (const std::size_t i : pareto_front(points)) {
    if (!curve.points.empty()) curve.points.push_back({points[i].x, curve.points.back().y});
    curve.points.push_back(points[i]);
  }
  return curve;
}

/// One curve over the angles; gaps where the technique was replaced.
template <class Value>
PlotCurve over_theta(const std::vector<StudyRow>& rows, const std::string& technique, double resolution, Value value) {
  PlotCurve curve = technique_curve(technique);
  curve.markers = true;
  std::vector<double> angles = values_in(rows, &StudyRow::theta_deg);
  std::sort(angles.begin(), angles.end());
  for (const double theta : angles) {
    const StudyRow* row = find_row(rows, technique, resolution, theta);
    curve.points.push_back({theta, row && as_asked(*row) ? value(*row) : kNone});
  }
  return curve;
}

std::string scene_of(const std::vector<StudyRow>& rows) { return rows.empty() ? "" : rows.front().scene; }

}  // namespace

Plot error_plot(const std::vector<StudyRow>& rows, bool against_time) {
  const double theta = reference_theta(rows);
  const auto here = rows_where(rows, [&](const StudyRow& r) { return r.theta_deg == theta && as_asked(r); });
  Plot plot;
  plot.title = scene_of(rows) + (against_time ? ": error against time" : ": error against texels");
  plot.subtitle =
      "light at " + angle(theta) + " to the view; each curve from the smallest map to the largest; " + conditions(here);
  plot.x = {against_time ? "time of the shadows: analysis and map (ms)" : "texels along the map's side", true, {}};
  if (!against_time) plot.x.ticks = values_in(here, &StudyRow::resolution);
  plot.y = {"wrong pixels (%)", true, {}};
  plot.curves.push_back(front_curve(here, against_time));
  for (const std::string& technique : names_in(here, &StudyRow::technique)) {
    if (!in_plots(technique)) continue;
    PlotCurve curve = technique_curve(technique);
    curve.markers = true;
    for (const StudyRow& row : here)
      if (row.technique == technique && row.compared > 0) curve.points.push_back(cost_and_error(row, against_time));
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Plot equal_error_plot(const std::vector<StudyRow>& rows) {
  const auto asked = rows_where(rows, [](const StudyRow& r) { return !std::isnan(r.equal_error_resolution); });
  const double resolution = reference_resolution(asked);
  Plot plot;
  plot.title = scene_of(rows) + ": equal-error resolution";
  plot.subtitle =
      "side of the uniform map with the same error, over the technique's " + shown(resolution, 5) + "; " + conditions(rows);
  plot.x = {"angle between view and light (degrees); above 90 the light is behind", false, kAngleTicks};
  plot.y = {"times as large", true, {}};
  for (const std::string& technique : names_in(asked, &StudyRow::technique))
    if (in_plots(technique) && technique != "uniform")
      plot.curves.push_back(
          over_theta(asked, technique, resolution, [](const StudyRow& r) { return r.equal_error_resolution / r.resolution; }));
  plot.levels.push_back({1.0, "no gain"});
  return plot;
}

Plot texel_size_plot(const std::vector<StudyRow>& slab) {
  const double resolution = reference_resolution(slab);
  Plot plot;
  plot.title = "Texel size on the ground at every sun";
  plot.subtitle = "95th percentile of m over the ground's pixels; map " + shown(resolution, 5) + "; " + conditions(slab);
  plot.x = {"angle between view and light (degrees); above 90 the sun is behind", false, kAngleTicks};
  plot.y = {"m (pixels)", true, {}};
  for (const std::string& technique : names_in(slab, &StudyRow::technique))
    if (in_plots(technique))
      plot.curves.push_back(over_theta(slab, technique, resolution, [](const StudyRow& r) { return r.m_p95; }));
  if (!slab.empty()) plot.levels.push_back({slab[0].width / resolution, "limit " + shown(slab[0].width / resolution)});
  return plot;
}

namespace {

/// The other techniques' curves would lie on these, or far above.
bool in_closed_form_plot(const ClosedFormRow& row) {
  for (const Technique technique :
       {Technique::uniform, Technique::psm, Technique::lispsm, Technique::glpr, Technique::gmnpr, Technique::minimax})
    if (row.technique == technique) return true;
  return false;
}

}  // namespace

Plot closed_form_plot(const std::vector<ClosedFormRow>& rows, const ClosedFormSetting& setting) {
  Plot plot;
  plot.title = "Largest error on the central line: closed forms and maps";
  plot.subtitle = "lines: closed forms (psm: its maps); dots: maps; n = " + shown(setting.near) + ", f = " + shown(setting.far) +
                  ", phi = " + angle(setting.phi_deg);
  plot.x = {"angle between view and light (degrees)", false, {0, 15, 30, 45, 60, 75, 90}};
  plot.y = {"E = F sin(theta)", true, {}};
  PlotCurve bound;
  bound.label = "lower bound";
  bound.color = 0x555555;
  bound.dash = "2 5";
  for (const ClosedFormRow& row : rows) {
    if (!in_closed_form_plot(row)) continue;
    const std::string technique = name_of(row.technique);
    if (plot.curves.empty() || (plot.curves.back().label != technique && !plot.curves.back().label.empty())) {
      plot.curves.push_back(technique_curve(technique));
    }
    plot.curves.back().points.push_back({row.theta_deg, std::isnan(row.model_E) ? row.map_E : row.model_E});
    if (row.technique == rows.front().technique) bound.points.push_back({row.theta_deg, row.bound_E});
  }
  for (const ClosedFormRow& row : rows) {
    PlotCurve dot = technique_curve(name_of(row.technique));
    dot.label.clear();
    dot.width = 0;
    dot.markers = true;
    dot.points = {{row.theta_deg, row.map_E}};
    if (in_closed_form_plot(row) && !std::isnan(row.map_E)) plot.curves.push_back(std::move(dot));
  }
  plot.curves.push_back(std::move(bound));
  return plot;
}

}  // namespace psm
