// SPDX-License-Identifier: GPL-3.0-or-later
// What the views build their lists with: lines that may run through infinity, bodies under a projective map, symbols of a
// constant size on the picture.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "draw/split_at_infinity.h"
#include "draw/view.h"
#include "geom/convex_body.h"

namespace psm {

struct Pen {
  Role role = Role::neutral;
  double width = 1.5;
  LineStyle style = LineStyle::solid;
  double opacity = 1.0;
};

enum class Head { none, arrow };
enum class Sides { both, front };  // of w = 0

/// Nothing is drawn outside `outer`; between `inner` and `outer` it fades.
struct Limits {
  Box inner, outer;
  double fade(const glm::dvec3& p) const;
};

inline glm::dvec4 at(const glm::dvec3& p) { return {p, 1.0}; }

class Sketch {
 public:
  explicit Sketch(const Limits& limits) : limits_(limits) {}

  DrawList list;

  const Limits& limits() const { return limits_; }

  /// A finite segment, as it is.
  void line(const glm::dvec3& a, const glm::dvec3& b, const Pen& pen, Head head = Head::none);

  /// A finite segment, fading between the limits.
  void piece(const Piece& p, const Pen& pen, Head head = Head::none);

  /// The segment of homogeneous points, torn where w = 0.
  void line_through(const glm::dvec4& a, const glm::dvec4& b, const Pen& pen);

  /// Its part with w > 0 only.
  void line_in_front(const glm::dvec4& a, const glm::dvec4& b, const Pen& pen);

  /// A convex polygon.
  void fill(const std::vector<glm::dvec4>& corners, Role role, double alpha, Sides sides = Sides::both);

  /// A body's facets and edges after a projective map of its space.
  void body(const ConvexBody& body, const glm::dmat4& map, double alpha, const Pen& edges);

  void point(const glm::dvec3& p, Role role, double radius = 5.0) { list.points.push_back({at(p), role, radius}); }
  void label(const glm::dvec3& anchor, std::string text, Role role, int priority);

  /// Another drawing of the same space, within limits of its own.
  void append(DrawList other) { psm::append(list, std::move(other)); }

 private:
  void faded_line(const glm::dvec3& a, const glm::dvec3& b, const Pen& pen, Head head);

  Limits limits_;
};

/// The edges of a convex body, each once, as pairs of vertex indices.
std::vector<std::array<int, 2>> body_edges(const ConvexBody& body);

/// Corner pairs of a box or frustum whose corners run (-,-) (+,-) (+,+) (-,+), near then far: four near, four far, four sides.
const std::array<std::array<int, 2>, 12>& box_edges();
/// The corners of [-1, 1]^3 in that order.
std::array<glm::dvec3, 8> cube_corners();

/// The views, each in its own file.
ViewPicture describe_world(const Analysis& analysis, glm::ivec2 size);
ViewPicture describe_cube(const Analysis& analysis, glm::ivec2 size);
ViewPicture describe_map(const Analysis& analysis, glm::ivec2 size);
ViewPicture describe_eye(const Analysis& analysis, glm::ivec2 size);
ViewPicture describe_body(const Analysis& analysis, glm::ivec2 size);
ViewPicture describe_curves(const Analysis& analysis, const glm::dvec2& page);  // in pixels at scale 1
ViewPicture describe_explorer(const Analysis& analysis, const glm::dvec2& page);

/// The map view's picture with the lit scene instead of the depths: what the light sees, in the map's projection. As it was where
/// there is no single map.
void show_scene_in_map(ViewPicture& map, const Analysis& analysis);

/// For a view's title: why it is not the map that was asked for, such as ", uniform, not glpr"; "" where it is.
std::string map_remark(const Analysis& analysis);

/// Where a layer's map, [-1, 1]^2, stands on the map view's sheet: alone, beside a second one, or among six.
glm::dmat4 sheet_from_map(const Analysis& analysis, int layer);

/// Width over height, 1 for a picture without area.
double aspect_of(glm::ivec2 size);

/// How a perspective view sees points of its space: for symbols, and for labels that must stay on the picture.
struct Viewpoint {
  glm::dmat4 clip_from_space{1.0};
  glm::dvec3 eye{0.0}, right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};
  double tan_half = 1.0;

  explicit Viewpoint(const OrbitCamera& camera);

  /// The length at p that spans this fraction of the picture's height.
  double length_of(double fraction, const glm::dvec3& p) const;
  bool sees(const glm::dvec3& p, double margin = 1.0) const;
  /// The one of the visible points that lies furthest in this direction on the picture (x to the right, y up); the first if none
  /// is visible.
  glm::dvec3 furthest(const std::vector<glm::dvec3>& points, const glm::dvec2& direction) const;
  /// The visible part of a segment, a little inside the picture's border, and its middle; none if all of it is outside.
  std::optional<Piece> visible_part(const glm::dvec3& a, const glm::dvec3& b) const;
  std::optional<glm::dvec3> visible_middle(const glm::dvec3& a, const glm::dvec3& b) const;
};

/// A disc with rays around it, facing the viewer.
void draw_lamp(Sketch& sketch, const Viewpoint& view, const glm::dvec3& p, int rays);

/// Up to `count` points, well apart, where light rays leave the body: where drawn rays end. The first ray is the centroid's.
std::vector<glm::dvec3> ray_targets(const ConvexBody& body, const glm::dvec4& light, int count);

/// "%.*g", without a locale's comma, and whole below ten million: 14010, not 1.401e+04.
std::string short_number(double value, int digits = 3);

}  // namespace psm
