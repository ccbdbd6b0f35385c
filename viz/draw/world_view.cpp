// SPDX-License-Identifier: GPL-3.0-or-later
// The world: scene, camera, light, and the bodies between which a shadow map is fitted.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/sketch.h"
#include "geom/frustum.h"
#include "math/projective.h"

namespace psm {
namespace {

constexpr int light_rays = 4;

Box world_extent(const Analysis& analysis) {
  Box box;
  view_extent(ViewId::world, analysis, box.min, box.max);
  return box;
}

/// Room around the extent in every direction, at least `least` times its radius, so that a flat scene does not cut what stands on
/// it.
Limits world_limits(const Box& extent, double radius, double least, double clear, double most) {
  const glm::dvec3 half = glm::max(extent.half(), glm::dvec3(least * radius));
  const Box roomy{extent.center() - half, extent.center() + half};
  return {roomy.scaled(clear), roomy.scaled(most)};
}

class WorldView {
 public:
  WorldView(const Analysis& analysis, double aspect)
      : analysis_(analysis),
        camera_(view_camera(ViewId::world, analysis, aspect)),
        view_(camera_),
        extent_(world_extent(analysis)),
        radius_(glm::length(extent_.half()) > 0.0 ? glm::length(extent_.half()) : 0.25 * camera_.distance),
        sketch_(world_limits(extent_, radius_, 0.5, 1.2, 1.8)) {
    place_light();
  }

  ViewPicture picture() {
    scene_bounds();
    map_window();
    caster_body();
    receivers_body();
    frustum();
    camera();
    shifted_eye();
    vanishing_plane();
    light();
    ViewPicture picture;
    picture.id = ViewId::world;
    picture.title = "World";
    picture.clip_from_world = picture.clip_from_list = view_.clip_from_space;
    picture.list = std::move(sketch_.list);
    return picture;
  }

 private:
  const ConvexBody& lit_body() const {
    return analysis_.receivers_body.empty() ? analysis_.scene_body : analysis_.receivers_body;
  }

  void scene_bounds() {
    const ConvexBody& s = analysis_.scene_body;
    if (s.empty()) return;
    sketch_.body(s, glm::dmat4(1.0), 0.0, {Role::scene_bounds, 1.0, LineStyle::dashed});
    sketch_.label(view_.furthest(s.vertices, {0.4, 1.0}), "S", Role::scene_bounds, 3);
  }

  void receivers_body() {
    const ConvexBody& r = analysis_.receivers_body;
    if (r.empty()) return;
    sketch_.body(r, glm::dmat4(1.0), 0.16, {Role::receivers_body, 1.75});
    sketch_.label(view_.furthest(r.vertices, {0.2, -1.0}), "R", Role::receivers_body, 8);
  }

  void caster_body() {
    const bool extended = analysis_.experiment.view.world_body == WorldBody::M;
    const ConvexBody body = extended ? extended_frustum() : analysis_.caster_body;
    if (body.empty()) return;
    sketch_.body(body, glm::dmat4(1.0), 0.10, {Role::caster_body, 1.5});
    std::vector<glm::dvec3> shown;
    for (const glm::dvec3& p : body.vertices)
      if (sketch_.limits().fade(p) > 0.5) shown.push_back(p);
    if (!shown.empty()) sketch_.label(view_.furthest(shown, {-0.6, 1.0}), extended ? "M" : "H", Role::caster_body, 7);
  }

  /// M = hull(V + l), as far as the view reaches.
  ConvexBody extended_frustum() const {
    const CameraSettings& camera = analysis_.experiment.camera;
    const double tan_y = std::tan(0.5 * glm::radians(camera.vertical_fov_deg));
    const ViewFrame v{camera.position,
                      -glm::dvec3(row(analysis_.view_from_world, 2)),
                      glm::dvec3(row(analysis_.view_from_world, 0)),
                      glm::dvec3(row(analysis_.view_from_world, 1)),
                      tan_y * analysis_.experiment.image.aspect(),
                      tan_y};
    const Box& room = sketch_.limits().outer;
    return clip(box_body(room.min, room.max), frustum_hull_with_light(v, camera.near, camera.far, analysis_.light));
  }

