// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of an experiment, in order: camera, light case, bodies, the technique's plane, the shared fit, errors.
#include <algorithm>
#include <cmath>

#include "geom/frustum.h"
#include "math/light_case.h"
#include "math/shadow_map.h"
#include "math/warp.h"
#include "scene/analysis.h"
#include "scene/texel_sampling.h"

namespace psm {
namespace {

using glm::dmat4, glm::dvec3, glm::dvec4;
constexpr double kRadians = 3.14159265358979323846 / 180.0;

void note(Analysis& a, std::string code, std::string text, std::optional<double> value = {}, std::optional<double> limit = {}) {
  a.notes.push_back({std::move(code), std::move(text), value, limit});
}

/// What the stages hand on; the Analysis keeps what is worth showing.
struct Stages {
  const Experiment& x;
  const Scene& scene;
  ViewFrame view = {};
  std::vector<Plane> view_planes = {};
  ConvexBody lit_scene = {};  // S ∩ L
  dvec4 light{0};             // unit direction and 0, or position and 1
  dvec3 centroid{0};          // of R
  double near = 1, far = 2;   // depth range that the technique uses
  LightFrame<double> frame = {};
  dvec4 uniform{0};
  bool light_in_receivers = false;
};

ViewFrame camera_frame(const Experiment& x) {
  const double tan_y = std::tan(x.camera.vertical_fov_deg * kRadians / 2);
  return view_frame(x.camera.position, x.camera.target - x.camera.position, x.camera.up, tan_y * x.image.aspect(), tan_y);
}

void set_camera(Stages& s, Analysis& a) {
  const CameraSettings& c = s.x.camera;
  s.view = camera_frame(s.x);
  s.view_planes = frustum_planes(s.view, c.near, c.far);
  a.view_from_world = s.view.view_from_world();
  a.clip_from_view = perspective(s.view.tan_x, s.view.tan_y, c.near, c.far);
  const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int i = 0; i < 4; ++i) {
    a.frustum_corners[i] = dvec4(s.view.at(corner[i][0], corner[i][1], c.near), 1);
    a.frustum_corners[i + 4] = std::isinf(c.far) ? dvec4(s.view.at(corner[i][0], corner[i][1], 1) - s.view.eye, 0)
                                                 : dvec4(s.view.at(corner[i][0], corner[i][1], c.far), 1);
  }
}

void set_light_case(Stages& s, Analysis& a) {
  const LightSettings& l = s.x.light;
  const bool directional = l.type == LightType::directional;
  a.light = directional ? dvec4(l.to_light, 0) : dvec4(l.position, 1);
  s.light = directional ? dvec4(safe_normalize(l.to_light), 0) : a.light;
  const auto c = classify_light(a.light, s.view.eye, s.view.forward);
  LightCase& out = a.light_case;
  out.world = l.type;
  out.post = c.sign == 0 ? PostLight::directional : c.sign > 0 ? PostLight::point : PostLight::inverted_point;
  out.w = c.w;
  out.reversed_order = c.reversed;
  out.light_post = a.clip_from_world() * a.light;
  const dvec4 post = a.clip_from_world() * s.light;
  const double r = glm::length(dvec3(post));
  out.kappa = r > 0 ? post.w / r : std::copysign(std::numeric_limits<double>::infinity(), post.w);
  out.within_half_texel = std::abs(out.kappa) < 0.5 / s.x.shadow.resolution;
}

/// The square pyramid around a spot's cone. Where the spot stands inside S the pyramid starts at a named near distance, so that
/// the light is not one of its own receivers.
std::vector<Plane> spot_planes(const Stages& s, Analysis& a) {
  const LightSettings& l = s.x.light;
  if (l.type != LightType::spot) return {};
  const double tangent = std::tan(l.cone_deg * kRadians / 2);
  const ViewFrame spot = view_frame(l.position, l.target - l.position, dvec3(0, 1, 0), tangent, tangent);
  double reach = 0;
  for (const dvec3& v : a.scene_body.vertices) reach = std::max(reach, spot.depth(v));
  const Bounds& b = s.scene.bounds;
  const bool inside = glm::all(glm::greaterThanEqual(l.position, b.min)) && glm::all(glm::lessThanEqual(l.position, b.max));
  const double near = inside ? 1e-3 * reach : 0.0;
  if (inside) note(a, "light_near_distance", "The light stands inside the scene: its cone starts at a near distance.", near);
  return frustum_planes(spot, near, std::numeric_limits<double>::infinity());
}

bool contains(std::span<const Plane> planes, const dvec4& point) {
  return std::all_of(planes.begin(), planes.end(), [&](const Plane& p) {
    const dvec4 t = glm::abs(p * point);
    return glm::dot(p, point) >= -8 * epsilon<double>() * (t.x + t.y + t.z + t.w);
  });
}

/// A body that stands in for the receivers where nothing is visible, so that every matrix stays finite.
ConvexBody stand_in(const Stages& s, const Analysis& a) {
  if (s.light.w == 0) return a.scene_body;
  const double size = std::max(glm::length(s.scene.bounds.max - s.scene.bounds.min), 1e-3 * glm::length(dvec3(s.light)));
  const double reach = size > 0 ? size : 1.0;
  const dvec3 toward =
      s.x.light.type == LightType::spot ? safe_normalize(s.x.light.target - s.x.light.position) : dvec3(0, -1, 0);
  const dvec3 centre = dvec3(s.light) + reach * toward;
  return box_body(centre - 0.25 * reach, centre + 0.25 * reach);
}

void set_bodies(Stages& s, Analysis& a) {
  Bounds b = s.scene.bounds;
  if (b.empty()) b.min = b.max = s.view.at(0, 0, s.x.camera.near);
  a.scene_body = box_body(b.min, b.max);
  s.lit_scene = clip(a.scene_body, spot_planes(s, a));
  a.receivers_body = clip(s.lit_scene, s.view_planes);
  a.light_case.inside_frustum = s.light.w != 0 && contains(s.view_planes, s.light);
  a.caster_body = clip(s.lit_scene, frustum_hull_with_light(s.view, s.x.camera.near, s.x.camera.far, s.light));
  const bool in_scene = s.light.w != 0 && contains(a.scene_body.planes, s.light);
  s.light_in_receivers = in_scene && a.light_case.inside_frustum && s.x.light.type == LightType::point;
  a.light_case.inside_receivers = s.light_in_receivers;
}

void set_depth_range(Stages& s, Analysis& a, const ConvexBody& receivers) {
  const CameraSettings& c = s.x.camera;
  Range<double> depth;
  for (const dvec3& v : receivers.vertices) depth.add(s.view.depth(v));
  s.near = std::max(depth.min, c.near);
  s.far = std::max(depth.max, s.near);
  if (s.x.shadow.near_fit == NearFit::off) {
    s.near = c.near;
    if (std::isinf(c.far))
      note(a, "far_from_receivers", "The far distance is infinite: the receivers' largest depth is used.", s.far);
    else
      s.far = c.far;
  } else if (s.x.shadow.near_fit == NearFit::depth) {
    note(a, "near_fit_bounds", "Fitting to visible points is not built yet: the receivers' bounds are used.");
  }
  if (s.x.shadow.focus == Focus::visible)
    note(a, "focus_bounds", "Focusing on visible points is not built yet: the receivers' bounds are used.");
  const double least = s.near * (1 + 1e-7);
  if (s.far < least) {
    note(a, "depth_range_padded", "The receivers have no depth range: it is widened.", s.far - s.near, least - s.near);
    s.far = least;
  }
  a.near = s.near;
  a.far = s.far;
}

/// The uniform plane's normal: a spot's own axis, or the axis of the smallest cone around the receivers.
dvec3 uniform_axis(const Stages& s, const ConvexBody& receivers) {
  if (s.light.w == 0) return dvec3(0);
  if (s.x.light.type == LightType::spot) return safe_normalize(s.x.light.target - s.x.light.position);
  std::vector<dvec3> d;
  for (const dvec3& v : receivers.vertices) d.push_back(safe_normalize(v - dvec3(s.light)));
  return smallest_enclosing_cone<double>(d).axis;
}

std::optional<Warp> warp_of(Technique t) {
  switch (t) {
    case Technique::uniform:
      return Warp::uniform;
    case Technique::lispsm:
      return Warp::lispsm;
    case Technique::lispsm_reference:
      return Warp::lispsm_reference;
    case Technique::glpr:
      return Warp::glpr;
    case Technique::gmnpr:
      return Warp::gmnpr;
    case Technique::minimax:
      return Warp::minimax;
    case Technique::minimax_frustum:
      return Warp::minimax_frustum;
    default:
      return {};
  }
}

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
         model.theta / kRadians, model.phi / kRadians);
    a.technique_used = Technique::uniform;
    strength = {};
  }
  if (s.light.w != 0 && warp != Warp::uniform)
    note(a, "lambda_from_directional_model",
         "The papers derive lambda for directional lights only: theta is taken at the receivers' centroid, the warp in the "
         "light's own "
         "perspective space.",
         model.theta / kRadians);
  a.rho = strength.rho;
  a.lambda = strength.lambda();
  const double tan_x = s.view.tan_x * s.view.tan_y / model.tan_phi;  // across the view-light plane: exact along the image's axes
  const auto e = warp_error(model, strength.rho, tan_x);
  a.model_error = ModelError{e.F_near, e.F_far, e.F_max, e.E_max_line, e.E_max_frustum, e.storage_factor};
  const auto uniform = warp_error(model, 1.0, tan_x);
  if (e.E_max_line > uniform.E_max_line * (1 + 1e-9)) {
    a.worse_than_uniform = true;
    note(a, "worse_than_uniform", "Worse than the uniform map: largest F over the depth range.", e.F_max, uniform.F_max);
  }
  return warped_plane(s.uniform, s.frame.b, warp_range(s, a, receivers), strength.rho, strength.one_minus_rho);
}

