// SPDX-License-Identifier: GPL-3.0-or-later
// A probe as lines and labels, in the space of each view.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "draw/probe.h"
#include "draw/sketch.h"
#include "draw/world_to_cube.h"
#include "math/projective.h"

namespace psm {
namespace {

constexpr Pen kFootprint{Role::texel_grid, 2.5}, kLightRay{Role::light, 2.0}, kViewRay{Role::frustum, 2.0};
constexpr Pen kShadowed{Role::light, 1.75, LineStyle::dashed};  // the light ray beyond the occluder

std::string size_text(const Probe& probe) {
  if (!probe.lit_side) return "unlit side";
  return "m = " + short_number(probe.size.m) + " px, d = " + short_number(probe.d) + " px";
}

std::string distance_text(const char* name, double distance) { return std::string(name) + " = " + short_number(distance); }

glm::dvec3 to_light_at(const Probe& probe, const Analysis& a) {
  return safe_normalize(glm::dvec3(a.light) - a.light.w * probe.receiver.position);
}

Limits box(double half) { return {{glm::dvec3(-half), glm::dvec3(half)}, {glm::dvec3(-half), glm::dvec3(half)}}; }

/// The polygon's outline and its fill, under a projective map of the world.
void footprint(Sketch& sketch, const Probe& probe, const glm::dmat4& map) {
  std::vector<glm::dvec4> corners;
  for (const glm::dvec3& p : probe.footprint) corners.push_back(map * at(p));
  if (corners.empty()) return;
  sketch.fill(corners, Role::texel_grid, 0.6);
  for (std::size_t i = 0; i < corners.size(); ++i) sketch.line_through(corners[i], corners[(i + 1) % corners.size()], kFootprint);
}

// ---- the world: Figure 2 of the 2002 paper ----------------------------------------------------------------------------

class WorldProbe {
 public:
  WorldProbe(const Probe& probe, const Analysis& a, double aspect)
      : probe_(probe),
        eye_(a.experiment.camera.position),
        p_(probe.receiver.position),
        to_light_(to_light_at(probe, a)),
        view_(view_camera(ViewId::world, a, aspect)),
        sketch_(everywhere(a)) {
    const double far = std::isinf(probe.r_s) ? reach_ : probe.r_s;
    light_end_ = p_ + far * to_light_;
  }

  DrawList list() {
    footprint(sketch_, probe_, glm::dmat4(1.0));
    rays();
    angles();
    sketch_.point(p_, Role::texel_grid, 4.0);
    sketch_.label(p_, size_text(probe_), Role::texel_grid, 20);
    return std::move(sketch_.list);
  }

 private:
  /// No limit that matters: rays may leave the scene.
  Limits everywhere(const Analysis& a) {
    Box extent;
    view_extent(ViewId::world, a, extent.min, extent.max);
    reach_ = 1.5 * glm::length(extent.half()) + glm::length(extent.center() - p_);
    const Box wide{extent.min - 20.0 * reach_, extent.max + 20.0 * reach_};
    return {wide, wide};
  }

  void rays() {
    const glm::dvec3 first = probe_.occluder.value_or(p_);
    sketch_.line(light_end_, first, kLightRay, probe_.occluder ? Head::none : Head::arrow);
    if (probe_.occluder) {
      sketch_.line(first, p_, kShadowed, Head::arrow);
      sketch_.point(first, Role::light, 4.5);
      sketch_.label(first, "occluder", Role::light, 14);
    }
    ray_label(light_end_, distance_text("rₛ", probe_.r_s), Role::light);
    if (!probe_.seen) return;
    sketch_.line(p_, eye_, kViewRay);
    ray_label(eye_, distance_text("rᵢ", probe_.r_i), Role::frustum);
  }

  void ray_label(const glm::dvec3& end, const std::string& text, Role role) {
    if (const auto middle = view_.visible_middle(p_, end)) sketch_.label(*middle, text, role, 18);
  }

  void angles() {
    const double radius = view_.length_of(0.09, p_);
    sketch_.line(p_, p_ + 1.6 * radius * probe_.receiver.normal, {Role::text, 1.5, LineStyle::dashed}, Head::arrow);
    arc(to_light_, 0.8 * radius, "α = " + short_number(glm::degrees(probe_.alpha)) + "°", Role::light);
    if (probe_.seen)
      arc(safe_normalize(eye_ - p_), 1.1 * radius, "β = " + short_number(glm::degrees(probe_.beta)) + "°", Role::frustum);
  }

  /// From the normal to `direction`.
  void arc(const glm::dvec3& direction, double radius, const std::string& text, Role role) {
    constexpr int steps = 16;
    const glm::dvec3& n = probe_.receiver.normal;
    const glm::dvec3 aside = safe_normalize(direction - glm::dot(direction, n) * n);
    const double angle = std::atan2(glm::dot(direction, aside), glm::dot(direction, n));
    const auto on_arc = [&](double t) { return p_ + radius * (std::cos(t * angle) * n + std::sin(t * angle) * aside); };
    for (int i = 0; i < steps; ++i) sketch_.line(on_arc(double(i) / steps), on_arc(double(i + 1) / steps), {role, 1.5});
    sketch_.label(on_arc(0.5), text, role, 16);
  }