  /// What the map covers: the cube of map clip space, pulled back; its edges near the scene, and its part of S as a body.
  void map_window() {
    if (!analysis_.map_from_world || analysis_.depth_body.empty()) return;
    const glm::dmat4& map_from_world = *analysis_.map_from_world;
    const glm::dmat4 world_from_map = glm::inverse(map_from_world);
    std::array<glm::dvec4, 8> corners;
    const auto cube = cube_corners();
    for (int i = 0; i < 8; ++i) corners[i] = world_from_map * at(cube[i]);
    Sketch edges(world_limits(extent_, radius_, 0.2, 1.02, 1.3));
    for (const auto& [i, j] : box_edges()) edges.line_in_front(corners[i], corners[j], {Role::map_window, 1.75});
    sketch_.append(std::move(edges.list));
    if (!analysis_.scene_body.empty()) covered_part(map_from_world);
  }

  void covered_part(const glm::dmat4& map_from_world) {
    std::vector<Plane> sides;
    for (int i = 0; i < 3; ++i) {
      for (double sign : {1.0, -1.0}) sides.push_back(row(map_from_world, 3) + sign * row(map_from_world, i));
    }
    const ConvexBody covered = clip(analysis_.scene_body, sides);
    if (covered.empty()) return;
    sketch_.body(covered, glm::dmat4(1.0), 0.05, {Role::map_window, 1.0, LineStyle::solid, 0.45});
    sketch_.label(view_.furthest(covered.vertices, {-1.0, 0.2}), "map window", Role::map_window, 6);
  }

  void frustum() {
    const auto& corners = analysis_.frustum_corners;
    for (const auto& [i, j] : box_edges()) sketch_.line_in_front(corners[i], corners[j], {Role::frustum, 2.0});
    std::vector<glm::dvec3> ends;
    for (int i = 0; i < 4; ++i) {
      const auto side = clip_segment(corners[i], corners[i + 4], sketch_.limits().inner);
      const auto shown = side ? view_.visible_middle(side->a, side->b) : std::nullopt;
      if (shown) ends.push_back(*shown);
    }
    if (!ends.empty()) sketch_.label(view_.furthest(ends, {1.0, -0.3}), "V", Role::frustum, 8);
  }

  /// A pyramid of the frustum's shape at the eye, with a mark on its upper side and an arrow along the view.
  void camera() {
    const Experiment& e = analysis_.experiment;
    const glm::dvec3 eye = e.camera.position;
    const glm::dvec3 right = row(analysis_.view_from_world, 0), up = row(analysis_.view_from_world, 1);
    const glm::dvec3 forward = -glm::dvec3(row(analysis_.view_from_world, 2));
    const double size = std::min(view_.length_of(0.045, eye), 0.3 * radius_);
    const double tan_y = std::tan(0.5 * glm::radians(e.camera.vertical_fov_deg)), tan_x = tan_y * e.image.aspect();
    const double depth = size / std::max({1.0, tan_x, tan_y});
    const glm::dvec3 middle = eye + depth * forward, x = depth * tan_x * right, y = depth * tan_y * up;
    const std::array<glm::dvec3, 4> base{middle - x - y, middle + x - y, middle + x + y, middle - x + y};
    const Pen pen{Role::frustum, 2.0};
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 &p = base[i], &q = base[(i + 1) % 4];
      sketch_.line(eye, p, pen);
      sketch_.line(p, q, pen);
      sketch_.fill({at(eye), at(q), at(p)}, Role::frustum, 0.35);
    }
    sketch_.fill({at(base[3] + 0.2 * x), at(base[2] - 0.2 * x), at(middle + 1.2 * y + 0.4 * size * up)}, Role::frustum, 0.9);
    sketch_.line(eye, eye + 3.2 * size * forward, pen, Head::arrow);
    sketch_.point(eye, Role::frustum, 4.5);
    sketch_.label(eye, "eye", Role::frustum, 10);
  }

