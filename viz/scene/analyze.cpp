// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of an experiment, in order: camera, light case, bodies, the technique's plane, the shared fit, errors.
#include <algorithm>
#include <cmath>

#include "math/light_case.h"
#include "scene/analysis_stages.h"
#include "scene/texel_sampling.h"
#include "scene/visible_receivers.h"

namespace psm {
namespace {

using glm::dmat4, glm::dvec3, glm::dvec4;

void set_camera(Stages& s, Analysis& a) {
  const CameraSettings& c = s.x.camera;
  s.view = camera_frame(s.x);
  s.view_planes = frustum_planes(s.view, c.near, c.far);
  a.view_from_world = s.view.view_from_world();
  a.clip_from_view = perspective(s.view.tan_x, s.view.tan_y, c.near, c.far);
  a.cube_from_world = a.clip_from_world();
  const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int i = 0; i < 4; ++i) {
    a.frustum_corners[i] = dvec4(s.view.at(corner[i][0], corner[i][1], c.near), 1);
    a.frustum_corners[i + 4] = std::isinf(c.far) ? dvec4(s.view.at(corner[i][0], corner[i][1], 1) - s.view.eye, 0)
                                                 : dvec4(s.view.at(corner[i][0], corner[i][1], c.far), 1);
  }
}

void set_light_case(Stages& s, Analysis& a) {
  const LightSettings& l = s.x.light;
  a.light = homogeneous_light(l);
  s.light = l.type == LightType::directional ? dvec4(safe_normalize(l.to_light), 0) : a.light;
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

/// A body that stands in for the receivers where nothing is visible, so that every matrix stays finite.
ConvexBody stand_in(const Stages& s, const Analysis& a) {
  if (s.light.w == 0) return a.scene_body;
  const Bounds& b = s.scene.bounds;
  const double size = std::max(b.empty() ? 0.0 : glm::length(b.max - b.min), 1e-3 * glm::length(dvec3(s.light)));
  const double reach = size > 0 ? size : 1.0;
  const dvec3 toward =
      s.x.light.type == LightType::spot ? safe_normalize(s.x.light.target - s.x.light.position) : dvec3(0, -1, 0);
  const dvec3 centre = dvec3(s.light) + reach * toward;
  return box_body(centre - 0.25 * reach, centre + 0.25 * reach);
}

void set_bodies(Stages& s, Analysis& a) {
  s.view_hull = frustum_hull_with_light(s.view_planes, s.light);
  SceneBodies bodies = scene_bodies(s, a);
  if (bodies.light_near > 0)
    note(a, "light_near_distance", "The light stands inside the scene: its cone starts at a near distance.", bodies.light_near);
  a.light_case.inside_frustum = s.light.w != 0 && contains(s.view_planes, s.light);
  s.light_in_scene = s.light.w != 0 && contains(bodies.scene.planes, s.light);
  s.light_in_receivers = s.light_in_scene && a.light_case.inside_frustum && contains(bodies.light_planes, s.light);
  a.light_case.inside_receivers = s.light_in_receivers;
  a.scene_body = std::move(bodies.scene);
  s.lit_scene = std::move(bodies.lit);
  a.receivers_body = std::move(bodies.receivers);
  a.caster_body = clip(s.lit_scene, s.view_hull);
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
  }
  const double least = s.near * (1 + 1e-7);
  if (s.far < least) {
    note(a, "depth_range_padded", "The receivers have no depth range: it is widened.", s.far - s.near, least - s.near);
    s.far = least;
  }
  a.near = s.near;
  a.far = s.far;
}

/// The part of R that is visible, where the experiment asks for it and somebody knows.
std::optional<ConvexBody> part_in_sight(const Stages& s, Analysis& a) {
  if (s.x.shadow.focus != Focus::visible && s.x.shadow.near_fit != NearFit::depth) return std::nullopt;
  if (s.served.empty()) {
    note(a, "visible_points_missing", "No visible point that faces the light is known: the receivers' bounds are used.");
    return std::nullopt;
  }
  const LightFrame<double> frame = light_frame(s.light, a.receivers_body.centroid(), s.view.forward, s.view.up);
  return visible_part(a.receivers_body, s.view, frame, s.served);
}

/// What the window and the warp are fitted to (focus), and the depth range that the technique uses (near_fit).
void set_fitted_body(Stages& s, Analysis& a, std::span<const SurfacePoint> visible) {
  s.served = points_to_serve(visible, s.light, a.receivers_body);
  const std::optional<ConvexBody> part = part_in_sight(s, a);
  a.fitted_body = part && s.x.shadow.focus == Focus::visible ? *part : a.receivers_body;
  set_depth_range(s, a, part && s.x.shadow.near_fit == NearFit::depth ? *part : a.fitted_body);
  s.centroid = a.fitted_body.centroid();
}

/// The uniform plane's normal: a spot's own axis, or the axis of the smallest cone around the receivers.
dvec3 uniform_axis(const Stages& s, const ConvexBody& receivers) {
  if (s.light.w == 0) return dvec3(0);
  if (s.x.light.type == LightType::spot) return safe_normalize(s.x.light.target - s.x.light.position);
  std::vector<dvec3> d;
  for (const dvec3& v : receivers.vertices) d.push_back(safe_normalize(v - dvec3(s.light)));
  return smallest_enclosing_cone<double>(d).axis;
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
  if (!a.receivers_body.empty()) a.map_from_world = rule_breaking_map(s, a, points);
  if (a.map_from_world) {
    a.vanishing_plane = row(*a.map_from_world, 3);
    return;
  }
  dvec4 plane = a.receivers_body.empty() ? s.uniform : technique_plane(s.x.shadow.technique, s, a, points);
  require_positive(plane, s, a, points);
  const auto fit = fit_map<double>(s.frame, plane, points, a.depth_body.vertices, s.light_in_scene);
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

/// The post-perspective space that the shifted eye sees (PSM 2002, Figure 7); the camera's own where nothing is shifted.
void set_cube(const Stages& s, Analysis& a) {
  const CameraSettings& c = s.x.camera;
  ViewFrame eye = s.view;
  eye.eye -= a.camera_shift * eye.forward;
  a.cube_from_world = perspective(eye.tan_x, eye.tan_y, c.near, c.far + a.camera_shift) * eye.view_from_world();
}

void compare_with_uniform(const Stages& s, Analysis& a) {
  if (!a.map_from_world || a.technique_used == Technique::uniform) return;
  const std::vector<SurfacePoint> stand_ins = s.served.empty() ? sample_receivers(s.view, a) : std::vector<SurfacePoint>();
  const std::span<const SurfacePoint> points = s.served.empty() ? stand_ins : s.served;
  if (points.empty()) return;
  const auto uniform = fit_map<double>(s.frame, s.uniform, a.fitted_body.vertices, a.depth_body.vertices, s.light_in_scene);
  const double here = texel_percentile(points, *a.map_from_world, a, 0.95),
               there = texel_percentile(points, uniform.map_from_world, a, 0.95);
  if (!(here > there * (1 + 1e-9))) return;
  a.worse_than_uniform = true;
  note(a, "worse_than_uniform_texels",
       "Worse than the uniform map: 95th percentile of the texel size m in pixels, " +
           std::string(s.served.empty() ? "estimated on surfaces all through the receivers' body that face eye and light."
                                        : "over the visible points."),
       here, there);
}

}  // namespace

Analysis analyze(const Experiment& experiment, const Scene& scene, std::span<const SurfacePoint> visible) {
  Analysis a;
  a.experiment = experiment;
  a.notes = scene.notes;
  Stages s{.x = experiment, .scene = scene};
  set_camera(s, a);
  set_light_case(s, a);
  set_bodies(s, a);

  if (a.receivers_body.empty()) {
    note(a, "nothing_visible", "No part of the scene is both in the light and in view: nothing can be shadowed.");
    const ConvexBody receivers = stand_in(s, a);
    s.centroid = receivers.centroid();
    fit_single_map(s, a, receivers);
    return a;
  }
  set_fitted_body(s, a, visible);
  if (s.light_in_receivers) {
    a.depth_body = a.receivers_body;
    fit_six_maps(s, a, a.receivers_body);
    return a;
  }
  a.depth_body = clip(s.lit_scene, hull_with_light(a.fitted_body, s.light));
  fit_single_map(s, a, a.fitted_body);
  set_cube(s, a);
  compare_with_uniform(s, a);
  return a;
}

}  // namespace psm
