// SPDX-License-Identifier: GPL-3.0-or-later
// The unit cube: everything after the eye's projection P V, where the light may be a point, an inverted point or a direction, and
// where what crosses the camera plane is torn through infinity. On the way from the world to the cube all of it goes through that
// step's own map.
#include <cmath>
#include <optional>

#include "draw/sketch.h"
#include "draw/world_to_cube.h"
#include "math/projective.h"

namespace psm {
namespace {

constexpr double limit = 3.0;        // cubes
constexpr double clear_limit = 2.5;  // beyond this it fades
constexpr double body_limit = 1.75;  // the same for bodies, whose fills end there
constexpr double patch_half = 1.35;  // of the infinity plane
constexpr int light_rays = 4;

Limits cube_limits(double clear) { return {{glm::dvec3(-clear), glm::dvec3(clear)}, {glm::dvec3(-limit), glm::dvec3(limit)}}; }

/// Depth of the plane to which P sends the plane at infinity: (f + n) / (f - n), and 1 for f = infinity. A shift grows f.
double infinity_depth(const CameraSettings& camera, double shift) {
  const double far = camera.far + shift;
  return std::isinf(far) ? 1.0 : (far + camera.near) / (far - camera.near);
}

class CubeView {
 public:
  CubeView(const Analysis& analysis, double aspect)
      : analysis_(analysis),
        view_(view_camera(ViewId::cube, analysis, aspect)),
        sketch_(cube_limits(clear_limit)),
        step_(world_to_cube(analysis)),
        light_(step_.shown_from_world * analysis.light) {}

  ViewPicture picture() {
    bodies();
    cube();
    if (shifted()) own_frustum();
    axes();
    eye();
    infinity_plane();
    light_rays_in_cube();
    light();
    ViewPicture picture;
    picture.id = ViewId::cube;
    picture.title = title();
    picture.scene = ScenePicture::projective;
    picture.cube_from_world = step_.shown_from_world;
    picture.cube_limit = limit;
    picture.clip_from_list = view_.clip_from_space;
    picture.clip_from_world = view_.clip_from_space * picture.cube_from_world;
    picture.list = std::move(sketch_.list);
    return picture;
  }

 private:
  const ConvexBody& lit_body() const {
    return analysis_.receivers_body.empty() ? analysis_.scene_body : analysis_.receivers_body;
  }

  bool on_the_way() const { return step_.withdrawn > 0.0; }
  bool shifted() const { return analysis_.camera_shift > 0.0; }

  std::string title() const {
    if (std::isinf(step_.withdrawn)) return "World, eye at infinity";
    if (on_the_way()) return "Eye " + short_number(step_.withdrawn) + " behind its place";
    return shifted() ? "Unit cube, eye moved back by " + short_number(analysis_.camera_shift) : "Unit cube";
  }

  /// A point of the cube, where this step shows it; homogeneous.
  glm::dvec4 shown(const glm::dvec3& in_cube) const { return step_.shown_from_cube * at(in_cube); }

  void bodies() {
    const glm::dmat4& shown_from_world = step_.shown_from_world;
    const ConvexBody &h = analysis_.caster_body, &r = analysis_.receivers_body;
    Sketch bodies(cube_limits(body_limit));
    if (!h.empty()) {
      bodies.body(h, shown_from_world, 0.09, {Role::caster_body, 1.5});
      body_label(h, {-0.8, 1.0}, "H'", Role::caster_body, 6);
    }
    if (!r.empty()) {
      bodies.body(r, shown_from_world, 0.15, {Role::receivers_body, 1.75});
      body_label(r, {0.5, -1.0}, "R'", Role::receivers_body, 7);
    }
    sketch_.append(std::move(bodies.list));
  }

  void body_label(const ConvexBody& body, const glm::dvec2& direction, const char* text, Role role, int priority) {
    std::vector<glm::dvec3> shown;
    for (const auto& [i, j] : body_edges(body)) {
      const glm::dvec4 p = step_.shown_from_world * at(body.vertices[i]), q = step_.shown_from_world * at(body.vertices[j]);
      for (const Piece& piece : split_segment(p, q, cube_limits(body_limit).inner)) shown.insert(shown.end(), {piece.a, piece.b});
    }
    if (!shown.empty()) sketch_.label(view_.furthest(shown, direction), text, role, priority);
  }

