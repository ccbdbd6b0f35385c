// SPDX-License-Identifier: GPL-3.0-or-later
// One vanishing plane per technique, and the mappings of the 2002 paper and its web page that are no plane.
#include <algorithm>
#include <cmath>

#include "math/psm_variants.h"
#include "math/warp.h"
#include "scene/analysis_stages.h"
#include "scene/curve_quantity.h"

namespace psm {
namespace {

using glm::dmat4, glm::dvec3, glm::dvec4;

/// The effective half angle in the view-light plane: exact range of t over the frustum's corners.
double tan_phi_effective(const ViewFrame& v, const dvec3& to_light) {
  const double x = std::abs(glm::dot(v.right, to_light)), y = std::abs(glm::dot(v.up, to_light)), h = std::hypot(x, y);
  return h > 0 ? (x * v.tan_x + y * v.tan_y) / h : v.tan_y;
}

WarpModel<double> model_of(const Stages& s) {
  const dvec3 to_light = s.light.w == 0 ? dvec3(s.light) : safe_normalize(dvec3(s.light) - s.centroid);
  return WarpModel<double>::from_vectors(s.near, s.far, tan_phi_effective(s.view, to_light), s.view.forward, to_light);
}

WarpStrength<double> strength_for(Warp warp, const WarpModel<double>& model) {
  if (warp != Warp::lispsm_reference) return warp_strength(warp, model);
  const double rho = std::sqrt(model.n / model.f);  // the authors' code in three dimensions: R's depths, with R's range of t
  return {true, rho, (model.f - model.n) / model.f / (1 + rho)};
}

/// The range of t that the warp spans: over R, or over the frustum between R's depths.
Range<double> warp_range(const Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  const Range<double> of_receivers = ratio_range(s.frame.b, s.uniform, receivers);
  if (s.x.shadow.warp_range == WarpRange::receivers) return of_receivers;
  std::vector<dvec3> corners;
  for (const double z : {s.near, s.far})
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) corners.push_back(s.view.at(x, y, z));
  const Range<double> c = value_range<double>(s.uniform, corners);
  if (!(c.min > 1e-3 * c.max)) {
    note(a, "warp_range_receivers", "The frustum reaches behind the light's plane: the warp spans the receivers.", c.min,
         1e-3 * c.max);
    return of_receivers;
  }
  Range<double> both = ratio_range<double>(s.frame.b, s.uniform, corners);
  both.add(of_receivers.min), both.add(of_receivers.max);
  return both;
}

dvec4 plane_of_warp(Warp warp, Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  const WarpModel<double> model = model_of(s);
  WarpStrength<double> strength = strength_for(warp, model);
  a.theta = model.theta;
  a.phi = model.phi;
  if (!strength.exists) {
    note(a, "glpr_needs_theta_above_phi", "GLPR does not exist where theta is at most phi: the uniform map is used.",
         model.theta / kRadiansPerDegree, model.phi / kRadiansPerDegree);
    a.technique_used = Technique::uniform;
    strength = {};
  }
  if (s.light.w != 0 && warp != Warp::uniform)
    note(a, "lambda_from_directional_model",
         "The papers derive lambda for directional lights only: theta is taken at the receivers' centroid, the warp in the "
         "light's own "
         "perspective space.",
         model.theta / kRadiansPerDegree);
  a.rho = strength.rho;
  a.lambda = strength.lambda();
  const double tan_x = s.view.tan_x * s.view.tan_y / model.tan_phi;  // across the view-light plane: exact along the image's axes
  const auto e = warp_error(model, strength.rho, tan_x);
  a.model_error = ModelError{e.F_near, e.F_far, e.F_max, e.E_max_line, e.E_max_frustum, e.storage_factor};
  const auto uniform = warp_error(model, 1.0, tan_x);
  if (e.E_max_line > uniform.E_max_line * (1 + 1e-9)) {
    a.worse_than_uniform = true;
    note(a, "worse_than_uniform", "Worse than the uniform map in the 2D model: largest F on the central line.", e.F_max,
         uniform.F_max);
  }
  return warped_plane(s.uniform, s.frame.b, warp_range(s, a, receivers), strength.rho, strength.one_minus_rho);
}

/// The eye moved back: near stays, far grows by the shift (PSM 2002, section 4.2).
dmat4 shifted_clip(const Stages& s, double shift) {
  ViewFrame eye = s.view;
  eye.eye -= shift * eye.forward;
  return perspective(eye.tan_x, eye.tan_y, s.near, s.far + shift) * eye.view_from_world();
}

/// The least shift after which all of H is in front of the eye, or inside the shifted frustum.
double least_shift(const Stages& s, const Analysis& a, ShiftRule rule) {
  std::vector<dvec3> in_view;
  std::vector<double> depths;
  for (const dvec3& p : a.caster_body.vertices) {
    depths.push_back(s.view.depth(p));
    in_view.push_back({glm::dot(s.view.right, p - s.view.eye), glm::dot(s.view.up, p - s.view.eye), depths.back()});
  }
  return rule == ShiftRule::inside ? shift_inside<double>(in_view, s.near, s.view.tan_x, s.view.tan_y)
                                   : shift_in_front<double>(depths, s.near);
}

/// What the papers' own mappings need; the one rule needs none, and two maps are there to do without.
ShiftRule automatic_rule(Technique technique) {
  if (technique == Technique::psm_recipe) return ShiftRule::inside;
  return technique == Technique::psm_divided ? ShiftRule::in_front : ShiftRule::automatic;
}

void set_camera_shift(const Stages& s, Analysis& a) {
  const CameraShift& asked = s.x.shadow.camera_shift;
  const Technique technique = s.x.shadow.technique;
  const double* number = std::get_if<double>(&asked);
  if (!shifts_camera(technique)) {
    if (asked != CameraShift())
      note(a, "camera_shift_unused", "Only psm, psm_divided and psm_recipe look from a shifted eye.",
           number ? std::optional(*number) : std::nullopt);
    return;
  }
  if (a.receivers_body.empty()) return;  // nothing is fitted, and the cube stays the eye's own
  ShiftRule rule = number ? ShiftRule::automatic : std::get<ShiftRule>(asked);
  if (rule == ShiftRule::automatic) rule = automatic_rule(technique);
  a.camera_shift = number ? *number : rule == ShiftRule::automatic ? 0.0 : least_shift(s, a, rule);
}

dvec4 plane_of_psm(Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  const auto psm = psm_plane(shifted_clip(s, a.camera_shift), s.light, receivers);
  if (psm.turned > 0)
    note(a, "aim_turned", "Looking at the cube's centre would leave receivers behind the light's plane: the aim is turned.",
         psm.turned / kRadiansPerDegree);
  return psm.plane;
}

dvec4 plane_of_custom(Stages& s, Analysis& a) {
  if (!s.x.shadow.plane) {
    note(a, "plane_missing", "Technique custom needs shadow.plane: the uniform map is used.");
    a.technique_used = Technique::uniform;
    return s.uniform;
  }
  // The plane must pass through the light; the given one is moved there (positions) or turned there (directions).
  dvec4 p = *s.x.shadow.plane;
  const double miss = glm::dot(p, s.light);
  if (s.light.w == 0)
    p -= miss * s.light;
  else
    p.w -= miss;
  return glm::dot(p, dvec4(s.centroid, 1)) < 0 ? -p : p;
}

const dmat4& with_notes(Analysis& a, const VariantMap<double>& m) {
  a.reversed_depth = m.reversed_depth;
  if (m.reversed_depth)
    note(a, "depth_test_reversed", "The light, divided by its negative w, is inverted: the depth test is reversed.",
         a.light_case.w, 0.0);
  if (m.degenerate_up) note(a, "recipe_up_degenerate", "The recipe's up vector (0, 0, 1) lies along the view from the light.");
  if (m.behind_light)
    note(a, "recipe_cube_behind_light",
         "Looking at the cube's centre leaves part of the cube behind the light: smallest w over largest.", m.smallest_w, 0.0);
  return m.map_from_world;
}

bool breaks_the_rule(Technique technique) {
  return technique == Technique::psm_recipe || technique == Technique::psm_divided || technique == Technique::psm_two_maps;
}

}  // namespace

