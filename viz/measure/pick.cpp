// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/projective.h"
#include "scene/eye_and_light.h"

namespace psm {
namespace {

// Relative to the ray's length: hits closer together than this are one surface.
constexpr double kSame = 1e-7;
constexpr int kMostSurfaces = 64;  // on one light ray

glm::dvec3 towards_light(const Analysis& a, const glm::dvec3& p) { return glm::dvec3(a.light) - a.light.w * p; }

/// Farther from `p` than anything in the scene.
double beyond_scene(const Analysis& a, const glm::dvec3& p) {
  double reach = 0.0;
  for (const glm::dvec3& v : a.scene_body.vertices) reach = std::max(reach, glm::length(v - p));
  return 2.0 * reach;
}

/// The surface that the eye sees in the direction of `p`, if that is `p`.
std::optional<SurfacePoint> seen_at(const RayTracer& tracer, const Analysis& a, const glm::dvec3& p) {
  const glm::dvec4 clip = a.clip_from_world() * glm::dvec4(p, 1.0);
  const double edge = clip.w * (1.0 + kSame);
  if (!(clip.w > 0.0) || std::abs(clip.x) > edge || std::abs(clip.y) > edge || std::abs(clip.z) > edge) return std::nullopt;
  const glm::dvec3 eye = a.experiment.camera.position, forward = -glm::dvec3(row(a.view_from_world, 2));
  const double depth = glm::dot(forward, p - eye);  // what is nearer than the near plane is not drawn
  const auto hit = tracer.nearest(eye, p - eye, a.experiment.camera.near / depth * (1.0 - kSame), 1.0 + kSame);
  return hit && hit->distance > 1.0 - kSame ? std::optional(hit->point) : std::nullopt;
}

/// The first surface as the light sees it, unless that is the receiver itself.
std::optional<glm::dvec3> occluder_of(const RayTracer& tracer, const Analysis& a, const SurfacePoint& receiver) {
  if (!tracer.shadowed(receiver, a.light)) return std::nullopt;
  const glm::dvec3& p = receiver.position;
  const glm::dvec3 start =
      a.light.w != 0.0 ? glm::dvec3(a.light) / a.light.w : p + beyond_scene(a, p) * safe_normalize(towards_light(a, p));
  const auto hit = tracer.nearest(start, p - start, 0.0, 1.0 - kSame);
  return hit ? std::optional(hit->point.position) : std::nullopt;
}

/// Both ends of the light ray of a point of the map, the light's end first; nothing where it is not finite.
std::optional<std::pair<glm::dvec3, glm::dvec3>> light_ray(const Analysis& a, int layer, const glm::dvec2& at) {
  const bool six = !a.map_from_world && a.cube_maps_from_world;
  if (!a.map_from_world && !(six && layer >= 0 && layer < 6)) return std::nullopt;
  const glm::dmat4 world_from_map = glm::inverse(six ? (*a.cube_maps_from_world)[std::size_t(layer)] : *a.map_from_world);
  const glm::dvec4 p = world_from_map * glm::dvec4(at, -1.0, 1.0), q = world_from_map * glm::dvec4(at, 1.0, 1.0);
  const glm::dvec3 start = glm::dvec3(p) / p.w, end = glm::dvec3(q) / q.w;
  if (!(p.w > 0.0 && q.w > 0.0) || !std::isfinite(glm::length(start) + glm::length(end))) return std::nullopt;
  const bool away = glm::dot(end - start, towards_light(a, start)) > 0.0;
  return away ? std::pair(end, start) : std::pair(start, end);
}

}  // namespace

std::optional<Pick> pick_ray(const RayTracer& tracer, const Analysis& analysis, const glm::dvec3& origin,
                             const glm::dvec3& direction, double from, double to) {
  const auto hit = tracer.nearest(origin, direction, from, to);
  if (!hit) return std::nullopt;
  return Pick{hit->point, occluder_of(tracer, analysis, hit->point), seen_at(tracer, analysis, hit->point.position).has_value()};
}

std::optional<Pick> pick_pixel(const RayTracer& tracer, const Analysis& analysis, const glm::dvec2& pixel) {
  const Experiment& x = analysis.experiment;
  const glm::dvec2 at(2.0 * pixel.x / x.image.width - 1.0, 1.0 - 2.0 * pixel.y / x.image.height);
  if (!(std::abs(at.x) <= 1.0 && std::abs(at.y) <= 1.0)) return std::nullopt;
  const ViewFrame view = camera_frame(x);
  const glm::dvec3 direction = view.forward + at.x * view.tan_x * view.right + at.y * view.tan_y * view.up;  // of depth 1
  return pick_ray(tracer, analysis, view.eye, direction, x.camera.near, x.camera.far);
}

std::optional<Pick> pick_texel(const RayTracer& tracer, const Analysis& analysis, int layer, const glm::dvec2& at) {
  const auto ray = light_ray(analysis, layer, at);
  if (!ray) return std::nullopt;
  const auto& [start, end] = *ray;
  std::optional<Pick> first;
  double from = 0.0;
  for (int i = 0; i < kMostSurfaces; ++i) {
    const auto hit = tracer.nearest(start, end - start, from, 1.0 + kSame);
    if (!hit) break;
    if (!first) first = Pick{hit->point, std::nullopt, false};
    const auto seen = seen_at(tracer, analysis, hit->point.position);
    if (seen && glm::dot(seen->normal, towards_light(analysis, seen->position)) > 0.0) {
      const bool other = i > 0;
      return Pick{*seen, other ? std::optional(first->receiver.position) : std::nullopt, true};
    }
    from = hit->distance + kSame;
  }
  return first;
}

}  // namespace psm