  /// The frustum, whose image the cube is.
  void cube() {
    std::array<glm::dvec4, 8> corners;
    for (int i = 0; i < 8; ++i) corners[i] = shown(cube_corners()[i]);
    for (const auto& [i, j] : box_edges())
      sketch_.line_in_front(corners[i], corners[j], {Role::frustum, i < 4 && j < 4 ? 2.5 : 2.0});
    frustum_label("near", {corners[0], corners[1]}, {0.0, -1.0});
    frustum_label("far", {corners[6], corners[7]}, {1.0, 1.0});
  }

  /// On the part of an edge that is shown; nothing where that is too short to be told from a point.
  void frustum_label(const char* text, const std::array<glm::dvec4, 2>& edge, const glm::dvec2& direction) {
    const auto piece = clip_segment(edge[0], edge[1], sketch_.limits().inner);
    if (!piece || glm::distance(piece->a, piece->b) < 0.2) return;
    const bool below = direction.x == 0.0;
    sketch_.label(below ? 0.5 * (piece->a + piece->b) : view_.furthest({piece->a, piece->b}, direction), text, Role::frustum, 8);
  }

  /// The camera's own frustum, which the shifted one holds (PSM 2002, Figure 7).
  void own_frustum() {
    std::array<glm::dvec4, 8> corners;
    for (int i = 0; i < 8; ++i) corners[i] = step_.shown_from_world * analysis_.frustum_corners[i];
    std::vector<glm::dvec3> ends;
    for (const auto& [i, j] : box_edges()) {
      sketch_.line_in_front(corners[i], corners[j], {Role::frustum, 1.75, LineStyle::dashed});
      if (const auto piece = clip_segment(corners[i], corners[j], sketch_.limits().inner))
        ends.insert(ends.end(), {piece->a, piece->b});
    }
    if (!ends.empty()) sketch_.label(view_.furthest(ends, {-0.4, 1.0}), "V'", Role::frustum, 7);
  }

  /// Beside the near face's lower corner, where they are in nothing's way.
  void axes() {
    const glm::dvec4 corner = shown(glm::dvec3(-1.0));
    const glm::dvec3 origin = glm::dvec3(corner) / corner.w;
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 tip = origin;
      tip[i] += 0.5;
      sketch_.line(origin, tip, {Role::text, 2.5}, Head::arrow);
      sketch_.label(tip, std::string(1, "xyz"[i]) + "'", Role::text, 5);
    }
  }

  /// Where the eye is; from infinity on the negative z' axis, its view rays are parallel.
  void eye() {
    const glm::dvec4 place = step_.shown_from_cube * glm::dvec4(0.0, 0.0, -1.0, 0.0);
    const glm::dvec3 p = glm::dvec3(place) / place.w;
    if (on_the_way() && sketch_.limits().inner.contains(p)) {
      sketch_.point(p, Role::frustum, 4.5);
      sketch_.label(p, "eye", Role::frustum, 9);
      for (int i = 0; i < 4; ++i) sketch_.line_in_front(place, shown(cube_corners()[i]), {Role::frustum, 1.5});
      return;
    }
    std::vector<glm::dvec3> tails;
    for (double x : {-0.5, 0.5}) {
      for (double y : {-0.5, 0.5}) {
        const glm::dvec4 tail = shown({x, y, -1.7}), head = shown({x, y, -1.08});
        tails.push_back(glm::dvec3(tail) / tail.w);
        sketch_.line(tails.back(), glm::dvec3(head) / head.w, {Role::frustum, 1.5}, Head::arrow);
      }
    }
    sketch_.label(view_.furthest(tails, {-1.0, -0.5}), "from the eye", Role::frustum, 1);
  }

  void infinity_plane() {
    const double z_in_cube = infinity_depth(analysis_.experiment.camera, analysis_.camera_shift);
    const glm::dvec4 middle = shown({0.0, 0.0, z_in_cube});
    const double z = middle.z / middle.w;
    if (!(middle.w > 0.0 && z < clear_limit)) return;
    const std::vector<glm::dvec3> corners{
        {-patch_half, -patch_half, z}, {patch_half, -patch_half, z}, {patch_half, patch_half, z}, {-patch_half, patch_half, z}};
    std::vector<glm::dvec4> polygon;
    for (int i = 0; i < 4; ++i) {
      polygon.push_back(at(corners[i]));
      sketch_.line(corners[i], corners[(i + 1) % 4], {Role::infinity, 1.75, LineStyle::dashed});
    }
    sketch_.fill(polygon, Role::infinity, 0.10);
    const std::string where = on_the_way() ? "" : " z' = " + short_number(z_in_cube, 4);
    sketch_.label(view_.furthest(corners, {1.0, 0.3}), "∞ plane" + where, Role::infinity, 9);
  }

