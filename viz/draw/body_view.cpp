// SPDX-License-Identifier: GPL-3.0-or-later
// The body H of all that can cast a shadow into the picture, by itself: its facets and corners, and what it is cut from.
#include <algorithm>
#include <cmath>

#include "draw/sketch.h"
#include "math/projective.h"
#include "scene/eye_and_light.h"

namespace psm {
namespace {

Box box_of_view(const Analysis& analysis) {
  Box box;
  view_extent(ViewId::body, analysis, box.min, box.max);
  return box;
}

/// H and some room around it: what reaches farther fades.
Limits around(const Box& extent) {
  const double radius = glm::length(extent.half());
  const glm::dvec3 half = glm::max(extent.half(), glm::dvec3(0.25 * radius));
  const Box roomy{extent.center() - half, extent.center() + half};
  return {roomy.scaled(1.3), roomy.scaled(2.0)};
}

std::string numbers_of(const char* name, const ConvexBody& body) {
  if (body.empty()) return std::string(name) + ": empty";
  return std::string(name) + ": " + std::to_string(body.vertices.size()) + " corners, " + std::to_string(body.facets.size()) +
         " facets, volume " + short_number(body.volume(), 4);
}

class BodyView {
 public:
  BodyView(const Analysis& analysis, double aspect)
      : analysis_(analysis),
        camera_(view_camera(ViewId::body, analysis, aspect)),
        view_(camera_),
        extent_(box_of_view(analysis)),
        sketch_(around(extent_)) {}

  ViewPicture picture() {
    cut_from();
    bodies();
    light();
    ViewPicture picture;
    picture.id = ViewId::body;
    picture.title = analysis_.caster_body.empty() ? "Body H: nothing can cast a shadow" : "Body H";
    picture.scene = ScenePicture::none;
    picture.clip_from_world = picture.clip_from_list = view_.clip_from_space;
    picture.list = std::move(sketch_.list);
    picture.legend.title = "H = hull(V, light) ∩ S ∩ L    R = V ∩ S ∩ L";
    picture.legend.lines = {numbers_of("H", analysis_.caster_body), numbers_of("R", analysis_.receivers_body)};
    return picture;
  }

 private:
  /// V, S and a spot's L: outlines.
  void cut_from() {
    const auto& corners = analysis_.frustum_corners;
    outline(corners, "V", {Role::frustum, 2.0});
    const ConvexBody& s = analysis_.scene_body;
    for (const auto& [i, j] : body_edges(s))
      sketch_.line_in_front(at(s.vertices[i]), at(s.vertices[j]), {Role::scene_bounds, 1.25, LineStyle::dashed});
    std::vector<std::array<glm::dvec4, 2>> edges;
    for (const auto& [i, j] : body_edges(s)) edges.push_back({at(s.vertices[i]), at(s.vertices[j])});
    name(edges, "S", Role::scene_bounds, {0.4, 1.0});
    if (analysis_.experiment.light.type == LightType::spot) spot_pyramid();
  }

  void spot_pyramid() {
    const LightSettings& light = analysis_.experiment.light;
    const ViewFrame spot = spot_frame(light);
    // As directions, so that the edges run on to where the picture ends.
    std::vector<std::array<glm::dvec4, 2>> edges;
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
      edges.push_back({at(light.position), glm::dvec4(spot.at(x, y, 1.0) - light.position, 0.0)});
      sketch_.line_in_front(edges.back()[0], edges.back()[1], {Role::light, 1.5, LineStyle::dashed});
    }
    name(edges, "L", Role::light, {0.6, 0.6});
  }

  void outline(const std::array<glm::dvec4, 8>& corners, const char* text, const Pen& pen) {
    std::vector<std::array<glm::dvec4, 2>> edges;
    for (const auto& [i, j] : box_edges()) {
      sketch_.line_in_front(corners[i], corners[j], pen);
      edges.push_back({corners[i], corners[j]});
    }
    name(edges, text, pen.role, {1.0, -0.3});
  }

  /// At the middle of the part of an edge that shows, the one furthest in this direction.
  void name(const std::vector<std::array<glm::dvec4, 2>>& edges, const char* text, Role role, const glm::dvec2& direction) {
    std::vector<glm::dvec3> shown;
    for (const auto& [a, b] : edges) {
      const auto piece = clip_segment(a, b, sketch_.limits().inner);
      const auto middle = piece ? view_.visible_middle(piece->a, piece->b) : std::nullopt;
      if (middle) shown.push_back(*middle);
    }
    if (!shown.empty()) sketch_.label(view_.furthest(shown, direction), text, role, 6);
  }

  void bodies() {
    const ConvexBody &h = analysis_.caster_body, &r = analysis_.receivers_body;
    if (!h.empty()) {
      sketch_.body(h, glm::dmat4(1.0), 0.16, {Role::caster_body, 2.5});
      for (const glm::dvec3& v : h.vertices) sketch_.point(v, Role::caster_body, 3.5);
      sketch_.label(view_.furthest(h.vertices, {-0.6, 1.0}), "H", Role::caster_body, 9);
    }
    if (r.empty()) return;
    sketch_.body(r, glm::dmat4(1.0), 0.14, {Role::receivers_body, 1.75});
    sketch_.label(view_.furthest(r.vertices, {0.2, -1.0}), "R", Role::receivers_body, 8);
  }

  /// The light where it is in sight; else a ray from its side.
  void light() {
    const glm::dvec4 l = analysis_.light;
    if (l.w != 0.0 && sketch_.limits().inner.contains(glm::dvec3(l) / l.w)) {
      draw_lamp(sketch_, view_, glm::dvec3(l) / l.w, 8);
      sketch_.label(glm::dvec3(l) / l.w, "light", Role::light, 10);
      return;
    }
    const ConvexBody& lit = analysis_.caster_body.empty() ? analysis_.scene_body : analysis_.caster_body;
    for (const glm::dvec3& target : ray_targets(lit, l, 1)) {
      const glm::dvec3 to_light = safe_normalize(glm::dvec3(l) - l.w * target);
      const double length = 0.5 * glm::length(extent_.half());
      const auto shown = view_.visible_part(target, target + length * to_light);
      if (!shown) continue;
      sketch_.line(shown->b, shown->a, {Role::light, 2.0}, Head::arrow);
      sketch_.label(shown->b, "from the light", Role::light, 7);
    }
  }

  const Analysis& analysis_;
  OrbitCamera camera_;
  Viewpoint view_;
  Box extent_;
  Sketch sketch_;
};

}  // namespace

ViewPicture describe_body(const Analysis& analysis, glm::ivec2 size) { return BodyView(analysis, aspect_of(size)).picture(); }

}  // namespace psm
