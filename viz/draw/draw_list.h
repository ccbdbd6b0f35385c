// SPDX-License-Identifier: GPL-3.0-or-later
// DrawList: lines, fills and labels as plain data, each with a role instead of a colour. A test reads it; the screen and the
// figure writers draw it.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace psm {

/// What a thing is. One palette maps roles to colours, the same in all views, plots and exports.
enum class Role {
  frustum,          // the camera and its frustum
  light,            // the light and its rays
  caster_body,      // H
  receivers_body,   // R
  vanishing_plane,  // the vanishing plane and the warp frustum
  map_window,       // the shadow map's window as a body
  infinity,         // the infinity plane and w = 0
  texel_grid,
  scene_bounds,    // S
  light_point,     // lights in front of the camera plane
  light_inverted,  // lights behind it
  curve_uniform,   // the techniques in plots; the family has the hue
  curve_lispsm,
  curve_lispsm_reference,
  curve_glpr,
  curve_gmnpr,
  curve_gmnpr_eq4,
  curve_minimax,
  curve_minimax_frustum,
  neutral,  // axes, cube, grid
  text
};

enum class LineStyle { solid, dashed };

/// A segment; `a` and `b` are homogeneous points of the list's space with w > 0, after all splitting at infinity.
/// Parts hidden by the scene are drawn thinner and dashed, at 60 %.
struct DrawLine {
  glm::dvec4 a, b;
  Role role = Role::neutral;
  double width = 1.5;  // pixels at scale 1
  LineStyle style = LineStyle::solid;
  bool arrow = false;                 // a head at b
  double fade_a = 1.0, fade_b = 1.0;  // opacity at the ends
};

/// A convex polygon, translucent; the winding is counter-clockwise seen from outside where it bounds a body.
struct DrawFill {
  std::vector<glm::dvec4> corners;  // homogeneous, w > 0
  Role role = Role::neutral;
  double alpha = 0.16;
  bool covers = false;  // hides what is behind it: its colour is mixed with the picture's ground
};

struct DrawPoint {
  glm::dvec4 position;
  Role role = Role::neutral;
  double radius = 5.0;  // pixels at scale 1
};

struct DrawLabel {
  glm::dvec4 anchor;  // what it names
  std::string text;
  Role role = Role::text;
  int priority = 0;  // higher is placed first
};

/// Text that stands where it is put, for plots; labels find a place by themselves.
struct DrawText {
  glm::dvec4 position;
  std::string text;
  Role role = Role::text;
  glm::dvec2 pivot{0.0};  // which point of its box stands there: 0, 0 the upper left one, 1, 1 the lower right one
};

struct DrawList {
  std::vector<DrawLine> lines = {};
  std::vector<DrawFill> fills = {};
  std::vector<DrawPoint> points = {};
  std::vector<DrawLabel> labels = {};
  std::vector<DrawText> texts = {};
};

/// Another drawing of the same space over this one.
void append(DrawList& list, DrawList other);

/// Takes out everything of these roles.
void remove(DrawList& list, const std::vector<Role>& roles);

/// "caster_body" and so on; nothing for other names.
const char* name_of(Role role);
std::optional<Role> role_from_name(const std::string& name);

/// sRGB, 0 to 1. `role_color` is for fills and points; lines and text need more contrast on white: darker variants of the same
/// hue, at least 3:1 for lines and 4.5:1 for text (the palette's orange, sky blue and yellow have 2.3, 2.3 and 1.3).
glm::vec3 role_color(Role role);
glm::vec3 role_line_color(Role role);
glm::vec3 role_text_color(Role role);

/// A label's place on the picture: pixels, y downwards. `top_left`, `size`: the text's box, as measured; label_margin * scale
/// around it stays free of other labels and of the picture's border, for a plate.
constexpr double label_margin = 4.0;
struct PlacedLabel {
  glm::dvec2 top_left, size;
  glm::dvec2 anchor;  // where the leader ends
  std::string text;
  Role role = Role::text;
  bool leader = false;
};

/// A part of the picture that labels must leave free, such as a title: pixels, y downwards.
struct Occupied {
  glm::dvec2 top_left, size;
  bool operator==(const Occupied&) const = default;
};

/// Greedy placement, most constrained first: eight positions around each anchor, no overlap, nothing cut, at most 12.
/// `text_size` measures a text in pixels; `clip_from_list` maps the list's space to the picture's clip space. `columns`: only
/// these of the picture show, from and to, as fractions of its width.
std::vector<PlacedLabel> place_labels(const DrawList& list, const glm::dmat4& clip_from_list, glm::dvec2 picture_size,
                                      double scale, glm::dvec2 (*text_size)(const std::string&, double scale, void*),
                                      void* context, const std::vector<Occupied>& occupied = {},
                                      const glm::dvec2& columns = {0.0, 1.0});

}  // namespace psm
