// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/overlay_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/theme.h"

namespace psm::gl {
namespace {

glm::vec3 device_position(glm::dvec2 pixels, double depth, const PictureFrame& frame) {
  return glm::vec3(glm::dvec3(pixels / frame.size * 2.0 - 1.0, depth));
}

/// A stretch of line as the shader draws it, in pixels.
struct Quad {
  glm::dvec2 a, b;
  double depth_a = -1.0, depth_b = -1.0;
  glm::vec4 color{1.0f};  // opacity at a
  double opacity_b = 1.0, width = 1.0, dash = 0.0;
  bool taper = false;  // an arrow head; its width is half its base

  double half_width() const { return taper ? width : 0.5 * std::max(width, 1.0); }
};

template <class Vertex>
void append_quad(std::vector<Vertex>& to, const std::array<Vertex, 4>& corners) {
  for (const int i : {0, 1, 2, 0, 2, 3}) to.push_back(corners[std::size_t(i)]);
}

void append_segment(std::vector<LineVertex>& to, const Quad& s, const PictureFrame& frame) {
  const double length = glm::length(s.b - s.a);
  const glm::dvec2 along = length > 0.0 ? (s.b - s.a) / length : glm::dvec2(1.0, 0.0);
  const glm::dvec2 across(-along.y, along.x);
  // Dashes count from a place that does not depend on where the line was clipped, so that pieces of one line dash as one.
  const glm::dvec2 upright = along.x < 0.0 || (along.x == 0.0 && along.y < 0.0) ? -along : along;
  const double reach = s.half_width() + 0.5;  // the feather
  const double depth_step = length > 0.0 ? (s.depth_b - s.depth_a) / length : 0.0;
  const auto corner = [&](bool at_b, double sideways) {
    const double t = at_b ? length + reach : -reach, aside = sideways * reach;
    const glm::dvec2 pixel = s.a + t * along + aside * across;
    const double depth = std::clamp(s.depth_a + depth_step * t, -1.0, 1.0);
    return LineVertex{device_position(pixel, depth, frame), glm::vec4(t, aside, glm::dot(pixel, upright), length), s.color,
                      glm::vec4(float(s.width), float(s.opacity_b), float(s.dash), s.taper ? 1.0f : 0.0f)};
  };
  append_quad<LineVertex>(to, {corner(false, -1.0), corner(true, -1.0), corner(true, 1.0), corner(false, 1.0)});
}

/// The head of an arrow that ends at quad.b, and the quad shortened to its base.
void append_arrow_head(std::vector<LineVertex>& to, Quad& quad, const PictureFrame& frame) {
  const double length = glm::length(quad.b - quad.a);
  if (!(length > 0.0)) return;
  const ArrowHead wanted = arrow_head(2.0 * quad.half_width(), frame.scale);
  const double head = std::min(wanted.length, length);
  const double t = 1.0 - head / length;
  Quad tip = quad;
  tip.a = glm::mix(quad.a, quad.b, t);
  tip.depth_a = glm::mix(quad.depth_a, quad.depth_b, t);
  tip.color.a = float(quad.opacity_b);
  tip.width = wanted.half_width * head / wanted.length;
  tip.dash = 0.0;
  tip.taper = true;
  append_segment(to, tip, frame);
  const double overlap = std::min(1.0, 0.5 * head);  // no seam between the line and its head
  quad.b = glm::mix(quad.a, quad.b, 1.0 - (head - overlap) / length);
}

void append_line(std::vector<LineVertex>& to, const DrawLine& line, const glm::dmat4& clip_from_list, const PictureFrame& frame) {
  const auto stroke = stroke_of(line, clip_from_list, frame, Seen::in_front);
  if (!stroke) return;
  Quad quad{stroke->a, stroke->b, stroke->depth_a, stroke->depth_b};
  quad.color = glm::vec4(picture_line_color(line.role, frame.theme), float(stroke->opacity_a));
  quad.opacity_b = stroke->opacity_b;
  quad.width = stroke->width;
  if (stroke->dashed) quad.dash = dash_of(Seen::in_front).period() * frame.scale;
  if (stroke->arrow) append_arrow_head(to, quad, frame);
  append_segment(to, quad, frame);
}

ShapeVertex shape_corner(const ShapeVertex& flat, glm::dvec2 pixels, double depth, const PictureFrame& frame) {
  ShapeVertex vertex = flat;
  vertex.position = device_position(pixels, depth, frame);
  return vertex;
}

void append_shape(std::vector<ShapeVertex>& to, const ShapeVertex& flat, double depth, const PictureFrame& frame) {
  const glm::dvec2 centre(flat.box.x, flat.box.y), reach = glm::dvec2(flat.box.z, flat.box.w) + 0.5;
  append_quad<ShapeVertex>(to, {shape_corner(flat, centre - reach, depth, frame),
                                shape_corner(flat, centre + glm::dvec2(reach.x, -reach.y), depth, frame),
                                shape_corner(flat, centre + reach, depth, frame),
                                shape_corner(flat, centre + glm::dvec2(-reach.x, reach.y), depth, frame)});
}

}  // namespace

std::vector<LineVertex> line_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame) {
  std::vector<LineVertex> vertices;
  for (const DrawLine& line : list.lines) append_line(vertices, line, clip_from_list, frame);
  return vertices;
}

