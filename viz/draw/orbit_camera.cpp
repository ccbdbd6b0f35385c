// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras that turn around what a view shows.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "draw/split_at_infinity.h"
#include "draw/view.h"

namespace psm {
namespace {

constexpr double vertical_fov = glm::radians(40.0);
constexpr double fit_margin = 0.93;   // of the picture's half width and height
constexpr double cube_extent = 1.45;  // room for the axes, the infinity plane and the rays' ends

/// Columns: right, up, back. From the angles themselves, so that looking straight down is not special.
glm::dmat3 orbit_axes(const OrbitSettings& orbit) {
  const double yaw = glm::radians(orbit.yaw_deg), pitch = glm::radians(orbit.pitch_deg);
  const glm::dvec3 right(std::cos(yaw), 0.0, -std::sin(yaw));
  const glm::dvec3 back(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
  return {right, glm::cross(back, right), back};
}

/// The least distance from which every corner of the box is inside the picture.
double fit_distance(const glm::dmat3& axes, const glm::dvec3& target, const Box& box, glm::dvec2 tan_half) {
  double distance = 0.0;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
    const glm::dvec3 p = glm::transpose(axes) * (corner - target);
    distance =
        std::max({distance, p.z + std::abs(p.x) / (fit_margin * tan_half.x), p.z + std::abs(p.y) / (fit_margin * tan_half.y)});
  }
  return distance;
}

/// A size to fall back on where the box is a point.
double box_radius(const Box& box) {
  const double radius = glm::length(box.half());
  if (radius > 0.0) return radius;
  const double from_origin = glm::length(box.center());
  return from_origin > 0.0 ? 0.1 * from_origin : 1.0;
}

void add_position(Bounds& extent, const glm::dvec3& position, const Bounds& scene) {
  const double reach = 3.0 * glm::length(scene.max - scene.min);
  const glm::dvec3 offset = position - 0.5 * (scene.min + scene.max);
  if (scene.empty() || glm::length(offset) <= reach) extent.add(position);
}

/// H, or what stands in for it where nothing casts a shadow.
Bounds body_extent(const Analysis& analysis) {
  Bounds extent;
  for (const ConvexBody* body : {&analysis.caster_body, &analysis.receivers_body, &analysis.scene_body}) {
    for (const glm::dvec3& v : body->vertices) extent.add(v);
    if (!extent.empty()) return extent;
  }
  extent.add(analysis.experiment.camera.position);
  extent.add(analysis.experiment.camera.target);
  return extent;
}

}  // namespace

OrbitCamera orbit_camera(const OrbitSettings& orbit, const glm::dvec3& extent_min, const glm::dvec3& extent_max, double aspect) {
  const Box box{extent_min, extent_max};
  const glm::dmat3 axes = orbit_axes(orbit);
  const double tan_half = std::tan(0.5 * vertical_fov), radius = box_radius(box);
  OrbitCamera camera;
  const bool unset = orbit.distance <= 0.0 && orbit.target == glm::dvec3(0.0);
  camera.target = unset ? box.center() : orbit.target;
  camera.distance = orbit.distance > 0.0 ? orbit.distance : fit_distance(axes, camera.target, box, {tan_half * aspect, tan_half});
  if (!(camera.distance > 0.0)) camera.distance = 2.0 * radius;
  camera.eye = camera.target + camera.distance * axes[2];
  const glm::dmat3 to_view = glm::transpose(axes);
  camera.view_from_space = glm::dmat4(to_view);
  camera.view_from_space[3] = glm::dvec4(-(to_view * camera.eye), 1.0);
  const double reach = radius + glm::length(camera.target - box.center());
  camera.clip_from_view = glm::perspectiveRH_NO(vertical_fov, aspect, 0.02 * camera.distance, camera.distance + 8.0 * reach);
  return camera;
}

void view_extent(ViewId id, const Analysis& analysis, glm::dvec3& extent_min, glm::dvec3& extent_max) {
  Bounds extent;
  if (id == ViewId::body) {
    extent = body_extent(analysis);
  } else if (id == ViewId::cube) {
    extent = {glm::dvec3(-cube_extent), glm::dvec3(cube_extent)};
  } else {
    const Experiment& e = analysis.experiment;
    Bounds scene;
    for (const glm::dvec3& v : analysis.scene_body.vertices) scene.add(v);
    extent = scene;
    // The eye is always shown; a lamp only where it does not make everything else small.
    extent.add(e.camera.position);
    if (e.light.type != LightType::directional) add_position(extent, e.light.position, scene);
    if (scene.empty()) extent.add(e.camera.target);
  }
  extent_min = extent.min;
  extent_max = extent.max;
}

OrbitCamera view_camera(ViewId id, const Analysis& analysis, double aspect) {
  glm::dvec3 extent_min, extent_max;
  view_extent(id, analysis, extent_min, extent_max);
  const ViewSettings& view = analysis.experiment.view;
  if (id == ViewId::body) return orbit_camera(view.body, extent_min, extent_max, aspect);
  if (id != ViewId::cube) return orbit_camera(view.world, extent_min, extent_max, aspect);
  const glm::dvec3 mirror(1.0, 1.0, -1.0);
  OrbitSettings orbit = view.cube;
  orbit.target *= mirror;
  OrbitCamera camera = orbit_camera(orbit, extent_min, extent_max, aspect);
  camera.view_from_space *= glm::scale(glm::dmat4(1.0), mirror);
  camera.eye *= mirror;
  camera.target *= mirror;
  return camera;
}

}  // namespace psm