  const Probe& probe_;
  glm::dvec3 eye_, p_, to_light_, light_end_{0.0};
  double reach_ = 1.0;
  Viewpoint view_;
  Sketch sketch_;
};

// ---- cube, eye, map ---------------------------------------------------------------------------------------------------

DrawList cube_probe(const Probe& probe, const Analysis& a) {
  constexpr double clear = 2.5, limit = 3.0, ray_start = -1.7;  // as the cube view's own rays
  Sketch sketch({box(clear).inner, box(limit).outer});
  const WorldToCube step = world_to_cube(a);
  const glm::dmat4& cube = step.shown_from_world;
  const glm::dvec4 p = cube * at(probe.receiver.position);
  footprint(sketch, probe, cube);
  const glm::dvec4 first = probe.occluder ? cube * at(*probe.occluder) : p;
  sketch.line_through(cube * a.light, first, kLightRay);
  if (probe.occluder) sketch.line_through(first, p, kShadowed);
  const glm::dvec3 divided = glm::dvec3(p) / p.w;
  if (!(p.w != 0.0) || !sketch.limits().outer.contains(divided)) return std::move(sketch.list);
  if (probe.seen) {
    const glm::dvec4 in_cube = a.cube_from_world * at(probe.receiver.position);
    const glm::dvec4 start = step.shown_from_cube * glm::dvec4(glm::dvec2(in_cube) / in_cube.w, ray_start, 1.0);
    sketch.line(divided, glm::dvec3(start) / start.w, kViewRay);
  }
  sketch.point(divided, Role::texel_grid, 4.0);
  sketch.label(divided, size_text(probe), Role::texel_grid, 20);
  return std::move(sketch.list);
}

DrawList eye_probe(const Probe& probe, const Analysis& a) {
  Sketch sketch(box(1.0));
  const glm::dmat4 clip_from_world = a.clip_from_world();
  const glm::dvec4 p = clip_from_world * at(probe.receiver.position);
  if (!(p.w > 0.0)) return {};
  std::vector<glm::dvec4> corners;
  for (const glm::dvec3& corner : probe.footprint) corners.push_back(clip_from_world * at(corner));
  if (!corners.empty()) sketch.fill(corners, Role::texel_grid, 0.6, Sides::front);
  for (std::size_t i = 0; i < corners.size(); ++i)
    sketch.line_in_front(corners[i], corners[(i + 1) % corners.size()], kFootprint);
  const glm::dvec4 first = probe.occluder ? clip_from_world * at(*probe.occluder) : p;
  sketch.line_in_front(clip_from_world * a.light, first, kLightRay);
  if (probe.occluder) sketch.line_in_front(first, p, kShadowed);
  const glm::dvec3 divided = glm::dvec3(p) / p.w;
  if (!sketch.limits().outer.contains(divided)) return std::move(sketch.list);
  sketch.point(divided, Role::texel_grid, 3.0);
  sketch.label(divided, size_text(probe), Role::texel_grid, 20);
  return std::move(sketch.list);
}

/// The texel itself, and lines towards it from all sides: it may be smaller than a pixel.
DrawList map_probe(const Probe& probe, const Analysis& a) {
  if (!probe.inside_map) return {};
  const double n = a.experiment.shadow.resolution;
  const glm::dmat4 sheet = sheet_from_map(a, probe.layer);
  const glm::dvec2 low = glm::dvec2(probe.texel) / n * 2.0 - 1.0, middle = low + 1.0 / n;
  const double scale = sheet[0][0], inner = std::max(1.0 / n, 0.02 / (a.experiment.view.map_zoom * scale)), outer = 5.0 * inner;
  Sketch sketch(box(1.0));
  const auto place = [&](double x, double y) { return glm::dvec3(sheet * glm::dvec4(x, y, 0.0, 1.0)); };
  const std::array<glm::dvec3, 4> corners{place(low.x, low.y), place(low.x + 2.0 / n, low.y),
                                          place(low.x + 2.0 / n, low.y + 2.0 / n), place(low.x, low.y + 2.0 / n)};
  std::vector<glm::dvec4> square;
  for (int i = 0; i < 4; ++i) {
    square.push_back(at(corners[i]));
    sketch.line(corners[i], corners[(i + 1) % 4], kFootprint);
  }
  sketch.list.fills.push_back({square, Role::light, 0.9});
  for (const glm::dvec2& way : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
    const glm::dvec2 from = middle + outer * way, to = middle + inner * way;
    sketch.line(place(from.x, from.y), place(to.x, to.y), {Role::light, 2.5});
  }
  sketch.label(place(middle.x, middle.y), "texel " + std::to_string(probe.texel.x) + ", " + std::to_string(probe.texel.y),
               Role::light, 20);
  return std::move(sketch.list);
}

}  // namespace

std::optional<SheetTexel> on_map(const Analysis& analysis, const glm::dvec2& sheet_point) {
  const double n = analysis.experiment.shadow.resolution;
  const bool two = analysis.map_from_world && analysis.map_beyond_from_world;
  const int layers = two ? 2 : analysis.map_from_world ? 1 : analysis.cube_maps_from_world ? 6 : 0;
  for (int layer = 0; layer < layers; ++layer) {
    const glm::dvec2 p = glm::inverse(sheet_from_map(analysis, layer)) * glm::dvec4(sheet_point, 0.0, 1.0);
    if (!(std::abs(p.x) < 1.0 && std::abs(p.y) < 1.0)) continue;
    const glm::dvec2 texel = glm::floor((0.5 * p + 0.5) * n);
    return SheetTexel{two ? 0 : layer, (texel + 0.5) / n * 2.0 - 1.0};  // two maps share u and v, and so their light rays
  }
  return std::nullopt;
}

DrawList probe_list(const Probe& probe, ViewId id, const Analysis& analysis, glm::ivec2 size) {
  switch (id) {
    case ViewId::world:
      return WorldProbe(probe, analysis, aspect_of(size)).list();
    case ViewId::cube:
      return cube_probe(probe, analysis);
    case ViewId::map:
      return map_probe(probe, analysis);
    case ViewId::eye:
      return eye_probe(probe, analysis);
    case ViewId::body:
    case ViewId::curves:
    case ViewId::explorer:
      return {};
  }
  return {};
}

}  // namespace psm