  /// Where the eye stands for the map after it stepped back (PSM 2002, section 4.2), and its frustum.
  void shifted_eye() {
    if (!(analysis_.camera_shift > 0.0)) return;
    const glm::dvec3 forward = -glm::dvec3(row(analysis_.view_from_world, 2));
    const glm::dvec3 eye = analysis_.experiment.camera.position - analysis_.camera_shift * forward;
    const glm::dmat4 world_from_cube = glm::inverse(analysis_.cube_from_world);
    const auto cube = cube_corners();
    const Pen pen{Role::frustum, 1.5, LineStyle::dashed};
    for (int i = 4; i < 8; ++i) {
      const glm::dvec4 far = world_from_cube * at(cube[i]), next = world_from_cube * at(cube[4 + (i + 1) % 4]);
      sketch_.line_in_front(at(eye), far, pen);
      sketch_.line_in_front(far, next, pen);
    }
    sketch_.point(eye, Role::neutral, 4.0);
    sketch_.label(eye, "eye, shifted", Role::frustum, 9);
  }

  /// A grid on the plane beside the scene; nothing where the plane is far away or at infinity.
  void vanishing_plane() {
    const auto shown = shown_vanishing_plane(analysis_);
    if (!shown) return;
    const glm::dvec4 plane = *shown;
    const double norm = glm::length(glm::dvec3(plane));
    const glm::dvec3 base = lit_body().empty() ? extent_.center() : lit_body().centroid();
    const double distance = glm::dot(plane, at(base)) / norm;
    if (!(std::abs(distance) <= 1.6 * radius_)) return;
    const glm::dvec3 n = glm::dvec3(plane) / norm, center = base - distance * n;
    const glm::dvec3 towards = glm::dvec3(analysis_.light) - analysis_.light.w * center;
    const glm::dvec3 in_plane = safe_normalize(towards - glm::dot(towards, n) * n);
    const glm::dvec3 v = in_plane == glm::dvec3(0.0) ? perpendicular(n) : in_plane, u = glm::cross(v, n);
    const bool used = shown == analysis_.vanishing_plane;
    plane_patch(center, 0.3 * radius_ * u, 0.3 * radius_ * v,
                used ? "vanishing plane c = 0" : "vanishing plane: not usable here");
  }

  void plane_patch(const glm::dvec3& center, const glm::dvec3& u, const glm::dvec3& v, const char* name) {
    const std::vector<glm::dvec3> corners{center - u - v, center + u - v, center + u + v, center - u + v};
    std::vector<glm::dvec4> polygon;
    for (const glm::dvec3& p : corners) polygon.push_back(at(p));
    sketch_.list.fills.push_back({polygon, Role::vanishing_plane, 0.18});
    constexpr int cells = 6;
    for (int i = 0; i <= cells; ++i) {
      const double t = 2.0 * i / cells - 1.0;
      const bool border = i == 0 || i == cells;
      const Pen pen{Role::vanishing_plane, border ? 2.0 : 1.0, LineStyle::solid, border ? 1.0 : 0.6};
      sketch_.line(center + t * u - v, center + t * u + v, pen);
      sketch_.line(center - u + t * v, center + u + t * v, pen);
    }
    sketch_.point(center, Role::vanishing_plane, 4.5);
    sketch_.label(view_.furthest(corners, {0.0, 1.0}), name, Role::vanishing_plane, 7);
  }

