// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/handles.h"

#include <algorithm>
#include <cmath>

#include "math/projective.h"
#include "scene/light_angles.h"

namespace psm {
namespace {

constexpr double half_pi = 1.57079632679489661923;

/// Right, up and back of the picture, in world space.
struct PictureAxes {
  glm::dvec3 right, up, back;
  explicit PictureAxes(const OrbitCamera& camera)
      : right(row(camera.view_from_space, 0)), up(row(camera.view_from_space, 1)), back(row(camera.view_from_space, 2)) {}
};

/// Nothing for what lies behind the viewer.
std::optional<glm::dvec2> pixel_of(const glm::dvec4& point, const ViewPicture& world, glm::ivec2 size) {
  const glm::dvec4 clip = world.clip_from_list * point;
  if (!(clip.w > 0.0) || !(point.w > 0.0)) return std::nullopt;
  const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
  return 0.5 * glm::dvec2(1.0 + ndc.x, 1.0 - ndc.y) * glm::dvec2(size);
}

void add(std::vector<Handle>& out, HandleKind kind, const glm::dvec4& point, const ViewPicture& world, glm::ivec2 size) {
  if (const auto pixel = pixel_of(point, world, size)) out.push_back({kind, glm::dvec3(point) / point.w, *pixel});
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

/// The sun moves like a mark on a ball around the middle of the picture, seen from afar; pushed over the ball's outline it goes
/// on behind. Its own distance from the middle gives the ball's size.
glm::dvec3 turned_sun(const HandleDrag& drag, glm::dvec2 pixel) {
  const PictureAxes axes(drag.camera);
  const glm::dvec3 to_light = drag.before.light.to_light;
  const glm::dvec3 unit = safe_normalize(to_light);
  const glm::dvec2 start(glm::dot(unit, axes.right), glm::dot(unit, axes.up));
  const double from_middle = glm::length(drag.handle.pixel - 0.5 * glm::dvec2(drag.size));
  const double radius = std::max(0.25 * drag.size.y, glm::length(start) > 0.2 ? from_middle / glm::length(start) : 0.0);
  const glm::dvec2 way = (pixel - drag.start) / radius;
  if (way == glm::dvec2(0.0)) return to_light;
  glm::dvec2 place = start + glm::dvec2(way.x, -way.y);
  double side = glm::dot(unit, axes.back) < 0.0 ? -1.0 : 1.0;
  if (const double out = glm::length(place); out > 1.0) {
    place *= std::max(0.0, 2.0 - out) / out;
    side = -side;
  }
  const double depth = side * std::sqrt(std::max(0.0, 1.0 - glm::dot(place, place)));
  return glm::length(to_light) * (place.x * axes.right + place.y * axes.up + depth * axes.back);
}

/// Through the light and the handle's new place, with a normal as near the old one as that allows.
glm::dvec4 moved_plane(const HandleDrag& drag, glm::dvec2 pixel, bool turned) {
  constexpr double kTurnPerPixel = 0.01;  // radians
  const LightSettings& light = drag.before.light;
  const bool sun = light.type == LightType::directional;
  const glm::dvec3 place = turned && sun ? drag.handle.position : moved(drag, pixel, turned);
  glm::dvec3 normal = safe_normalize(glm::dvec3(drag.plane));
  const glm::dvec3 held = safe_normalize(sun ? light.to_light : light.position - place);
  if (turned && sun) {
    const double angle = kTurnPerPixel * (pixel.x - drag.start.x);
    normal = std::cos(angle) * normal + std::sin(angle) * glm::cross(held, normal);
  }
  const glm::dvec3 allowed = safe_normalize(normal - glm::dot(normal, held) * held);
  return allowed == glm::dvec3(0.0) ? drag.plane : glm::dvec4(allowed, -glm::dot(allowed, place));
}

Experiment moved_to(const HandleDrag& drag, glm::dvec2 pixel, bool vertical) {
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
    case HandleKind::plane:
      out.shadow.technique = Technique::custom;
      out.shadow.plane = moved_plane(drag, pixel, vertical);
      break;
  }
  return out;
}

double light_w(const Experiment& e) {
  if (e.light.type != LightType::directional) return light_depth(e);
  return glm::dot(view_forward(e.camera), safe_normalize(e.light.to_light));
}

/// The nearest pixel at which w = 0, to first order; nothing where w does not depend on the mouse.
std::optional<glm::dvec2> pixel_of_zero(const HandleDrag& drag, glm::dvec2 pixel, bool vertical) {
  const auto w = [&](double x, double y) { return light_w(moved_to(drag, pixel + glm::dvec2(x, y), vertical)); };
  const glm::dvec2 slope = 0.5 * glm::dvec2(w(1, 0) - w(-1, 0), w(0, 1) - w(0, -1));
  const glm::dvec2 way = -w(0, 0) * slope / glm::dot(slope, slope);
  // Where the slope vanishes this is no number.
  if (!(glm::length(way) < 1e6)) return std::nullopt;
  return pixel + way;
}

/// w = 0 up to rounding, as the sliders have it.
void put_at_zero(Experiment& e) {
  if (e.light.type == LightType::directional)
    e.light.to_light = to_light_at(e, half_pi, theta_side(e));
  else
    e.light.position = position_at_depth(e, 0.0);
}

}  // namespace

const char* name_of(HandleKind kind) {
  constexpr const char* names[] = {"camera", "camera's target", "light", "light's target", "sun", "vanishing plane"};
  return names[std::size_t(kind)];
}

Role role_of(HandleKind kind) {
  if (kind == HandleKind::plane) return Role::vanishing_plane;
  return kind == HandleKind::camera_position || kind == HandleKind::camera_target ? Role::frustum : Role::light;
}

std::vector<Handle> handles(const ViewPicture& world, const Experiment& experiment, glm::ivec2 size) {
  std::vector<Handle> out;
  const auto add_first = [&](HandleKind kind, Role role) {
    const auto& points = world.list.points;
    const auto point = std::find_if(points.begin(), points.end(), [&](const DrawPoint& p) { return p.role == role; });
    if (point != points.end()) add(out, kind, point->position, world, size);
  };
  add_first(HandleKind::plane, Role::vanishing_plane);
  add(out, HandleKind::camera_position, {experiment.camera.position, 1.0}, world, size);
  add(out, HandleKind::camera_target, {experiment.camera.target, 1.0}, world, size);
  if (experiment.light.type == LightType::spot) add(out, HandleKind::light_target, {experiment.light.target, 1.0}, world, size);
  if (experiment.light.type == LightType::directional)
    add_first(HandleKind::sun, Role::light);
  else
    add(out, HandleKind::light_position, {experiment.light.position, 1.0}, world, size);
  return out;
}

bool is_labelled(const Handle& handle, const ViewPicture& world, glm::ivec2 size) {
  return std::any_of(world.list.labels.begin(), world.list.labels.end(), [&](const DrawLabel& label) {
    const auto pixel = pixel_of(label.anchor, world, size);
    return pixel && glm::length(*pixel - handle.pixel) < 2.0;
  });
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

Experiment dragged(const HandleDrag& drag, glm::dvec2 pixel, bool vertical, double snap_pixels) {
  Experiment out = moved_to(drag, pixel, vertical);
  const bool lit = drag.handle.kind == HandleKind::light_position || drag.handle.kind == HandleKind::sun;
  if (!lit || !(snap_pixels > 0.0) || pixel == drag.start) return out;
  const auto zero = pixel_of_zero(drag, pixel, vertical);
  if (!zero || glm::length(*zero - pixel) > snap_pixels) return out;
  out = moved_to(drag, *zero, vertical);
  put_at_zero(out);
  return out;
}

}  // namespace psm