dvec4 plane_of_psm(Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  const double shift = s.x.shadow.camera_shift.value_or(0.0);
  a.camera_shift = shift;
  ViewFrame eye = s.view;
  eye.eye -= shift * eye.forward;  // near stays, far grows by the shift (PSM 2002, section 4.2)
  const dmat4 clip = perspective(eye.tan_x, eye.tan_y, s.near, s.far + shift) * eye.view_from_world();
  const auto psm = psm_plane(clip, s.light, receivers);
  if (psm.turned > 0)
    note(a, "aim_turned", "Looking at the cube's centre would leave receivers behind the light's plane: the aim is turned.",
         psm.turned / kRadians);
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

dvec4 technique_plane(Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  const Technique technique = s.x.shadow.technique;
  a.technique_used = technique;
  if (const auto warp = warp_of(technique)) return plane_of_warp(*warp, s, a, receivers);
  if (technique == Technique::psm) return plane_of_psm(s, a, receivers);
  if (technique == Technique::custom) return plane_of_custom(s, a);
  note(a, "technique_not_built", std::string("Technique ") + name_of(technique) + " is not built yet: the uniform map is used.");
  a.technique_used = Technique::uniform;
  return s.uniform;
}

/// The plane must be positive on the receivers; one that is not is replaced by the uniform plane, by name.
void require_positive(dvec4& plane, const Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  const Range<double> c = value_range(plane, receivers);
  if (c.min > 1e-12 * c.max && std::isfinite(c.max)) return;
  note(a, "plane_cuts_receivers", "The vanishing plane cuts the receivers: the uniform map is used.", c.min, 0.0);
  a.technique_used = Technique::uniform;
  plane = s.uniform;
}

void fit_single_map(Stages& s, Analysis& a, const ConvexBody& receivers) {
  std::span<const dvec3> points(receivers.vertices);
  s.uniform = uniform_plane(s.light, uniform_axis(s, receivers));
  s.frame = light_frame(s.light, s.centroid, s.view.forward, s.view.up);
  dvec4 plane = a.receivers_body.empty() ? s.uniform : technique_plane(s, a, points);
  require_positive(plane, s, a, points);
  const auto fit = fit_map<double>(s.frame, plane, points, a.depth_body.vertices);
  a.map_from_world = fit.map_from_world;
  a.vanishing_plane = row(fit.map_from_world, 3);
  if (fit.padded_window) note(a, "window_padded", "The receivers have no extent across the light: the window is padded.");
  if (fit.padded_depth)
    note(a, "depth_padded", "Casters and receivers have no extent along the light: the depth range is padded.");
  if (fit.near_distance_used)
    note(a, "light_near_distance",
         "The light stands in or close to the scene: the map's depth starts at a near distance, here as a fraction of the "
         "farthest receiver's.",
         fit.near_c);
}

void fit_six_maps(Stages& s, Analysis& a, const ConvexBody& receivers) {
  double far = 0;
  for (const dvec3& v : receivers.vertices)
    for (int i = 0; i < 3; ++i) far = std::max(far, std::abs(v[i] - s.light[i]));
  if (!(far > 0)) far = s.near;
  const double near = 1e-3 * far;
  const auto maps = cube_maps(dvec3(s.light), near, far * (1 + 1e-9));
  a.cube_maps_from_world.emplace();
  std::copy(maps.begin(), maps.end(), a.cube_maps_from_world->begin());
  a.technique_used = Technique::uniform;
  note(a, "light_inside_receivers",
       "The light stands among its receivers: no single map exists, six are drawn from a near distance.", near);
}

void compare_with_uniform(const Stages& s, Analysis& a) {
  if (!a.map_from_world || a.technique_used == Technique::uniform) return;
  const std::vector<SurfacePoint> points = sample_scene_box(s.view, a);
  if (points.empty()) return;
  const auto uniform = fit_map<double>(s.frame, s.uniform, a.receivers_body.vertices, a.depth_body.vertices);
  const double here = texel_percentile(points, *a.map_from_world, a, 0.95),
               there = texel_percentile(points, uniform.map_from_world, a, 0.95);
  if (!(here > there * (1 + 1e-9))) return;
  a.worse_than_uniform = true;
  note(a, "worse_than_uniform_texels",
       "Worse than the uniform map: 95th percentile of the texel size m on the scene box's lit sides, in pixels.", here, there);
}

}  // namespace

Analysis analyze(const Experiment& experiment, const Scene& scene) {
  Analysis a;
  a.experiment = experiment;
  a.notes = scene.notes;
  Stages s{.x = experiment, .scene = scene};
  set_camera(s, a);
  set_light_case(s, a);
  set_bodies(s, a);

  const bool nothing_visible = a.receivers_body.empty();
  const ConvexBody receivers = nothing_visible ? stand_in(s, a) : a.receivers_body;
  s.centroid = receivers.centroid();
  if (nothing_visible) {
    note(a, "nothing_visible", "No part of the scene is both in the light and in view: nothing can be shadowed.");
    fit_single_map(s, a, receivers);
    return a;
  }
  set_depth_range(s, a, receivers);
  if (s.light_in_receivers) {
    a.depth_body = receivers;
    fit_six_maps(s, a, receivers);
    return a;
  }
  a.depth_body = clip(s.lit_scene, hull_with_light(receivers, s.light));
  fit_single_map(s, a, receivers);
  compare_with_uniform(s, a);
  return a;
}

}  // namespace psm
