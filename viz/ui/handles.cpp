// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/handles.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "math/projective.h"

namespace psm {
namespace {

/// Right, up and back of the picture, in world space.
struct PictureAxes {
  glm::dvec3 right, up, back;
  explicit PictureAxes(const OrbitCamera& camera)
      : right(row(camera.view_from_space, 0)), up(row(camera.view_from_space, 1)), back(row(camera.view_from_space, 2)) {}
};

void add(std::vector<Handle>& out, HandleKind kind, const glm::dvec4& point, const ViewPicture& world, glm::ivec2 size) {
  const glm::dvec4 clip = world.clip_from_list * point;
  if (!(clip.w > 0.0) || !(point.w > 0.0)) return;
  const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
  out.push_back({kind, glm::dvec3(point) / point.w, 0.5 * glm::dvec2(1.0 + ndc.x, 1.0 - ndc.y) * glm::dvec2(size)});
}

/// World units that one pixel spans at this point, to the right and downwards alike.
double world_per_pixel(const HandleDrag& drag, const glm::dvec3& point) {
  const double depth = -(drag.camera.view_from_space * glm::dvec4(point, 1.0)).z;
  return 2.0 * std::max(depth, 0.0) / (drag.camera.clip_from_view[1][1] * drag.size.y);
}

glm::dvec3 moved(const HandleDrag& drag, glm::dvec2 pixel, bool vertical) {
  const PictureAxes axes(drag.camera);
  const glm::dvec2 way = (pixel - drag.start) * world_per_pixel(drag, drag.handle.position);
  if (!vertical) return drag.handle.position + way.x * axes.right - way.y * axes.up;
  // The vertical's image may be short where one looks along it: it never moves faster than four times the mouse.
  const double seen = std::max(0.25, std::abs(axes.up.y));
  return drag.handle.position + glm::dvec3(0.0, -way.y / std::copysign(seen, axes.up.y), 0.0);
}

/// The sun follows the mouse as a mark on a transparent ball around the view's target does; on its far side it moves the other
/// way.
glm::dvec3 turned_sun(const HandleDrag& drag, glm::dvec2 pixel) {
  const PictureAxes axes(drag.camera);
  const glm::dvec3 to_light = drag.before.light.to_light;
  const double radius = std::max(40.0, glm::length(drag.handle.pixel - 0.5 * glm::dvec2(drag.size)));
  const double side = glm::dot(axes.back, safe_normalize(to_light)) < 0.0 ? -1.0 : 1.0;
  const glm::dvec2 angle = side * (pixel - drag.start) / radius;
  const glm::dvec3 axis = angle.x * axes.up + angle.y * axes.right;
  if (!(glm::length(axis) > 0.0)) return to_light;
  return glm::dvec3(glm::rotate(glm::dmat4(1.0), glm::length(axis), glm::normalize(axis)) * glm::dvec4(to_light, 0.0));
}

}  // namespace

const char* name_of(HandleKind kind) {
  constexpr const char* names[] = {"camera", "camera's target", "light", "light's target", "sun"};
  return names[std::size_t(kind)];
}

Role role_of(HandleKind kind) {
  return kind == HandleKind::camera_position || kind == HandleKind::camera_target ? Role::frustum : Role::light;
}

std::vector<Handle> handles(const ViewPicture& world, const Experiment& experiment, glm::ivec2 size) {
  std::vector<Handle> out;
  add(out, HandleKind::camera_position, {experiment.camera.position, 1.0}, world, size);
  add(out, HandleKind::camera_target, {experiment.camera.target, 1.0}, world, size);
  if (experiment.light.type == LightType::spot) add(out, HandleKind::light_target, {experiment.light.target, 1.0}, world, size);
  if (experiment.light.type != LightType::directional) {
    add(out, HandleKind::light_position, {experiment.light.position, 1.0}, world, size);
    return out;
  }
  for (const DrawPoint& point : world.list.points)
    if (point.role == Role::light) {
      add(out, HandleKind::sun, point.position, world, size);
      break;
    }
  return out;
}

std::optional<Handle> picked_handle(const std::vector<Handle>& handles, glm::dvec2 pixel, double reach) {
  std::optional<Handle> best;
  for (const Handle& handle : handles) {
    const double distance = glm::length(handle.pixel - pixel);
    // A later one lies on top: the light wins over a camera at the same place.
    if (distance <= reach) best = handle, reach = distance;
  }
  return best;
}

Experiment dragged(const HandleDrag& drag, glm::dvec2 pixel, bool vertical) {
  Experiment out = drag.before;
  switch (drag.handle.kind) {
    case HandleKind::camera_position:
      out.camera.position = moved(drag, pixel, vertical);
      break;
    case HandleKind::camera_target:
      out.camera.target = moved(drag, pixel, vertical);
      break;
    case HandleKind::light_position:
      out.light.position = moved(drag, pixel, vertical);
      break;
    case HandleKind::light_target:
      out.light.target = moved(drag, pixel, vertical);
      break;
    case HandleKind::sun:
      out.light.to_light = turned_sun(drag, pixel);
      break;
  }
  return out;
}

}  // namespace psm
