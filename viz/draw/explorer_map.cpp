// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/explorer_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/projective.h"
#include "scene/eye_and_light.h"
#include "scene/light_angles.h"

namespace psm {
namespace {

constexpr double kMargin = 14.0, kTop = 44.0;  // the view's title above
constexpr double kWide = 1.2;                  // pages of this aspect have room beside the map
constexpr double kMapShare = 0.58;             // of a wide page's width, at most
constexpr double kLeastBeside = 200.0;         // less room than that is of no use: the map has the whole page

PageRect map_rect(const glm::dvec2& page) {
  const double beside = std::min(kMapShare * page.x, page.y);
  const bool wide = page.x > kWide * page.y && page.x - beside - kMargin >= kLeastBeside;
  const double width = wide ? beside : page.x;
  return {{kMargin, kTop}, {std::max(kMargin + 1.0, width - kMargin), std::max(kTop + 1.0, page.y - kMargin)}};
}

/// Everything that a slice should hold, as depth along the view and height across it.
void fit_slice(const Analysis& a, ExplorerMap& map) {
  glm::dvec2 low(INFINITY), high(-INFINITY);
  const auto add = [&](const glm::dvec3& p) {
    const glm::dvec2 q(glm::dot(map.forward, p - map.eye), glm::dot(map.across, p - map.eye));
    low = glm::min(low, q), high = glm::max(high, q);
  };
  for (const glm::dvec3& v : a.scene_body.vertices) add(v);
  add(map.eye);
  add(a.experiment.light.position);
  const double size = std::max({high.x - low.x, high.y - low.y, 1e-300});
  low -= 0.08 * size, high += 0.08 * size;
  // Some room behind the eye, where the interesting lights are.
  low.x = std::min(low.x, -0.35 * size);
  const glm::dvec2 room = map.max - map.min, extent = high - low;
  map.scale = std::min(room.x / extent.x, room.y / extent.y);
  const glm::dvec2 center = 0.5 * (low + high);
  map.middle = 0.5 * (map.min + map.max) - map.scale * glm::dvec2(center.x, -center.y);
}

}  // namespace

glm::dvec2 ExplorerMap::page_of(double theta, double roll) const {
  return middle + scale * std::sin(0.5 * theta) * glm::dvec2(std::cos(roll), -std::sin(roll));
}

glm::dvec2 ExplorerMap::page_of_direction(const glm::dvec3& to_light) const {
  const glm::dvec3 l = safe_normalize(to_light);
  const double x = glm::dot(right, l), y = glm::dot(up, l);
  return page_of(std::atan2(std::hypot(x, y), glm::dot(forward, l)), std::atan2(y, x));
}

glm::dvec2 ExplorerMap::page_of_position(const glm::dvec3& p) const {
  return middle + scale * glm::dvec2(glm::dot(forward, p - eye), -glm::dot(across, p - eye));
}

glm::dvec2 ExplorerMap::page_of(const Analysis& a) const {
  return directions ? page_of_direction(glm::dvec3(a.light)) : page_of_position(glm::dvec3(a.light));
}

glm::dvec2 ExplorerMap::clamped(const glm::dvec2& page) const {
  if (!directions) return glm::clamp(page, min, max);
  const glm::dvec2 way = page - middle;
  return glm::length(way) > scale ? middle + scale / glm::length(way) * way : page;
}

bool ExplorerMap::contains(const glm::dvec2& page) const { return glm::length(clamped(page) - page) < 1e-9 * scale; }

Experiment ExplorerMap::with_light_at(const Experiment& before, const glm::dvec2& page, double reach) const {
  Experiment e = before;
  const glm::dvec2 way = clamped(page) - middle;
  if (!directions) {
    const glm::dvec3 off = e.light.position - eye;
    const glm::dvec3 aside = off - glm::dot(forward, off) * forward - glm::dot(across, off) * across;
    e.light.position = eye + aside + way.x / scale * forward - way.y / scale * across;
    if (std::abs(way.x) <= reach) e.light.position = position_at_depth(e, 0.0);
    return e;
  }
  constexpr double half_turn = std::numbers::pi;
  const double radius = glm::length(way), boundary = std::sqrt(0.5) * scale;
  const glm::dvec3 side = radius > 0.0 ? glm::normalize(way.x * right - way.y * up) : theta_side(before);
  const double theta = std::abs(radius - boundary) <= reach ? 0.5 * half_turn : 2.0 * std::asin(std::min(1.0, radius / scale));
  e.light.to_light = to_light_at(before, theta, side);
  return e;
}

ExplorerMap explorer_map(const Analysis& a, const glm::dvec2& page) {
  const Experiment& e = a.experiment;
  const ViewFrame view = camera_frame(e);
  const PageRect rect = map_rect(page);
  ExplorerMap map;
  map.directions = e.light.type == LightType::directional;
  map.min = rect.min, map.max = rect.max;
  map.eye = view.eye, map.forward = view.forward, map.right = view.right, map.up = view.up;
  map.across = e.view.explorer_slice == ExplorerSlice::side ? view.up : view.right;
  if (!map.directions) {
    fit_slice(a, map);
    return map;
  }
  map.middle = 0.5 * (map.min + map.max);
  map.scale = 0.5 * std::min(map.max.x - map.min.x, map.max.y - map.min.y);
  return map;
}

PageRect beside_explorer_map(const glm::dvec2& page) {
  const PageRect map = map_rect(page);
  return {{map.max.x + kMargin, map.min.y}, {page.x - kMargin, map.max.y}};
}

}  // namespace psm
