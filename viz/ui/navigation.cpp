// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/navigation.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "math/projective.h"

namespace psm {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double step_factor = 0.88;  // of the distance, for one wheel step

double wrapped(double degrees) { return degrees - 360.0 * std::floor((degrees + 180.0) / 360.0); }

/// Right, up and forward of a view matrix, in its space.
glm::dvec3 axis(const glm::dmat4& view_from_space, int i) { return glm::dvec3(row(view_from_space, i)); }

glm::dvec3 rotated(const glm::dvec3& v, double angle, const glm::dvec3& axis) {
  return glm::dvec3(glm::rotate(glm::dmat4(1.0), angle, axis) * glm::dvec4(v, 0.0));
}

}  // namespace

OrbitSettings resolved(const OrbitSettings& orbit, const OrbitCamera& camera) {
  OrbitSettings out = orbit;
  out.target = camera.target;
  out.distance = camera.distance;
  return out;
}

void turn(OrbitSettings& orbit, glm::dvec2 drag) {
  orbit.yaw_deg = wrapped(orbit.yaw_deg - 180.0 * drag.x);
  orbit.pitch_deg = std::clamp(orbit.pitch_deg - 180.0 * drag.y, -90.0, 90.0);
}

void pan(OrbitSettings& orbit, const OrbitCamera& camera, glm::dvec2 drag) {
  const double height = 2.0 * orbit.distance / camera.clip_from_view[1][1];
  orbit.target -= height * (drag.x * axis(camera.view_from_space, 0) + drag.y * axis(camera.view_from_space, 1));
}

void zoom(OrbitSettings& orbit, double steps) { orbit.distance *= std::pow(step_factor, std::clamp(steps, -20.0, 20.0)); }

void pan_map(ViewSettings& view, double half_height, glm::dvec2 drag) { view.map_center -= 2.0 * half_height * drag; }

void zoom_map(ViewSettings& view, double steps, glm::dvec2 about) {
  const double before = view.map_zoom;
  view.map_zoom = std::clamp(before * std::pow(step_factor, -std::clamp(steps, -20.0, 20.0)), 0.1, 1000.0);
  view.map_center = about + (view.map_center - about) * (before / view.map_zoom);
}

void turn(CameraSettings& camera, glm::dvec2 drag) {
  const glm::dvec3 up = safe_normalize(camera.up);
  const glm::dvec3 offset = rotated(camera.position - camera.target, -pi * drag.x, up);
  const glm::dvec3 side = glm::cross(up, offset);
  if (!(glm::length(side) > 0.0)) return;
  // Never over the pole: there the image would flip.
  constexpr double margin = 0.02;
  const double from_up = std::atan2(glm::length(side), glm::dot(up, offset));
  const double wanted = std::clamp(from_up + pi * drag.y, margin, pi - margin);
  camera.position = camera.target + rotated(offset, wanted - from_up, glm::normalize(side));
}

void pan(CameraSettings& camera, glm::dvec2 drag) {
  const glm::dvec3 to_target = camera.target - camera.position;
  const glm::dmat4 view = look_along<double>(camera.position, to_target, camera.up);
  const double height = 2.0 * glm::length(to_target) * std::tan(0.5 * glm::radians(camera.vertical_fov_deg));
  const glm::dvec3 move = -height * (drag.x * axis(view, 0) + drag.y * axis(view, 1));
  camera.position += move;
  camera.target += move;
}

void dolly(CameraSettings& camera, double steps) {
  const double factor = std::pow(step_factor, std::clamp(steps, -20.0, 20.0));
  camera.position = camera.target + (camera.position - camera.target) * factor;
}

}  // namespace psm