  /// A lamp stands where it is, unless that is too far away to be shown; then, like a sun, at the picture's edge.
  void place_light() {
    const glm::dvec4 l = analysis_.light;
    if (l.w != 0.0 && extent_.scaled(1.001).contains(glm::dvec3(l) / l.w)) {
      light_at_ = glm::dvec3(l) / l.w;
      return;
    }
    light_far_ = true;
    const auto targets = ray_targets(lit_body(), l, 1);
    const glm::dvec3 lit = targets.empty() ? extent_.center() : targets.front();
    const glm::dvec3 direction = safe_normalize(glm::dvec3(l) - l.w * lit);
    double inside = 0.25 * radius_, outside = 1.1 * radius_;
    if (!view_.sees(lit + outside * direction, 0.84)) {
      for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (inside + outside);
        (view_.sees(lit + middle * direction, 0.84) ? inside : outside) = middle;
      }
      outside = inside;
    }
    light_at_ = lit + outside * direction;
  }

  void light() {
    const LightType type = analysis_.experiment.light.type;
    draw_lamp(sketch_, view_, light_at_, type == LightType::directional ? 12 : 8);
    std::string text = "light";
    if (light_far_ && type != LightType::directional) {
      text += " (" + short_number(glm::length(glm::dvec3(analysis_.light) - extent_.center())) + " away)";
    }
    sketch_.label(light_at_, text, Role::light, 10);
    draw_rays();
    if (type == LightType::spot && !light_far_) cone();
  }

  /// A lamp's rays all start at the lamp. A sun sends one ray from where it stands, and shorter parallel ones beside it.
  void draw_rays() {
    const auto targets = ray_targets(lit_body(), analysis_.light, light_rays);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const glm::dvec3 to_light = safe_normalize(glm::dvec3(analysis_.light) - analysis_.light.w * targets[i]);
      const double reach = glm::length(light_at_ - targets[light_far_ ? 0 : i]);
      const double gap = std::min(0.3 * reach, view_.length_of(0.038, light_at_));
      const double length = light_far_ && i > 0 ? 0.5 * reach : reach - gap;
      sketch_.line(targets[i] + length * to_light, targets[i], {Role::light, 1.75}, Head::arrow);
    }
  }

  /// The spot's cone up to its target, or to where it is as wide as the scene.
  void cone() {
    const LightSettings& light = analysis_.experiment.light;
    const glm::dvec3 axis = safe_normalize(light.target - light.position);
    if (axis == glm::dvec3(0.0)) return;
    const double tan_half = std::tan(0.5 * glm::radians(light.cone_deg));
    const double depth = std::min(glm::length(light.target - light.position), radius_ / std::max(tan_half, 0.2));
    const glm::dvec3 center = light.position + depth * axis, x = perpendicular(axis), y = glm::cross(axis, x);
    constexpr int sides = 48;
    const Pen pen{Role::light, 1.5, LineStyle::dashed};
    auto rim = [&](int i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      return center + depth * tan_half * (std::cos(angle) * x + std::sin(angle) * y);
    };
    for (int i = 0; i < sides; ++i) {
      sketch_.line(rim(i), rim(i + 1), {Role::light, 1.5});
      if (i % (sides / 4) == 0) sketch_.line(light.position, rim(i), pen);
    }
  }

  const Analysis& analysis_;
  OrbitCamera camera_;
  Viewpoint view_;
  Box extent_;
  double radius_;
  Sketch sketch_;
  glm::dvec3 light_at_{0.0};
  bool light_far_ = false;
};

}  // namespace

std::optional<glm::dvec4> shown_vanishing_plane(const Analysis& a) {
  const ShadowSettings& shadow = a.experiment.shadow;
  const bool refused = shadow.technique == Technique::custom && a.technique_used != Technique::custom;
  return refused && shadow.plane ? shadow.plane : a.vanishing_plane;
}

ViewPicture describe_world(const Analysis& analysis, glm::ivec2 size) { return WorldView(analysis, aspect_of(size)).picture(); }

}  // namespace psm