dvec4 technique_plane(Technique technique, Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  a.technique_used = technique;
  set_camera_shift(s, a);
  if (const auto warp = warp_of(technique)) return plane_of_warp(*warp, s, a, receivers);
  switch (technique) {
    case Technique::psm:
      return plane_of_psm(s, a, receivers);
    case Technique::plane_optimal:
      return plane_of_receiver(s, a, receivers);
    case Technique::best_plane:
      return best_plane(s, a, receivers);
    case Technique::custom:
      return plane_of_custom(s, a);
    default:  // one that breaks the rule comes here only where nothing is visible, which has a note of its own
      a.technique_used = Technique::uniform;
      return s.uniform;
  }
}

std::optional<dmat4> rule_breaking_map(Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  const Technique technique = s.x.shadow.technique;
  if (!breaks_the_rule(technique)) return {};
  a.technique_used = technique;
  set_camera_shift(s, a);
  const dmat4 clip = shifted_clip(s, a.camera_shift);
  if (technique == Technique::psm_recipe) return with_notes(a, recipe_map(clip, s.light));
  const dvec4 plane = psm_plane(clip, s.light, receivers).plane;
  const std::span<const dvec3> casters(a.depth_body.vertices);
  if (technique == Technique::psm_divided) return with_notes(a, divided_map<double>(s.frame, plane, clip, receivers, casters));
  const TwoMaps<double> maps = two_maps<double>(s.frame, plane, clip, receivers, casters);
  a.map_beyond_from_world = maps.beyond;
  if (!maps.beyond)
    note(a, "one_map_enough", "No caster stands behind the eye: nothing is beyond the infinity plane, and one map is drawn.",
         value_range(row(clip, 3), casters).min, 0.0);
  return with_notes(a, maps.front);
}

}  // namespace psm