  /// From the light to the receiver, as light travels. Where a ray crosses w = 0 it leaves towards infinity and comes back from
  /// the other side, so an inverted light's rays converge on it.
  void light_rays_in_cube() {
    bool named = false;
    for (const glm::dvec3& target : ray_targets(lit_body(), analysis_.light, light_rays)) {
      const glm::dvec4 end = step_.shown_from_world * at(target);
      for (const Piece& piece : split_segment(light_, end, sketch_.limits().outer)) {
        const Pen pen{Role::light, 1.75};
        if (!piece.cut_b) {
          sketch_.piece(piece, pen, Head::arrow);
        } else if (const auto exit = draw_exit(piece, pen); exit && !named) {
          sketch_.label(*exit, "∞", Role::infinity, 6);
          named = true;
        }
      }
    }
  }

  /// A ray that leaves for infinity: the head stands where it leaves the clear part of the picture. None where that is out of
  /// sight.
  std::optional<glm::dvec3> draw_exit(const Piece& piece, const Pen& pen) {
    const auto clear = clip_segment(at(piece.a), at(piece.b), sketch_.limits().inner);
    const auto seen = clear ? view_.visible_part(clear->a, clear->b) : std::nullopt;
    if (!seen) {
      sketch_.piece(piece, pen);
      return std::nullopt;
    }
    sketch_.piece({piece.a, seen->b}, pen, Head::arrow);
    sketch_.piece({seen->b, piece.b}, pen);
    return seen->b;
  }

  void light() {
    // A position gains depth as the eye moves back; a direction keeps its case until the eye is at infinity.
    const bool in_place = !shifted() && !on_the_way();
    const PostLight post = in_place         ? analysis_.light_case.post
                           : light_.w > 0.0 ? PostLight::point
                           : light_.w < 0.0 ? PostLight::inverted_point
                                            : PostLight::directional;
    const glm::dvec3 p = glm::dvec3(light_) / light_.w;
    if (post == PostLight::directional || !std::isfinite(p.x + p.y + p.z)) return direction_label();
    const std::string name = post == PostLight::point ? "l' (point)" : "l' (inverted point)";
    if (sketch_.limits().outer.contains(p) && view_.sees(p, 0.95)) {
      draw_lamp(sketch_, view_, p, 8);
      sketch_.label(p, name, Role::light, 10);
    } else {
      light_outside(p, name);
    }
  }

  /// An arrow towards a light that is too far away to be shown, with its coordinates.
  void light_outside(const glm::dvec3& p, const std::string& name) {
    const glm::dvec3 direction = safe_normalize(p);
    const Pen pen{Role::light, 2.5, LineStyle::dashed};
    glm::dvec3 tip = direction * 1.7;
    for (int i = 0; i < 8 && !view_.sees(tip, 0.9); ++i) tip *= 0.92;
    sketch_.line(0.8 * tip, tip, pen, Head::arrow);
    const std::string where = short_number(p.x) + ", " + short_number(p.y) + ", " + short_number(p.z);
    sketch_.label(tip, name + " at (" + where + ")", Role::light, 10);
  }

  void direction_label() {
    for (const DrawLine& line : sketch_.list.lines) {
      if (line.role != Role::light) continue;
      if (const auto middle = view_.visible_middle(glm::dvec3(line.a), glm::dvec3(line.b))) {
        return sketch_.label(*middle, "l' (directional)", Role::light, 10);
      }
    }
  }

  const Analysis& analysis_;
  Viewpoint view_;
  Sketch sketch_;
  WorldToCube step_;
  glm::dvec4 light_;
};

}  // namespace

ViewPicture describe_cube(const Analysis& analysis, glm::ivec2 size) { return CubeView(analysis, aspect_of(size)).picture(); }

}  // namespace psm