std::vector<LineVertex> mark_vertices(std::span<const Mark> marks, const PictureFrame& frame) {
  std::vector<LineVertex> vertices;
  for (const Mark& mark : marks) {
    Quad quad{{mark.a.x, frame.size.y - mark.a.y}, {mark.b.x, frame.size.y - mark.b.y}};
    quad.color = mark.color;
    quad.opacity_b = mark.color.a;
    quad.width = mark.width;
    append_segment(vertices, quad, frame);
  }
  return vertices;
}

std::vector<ShapeVertex> point_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame) {
  std::vector<ShapeVertex> vertices;
  for (const DrawPoint& point : list.points) {
    const glm::dvec4 clip = clip_from_list * point.position;
    if (!finite(clip) || !(clip.w > 0.0) || std::abs(clip.x) > 2.0 * clip.w || std::abs(clip.y) > 2.0 * clip.w) continue;
    if (std::abs(clip.z) > (1.0 + kPull) * clip.w) continue;
    ShapeVertex flat;
    const double radius = point.radius * frame.scale;
    flat.box = glm::vec4(pixels_of(clip, frame), radius, radius);
    flat.fill = glm::vec4(role_color(point.role), 1.0f);
    flat.outline = glm::vec4(glm::vec3(frame.theme == Theme::light ? 0.1f : 0.95f), 0.85f);
    flat.shape = glm::vec2(radius, 1.25 * frame.scale);
    append_shape(vertices, flat, pulled_depth(clip), frame);
  }
  return vertices;
}

std::vector<ShapeVertex> plate_vertices(std::span<const Plate> plates, const PictureFrame& frame) {
  std::vector<ShapeVertex> vertices;
  for (const Plate& plate : plates) {
    const glm::dvec2 half = 0.5 * plate.size, centre = plate.top_left + half;
    ShapeVertex flat;
    flat.box = glm::vec4(centre.x, frame.size.y - centre.y, half);
    flat.fill = plate.fill;
    flat.outline = plate.rim;
    flat.shape = glm::vec2(plate.radius, frame.scale);
    append_shape(vertices, flat, -1.0, frame);
  }
  return vertices;
}

std::vector<FillVertex> fill_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame) {
  std::vector<FillVertex> vertices;
  std::vector<glm::vec4> corners;
  for (const DrawFill& fill : list.fills) {
    corners.clear();
    for (const glm::dvec4& p : fill.corners) {
      const glm::dvec4 clip = clip_from_list * p;
      const double largest = std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z), std::abs(clip.w)});
      if (!finite(clip) || largest == 0.0) break;
      corners.emplace_back(glm::dvec4(clip.x, clip.y, clip.z - kPull * clip.w, clip.w) / largest);
    }
    if (corners.size() != fill.corners.size()) continue;
    const glm::vec4 color = picture_fill(fill, frame.theme);
    for (std::size_t i = 2; i < corners.size(); ++i) {
      for (const glm::vec4& corner : {corners[0], corners[i - 1], corners[i]}) vertices.push_back({corner, color});
    }
  }
  return vertices;
}

}  // namespace psm::gl
