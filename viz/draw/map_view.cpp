// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow map as an image, with what the eye sees of it.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "draw/sketch.h"

namespace psm {
namespace {

constexpr double fit = 0.86;  // the whole map and a margin for what lies just outside

double cross(const glm::dvec2& o, const glm::dvec2& p, const glm::dvec2& q) {
  return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

/// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  std::vector<glm::dvec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const glm::dvec2& p : points) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Pan and zoom of a drawing of this half size, fitted into the picture; squares stay square.
glm::dmat4 clip_from_plane(const ViewSettings& view, const glm::dvec2& half, double picture_aspect) {
  const double fitted = fit * view.map_zoom * std::min(picture_aspect / half.x, 1.0 / half.y);
  const glm::dvec3 scale(fitted / picture_aspect, fitted, 1.0);
  return glm::translate(glm::scale(glm::dmat4(1.0), scale), glm::dvec3(-view.map_center, 0.0));
}

class MapView {
 public:
  /// `reach`: how far outlines go, in half windows.
  MapView(const Analysis& analysis, const glm::dmat4& clip_from_list, double reach)
      : analysis_(analysis), clip_from_list_(clip_from_list), sketch_(limits(reach)) {
    // Depth plays no part: the picture is seen along it.
    plane_from_world_ = *analysis.map_from_world;
    for (int i = 0; i < 4; ++i) plane_from_world_[i].z = 0.0;
  }

  DrawList draw() {
    grid();
    receivers();
    frustum();
    eye();
    return std::move(sketch_.list);
  }

 private:
  static Limits limits(double reach) {
    const Box box{{-reach, -reach, -1.0}, {reach, reach, 1.0}};
    return {box, box};
  }

  void grid() {
    constexpr int cells = 8;
    for (int i = 0; i <= cells; ++i) {
      const double t = 2.0 * i / cells - 1.0;
      const bool border = i == 0 || i == cells;
      const Pen pen = border ? Pen{Role::map_window, 2.5} : Pen{Role::texel_grid, 1.0, LineStyle::solid, 0.45};
      sketch_.line({t, -1.0, 0.0}, {t, 1.0, 0.0}, pen);
      sketch_.line({-1.0, t, 0.0}, {1.0, t, 0.0}, pen);
    }
    const std::string n = std::to_string(analysis_.experiment.shadow.resolution);
    sketch_.label({-1.0, -1.0, 0.0}, "0", Role::texel_grid, 3);
    sketch_.label({1.0, -1.0, 0.0}, n + " texels", Role::texel_grid, 3);
  }

  void receivers() {
    std::vector<glm::dvec2> points;
    for (const glm::dvec3& v : analysis_.receivers_body.vertices) {
      const glm::dvec4 q = plane_from_world_ * at(v);
      if (q.w > 0.0) points.push_back(glm::dvec2(q) / q.w);
    }
    if (points.size() < 3) return;
    const std::vector<glm::dvec2> hull = hull_of(std::move(points));
    for (std::size_t i = 0; i < hull.size(); ++i) {
      sketch_.line({hull[i], 0.0}, {hull[(i + 1) % hull.size()], 0.0}, {Role::receivers_body, 2.5});
    }
    if (!hull.empty()) sketch_.label({0.5 * (hull[0] + hull[1 % hull.size()]), 0.0}, "R", Role::receivers_body, 8);
  }

  void frustum() {
    std::array<glm::dvec4, 8> corners;
    for (int i = 0; i < 8; ++i) corners[i] = plane_from_world_ * analysis_.frustum_corners[i];
    const auto& edges = box_edges();
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto [i, j] = edges[k];
      sketch_.line_in_front(corners[i], corners[j],
                            {Role::frustum, k < 4 ? 2.5 : 1.75, k < 4 ? LineStyle::solid : LineStyle::dashed});
    }
    edge_label(corners, 0, "near", 6);
    edge_label(corners, 4, "far", 6);
    edge_label(corners, 8, "V", 8);
  }

  /// At the longest visible part of four edges.
  void edge_label(const std::array<glm::dvec4, 8>& corners, int first, const char* text, int priority) {
    const Box shown{{-0.94, -0.94, -1.0}, {0.94, 0.94, 1.0}};
    std::optional<Piece> longest;
    for (int k = first; k < first + 4; ++k) {
      const auto [i, j] = box_edges()[k];
      const auto piece = clip_segment(clip_from_list_ * corners[i], clip_from_list_ * corners[j], shown);
      if (piece && (!longest || glm::distance(piece->a, piece->b) > glm::distance(longest->a, longest->b))) longest = piece;
    }
    if (!longest) return;
    const glm::dvec4 anchor = glm::inverse(clip_from_list_) * at(0.5 * (longest->a + longest->b));
    sketch_.label(glm::dvec3(anchor) / anchor.w, text, Role::frustum, priority);
  }

  /// The eye's image, in which the frustum's sides meet.
  void eye() {
    const glm::dvec4 q = plane_from_world_ * at(analysis_.experiment.camera.position);
    const glm::dvec2 p = glm::dvec2(q) / q.w;
    const double reach = sketch_.limits().outer.max.x;
    if (!(q.w > 0.0) || !(std::abs(p.x) <= reach && std::abs(p.y) <= reach)) return;
    sketch_.point({p, 0.0}, Role::frustum);
    sketch_.label({p, 0.0}, "eye", Role::frustum, 7);
  }

  const Analysis& analysis_;
  glm::dmat4 clip_from_list_, plane_from_world_{1.0};
  Sketch sketch_;
};

/// The two maps of psm_two_maps, side by side. They share u and v, so that the same outlines stand in both.
DrawList two_maps(const Analysis& analysis) {
  static constexpr const char* captions[] = {"w > 0: in front of the eye", "w < 0: behind the eye"};
  const Box everywhere{glm::dvec3(-1.0), glm::dvec3(1.0)};
  Sketch sketch({everywhere, everywhere});
  for (int i = 0; i < 2; ++i) {
    const glm::dmat4 sheet = sheet_from_map(analysis, i);
    DrawList map = MapView(analysis, glm::dmat4(1.0), 1.0 + 1e-9).draw();
    for (DrawLine& line : map.lines) line.a = sheet * line.a, line.b = sheet * line.b;
    for (DrawPoint& point : map.points) point.position = sheet * point.position;
    for (DrawLabel& label : map.labels) label.anchor = sheet * label.anchor;
    if (i > 0) map.labels.clear();
    sketch.append(std::move(map));
    sketch.label({i - 0.5, 0.44, 0.0}, captions[i], Role::infinity, 12);
  }
  return std::move(sketch.list);
}

/// The contact sheet of six maps: +x -x +y above -y +z -z, squares with sides of 2/3.
DrawList six_maps() {
  static constexpr const char* names[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  const Box everywhere{glm::dvec3(-1.0), glm::dvec3(1.0)};
  Sketch sketch({everywhere, everywhere});
  const Pen pen{Role::map_window, 2.5};
  constexpr double side = 2.0 / 3.0;
  for (int i = 0; i <= 3; ++i) sketch.line({i * side - 1.0, -side, 0.0}, {i * side - 1.0, side, 0.0}, pen);
  for (double y : {-side, 0.0, side}) sketch.line({-1.0, y, 0.0}, {1.0, y, 0.0}, pen);
  for (int face = 0; face < 6; ++face) {
    // Well inside its square, so that the label cannot stand in a neighbour.
    sketch.label({(face % 3 + 0.5) * side - 1.0, (face < 3 ? 0.0 : -side) + 0.3 * side, 0.0}, names[face], Role::map_window, 5);
  }
  return std::move(sketch.list);
}

}  // namespace

glm::dmat4 sheet_from_map(const Analysis& analysis, int layer) {
  const auto tile = [](double x, double y, double scale) {
    return glm::scale(glm::translate(glm::dmat4(1.0), {x, y, 0.0}), glm::dvec3(scale, scale, 1.0));
  };
  if (analysis.map_from_world && analysis.map_beyond_from_world) return tile(layer - 0.5, 0.0, 0.5);
  if (analysis.map_from_world || !analysis.cube_maps_from_world) return glm::dmat4(1.0);
  constexpr double half = 1.0 / 3.0;
  return tile((2 * (layer % 3) + 1) * half - 1.0, layer < 3 ? half : -half, half);
}

ViewPicture describe_map(const Analysis& analysis, glm::ivec2 size) {
  constexpr double reach = 100.0;  // how far outlines go on outside
  const std::string n = std::to_string(analysis.experiment.shadow.resolution), size_text = n + " x " + n;
  const ViewSettings& view = analysis.experiment.view;
  ViewPicture picture;
  picture.id = ViewId::map;
  picture.scene = ScenePicture::map_depth;
  if (analysis.receivers_body.empty()) {
    picture.title = "No shadow map: nothing is visible";
    picture.clip_from_list = clip_from_plane(view, {1.0, 1.0}, aspect_of(size));
  } else if (analysis.cube_maps_from_world) {
    picture.title = "Six maps of 90°";
    picture.clip_from_list = clip_from_plane(view, {1.0, 2.0 / 3.0}, aspect_of(size));
    picture.list = six_maps();
  } else if (analysis.map_beyond_from_world) {
    picture.title = "Two maps " + size_text;
    picture.clip_from_list = clip_from_plane(view, {1.0, 0.5}, aspect_of(size));
    picture.list = two_maps(analysis);
  } else {
    picture.title = "Shadow map " + size_text;
    picture.clip_from_list = clip_from_plane(view, {1.0, 1.0}, aspect_of(size));
    if (analysis.map_from_world) picture.list = MapView(analysis, picture.clip_from_list, reach).draw();
  }
  picture.title += map_remark(analysis);
  return picture;
}

}  // namespace psm
