// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/overlay_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "gl/theme.h"

namespace psm::gl {
namespace {

constexpr double kDash = 6.0, kGap = 4.0;  // pixels at scale 1
constexpr double kHiddenDash = 5.0, kHiddenGap = 4.0;
constexpr double kHiddenWidth = 0.7, kHiddenOpacity = 0.6;
constexpr double kPull = 2e-5;                              // towards the eye, of normalised depth: 1e-5 of its range
constexpr double kMargin = 64.0;                            // pixels beyond the picture where lines end
constexpr double kArrowLength = 8.0, kArrowPerWidth = 2.5;  // pixels at scale 1; and per pixel of width
constexpr double kArrowSlope = 0.38;                        // half width over length

/// A clipped segment: what is left of a + t (b - a).
struct Piece {
  glm::dvec4 a, b;
  double t_a = 0.0, t_b = 1.0;
};

/// Keeps g(t) = g_a + t (g_b - g_a) >= 0.
bool clip_to(Piece& piece, double g_a, double g_b) {
  if (!(g_a >= 0.0) && !(g_b >= 0.0)) return false;
  const double t = g_a / (g_a - g_b);
  if (g_a < 0.0) piece.t_a = std::max(piece.t_a, t);
  if (g_b < 0.0) piece.t_b = std::min(piece.t_b, t);
  return piece.t_a < piece.t_b;
}

bool finite(const glm::dvec4& p) { return std::isfinite(p.x + p.y + p.z + p.w); }

/// Homogeneous clipping to the picture, a margin around it, and the depth range: what is left has w > 0 and modest coordinates.
std::optional<Piece> clipped(const glm::dvec4& a, const glm::dvec4& b, const PictureFrame& frame) {
  if (!finite(a) || !finite(b)) return std::nullopt;
  Piece piece{a, b};
  const glm::dvec2 reach = 1.0 + 2.0 * kMargin * frame.scale / frame.size;
  const double least_w = 1e-9 * std::max(std::abs(a.w), std::abs(b.w));
  if (!clip_to(piece, a.w - least_w, b.w - least_w)) return std::nullopt;
  for (int axis = 0; axis < 2; ++axis) {
    if (!clip_to(piece, reach[axis] * a.w - a[axis], reach[axis] * b.w - b[axis])) return std::nullopt;
    if (!clip_to(piece, reach[axis] * a.w + a[axis], reach[axis] * b.w + b[axis])) return std::nullopt;
  }
  const double depth_reach = 1.0 + kPull;
  if (!clip_to(piece, depth_reach * a.w - a.z, depth_reach * b.w - b.z)) return std::nullopt;
  if (!clip_to(piece, a.w + a.z, b.w + b.z)) return std::nullopt;
  piece.a = glm::mix(a, b, piece.t_a);
  piece.b = glm::mix(a, b, piece.t_b);
  if (!(piece.a.w > 0.0 && piece.b.w > 0.0)) return std::nullopt;
  return piece;
}

glm::dvec2 pixels_of(const glm::dvec4& clip, const PictureFrame& frame) {
  return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * frame.size;
}

double pulled_depth(const glm::dvec4& clip) { return std::clamp(clip.z / clip.w - kPull, -1.0, 1.0); }

glm::vec3 device_position(glm::dvec2 pixels, double depth, const PictureFrame& frame) {
  return glm::vec3(glm::dvec3(pixels / frame.size * 2.0 - 1.0, depth));
}

/// How a stretch of line is drawn, in pixels.
struct Stroke {
  glm::dvec2 a, b;
  double depth_a = -1.0, depth_b = -1.0;
  glm::vec4 color{1.0f};  // opacity at a
  double opacity_b = 1.0, half_width = 0.5, dash = 0.0, taper = 0.0;
};

template <class Vertex>
void append_quad(std::vector<Vertex>& to, const std::array<Vertex, 4>& corners) {
  for (const int i : {0, 1, 2, 0, 2, 3}) to.push_back(corners[std::size_t(i)]);
}

void append_stroke(std::vector<LineVertex>& to, const Stroke& s, const PictureFrame& frame) {
  const double length = glm::length(s.b - s.a);
  const glm::dvec2 along = length > 0.0 ? (s.b - s.a) / length : glm::dvec2(1.0, 0.0);
  const glm::dvec2 across(-along.y, along.x);
  const double reach = s.half_width + 1.5;  // the feather and a pixel for multisampling
  const double depth_step = length > 0.0 ? (s.depth_b - s.depth_a) / length : 0.0;
  const auto corner = [&](glm::dvec2 end, double depth, double forwards, double sideways) {
    const double extended = std::clamp(depth + depth_step * forwards * reach, -1.0, 1.0);
    return LineVertex{device_position(end + reach * (forwards * along + sideways * across), extended, frame), glm::vec4(s.a, s.b),
                      s.color, glm::vec4(float(s.half_width), float(s.opacity_b), float(s.dash), float(s.taper))};
  };
  append_quad<LineVertex>(to, {corner(s.a, s.depth_a, -1, -1), corner(s.b, s.depth_b, 1, -1), corner(s.b, s.depth_b, 1, 1),
                               corner(s.a, s.depth_a, -1, 1)});
}

/// The head of an arrow that ends at stroke.b, and the stroke shortened to its base.
void append_arrow_head(std::vector<LineVertex>& to, Stroke& stroke, const PictureFrame& frame) {
  const double length = glm::length(stroke.b - stroke.a);
  if (!(length > 0.0)) return;
  const double wanted = kArrowLength * frame.scale + kArrowPerWidth * 2.0 * stroke.half_width;
  const double head = std::min(wanted, length);
  const double t = 1.0 - head / length;
  Stroke tip = stroke;
  tip.a = glm::mix(stroke.a, stroke.b, t);
  tip.depth_a = glm::mix(stroke.depth_a, stroke.depth_b, t);
  tip.color.a = float(stroke.opacity_b);
  tip.half_width = head * kArrowSlope;
  tip.dash = 0.0;
  tip.taper = 1.0;
  append_stroke(to, tip, frame);
  const double overlap = std::min(1.0, 0.5 * head);  // no seam between the line and its head
  stroke.b = glm::mix(stroke.a, stroke.b, 1.0 - (head - overlap) / length);
}

/// Never below one pixel: thinner lines fade instead.
void set_width(Stroke& stroke, double width) {
  stroke.half_width = 0.5 * std::max(width, 1.0);
  const double fade = std::clamp(width, 0.0, 1.0);
  stroke.color.a *= float(fade);
  stroke.opacity_b *= fade;
}

void append_line(std::vector<LineVertex>& to, const DrawLine& line, const glm::dmat4& clip_from_list, const PictureFrame& frame,
                 Seen seen) {
  const auto piece = clipped(clip_from_list * line.a, clip_from_list * line.b, frame);
  if (!piece) return;
  const bool behind = seen == Seen::behind;
  const double opacity = behind ? kHiddenOpacity : 1.0;
  Stroke stroke;
  stroke.a = pixels_of(piece->a, frame);
  stroke.b = pixels_of(piece->b, frame);
  stroke.depth_a = pulled_depth(piece->a);
  stroke.depth_b = pulled_depth(piece->b);
  stroke.color = glm::vec4(line_color(line.role, frame.theme), float(opacity * glm::mix(line.fade_a, line.fade_b, piece->t_a)));
  stroke.opacity_b = opacity * glm::mix(line.fade_a, line.fade_b, piece->t_b);
  if (behind)
    stroke.dash = (kHiddenDash + kHiddenGap) * frame.scale;
  else if (line.style == LineStyle::dashed)
    stroke.dash = (kDash + kGap) * frame.scale;
  set_width(stroke, line.width * frame.scale * (behind ? kHiddenWidth : 1.0));
  if (line.arrow && piece->t_b == 1.0) append_arrow_head(to, stroke, frame);
  append_stroke(to, stroke, frame);
}

ShapeVertex shape_corner(const ShapeVertex& flat, glm::dvec2 pixels, double depth, const PictureFrame& frame) {
  ShapeVertex vertex = flat;
  vertex.position = device_position(pixels, depth, frame);
  return vertex;
}

void append_shape(std::vector<ShapeVertex>& to, const ShapeVertex& flat, double depth, const PictureFrame& frame) {
  const glm::dvec2 centre(flat.box.x, flat.box.y), reach = glm::dvec2(flat.box.z, flat.box.w) + 1.5;
  append_quad<ShapeVertex>(to, {shape_corner(flat, centre - reach, depth, frame),
                                shape_corner(flat, centre + glm::dvec2(reach.x, -reach.y), depth, frame),
                                shape_corner(flat, centre + reach, depth, frame),
                                shape_corner(flat, centre + glm::dvec2(-reach.x, reach.y), depth, frame)});
}

}  // namespace

std::vector<LineVertex> line_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame,
                                      Seen seen) {
  std::vector<LineVertex> vertices;
  for (const DrawLine& line : list.lines) append_line(vertices, line, clip_from_list, frame, seen);
  return vertices;
}

void append_screen_line(std::vector<LineVertex>& to, const PictureFrame& frame, glm::dvec2 a, glm::dvec2 b,
                        const glm::vec4& color, double width) {
  Stroke stroke;
  stroke.a = a;
  stroke.b = b;
  stroke.color = color;
  stroke.opacity_b = color.a;
  set_width(stroke, width);
  append_stroke(to, stroke, frame);
}

std::vector<ShapeVertex> point_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame,
                                        Seen seen) {
  std::vector<ShapeVertex> vertices;
  const float opacity = seen == Seen::behind ? 0.45f : 1.0f;
  for (const DrawPoint& point : list.points) {
    const glm::dvec4 clip = clip_from_list * point.position;
    if (!finite(clip) || !(clip.w > 0.0) || std::abs(clip.x) > 2.0 * clip.w || std::abs(clip.y) > 2.0 * clip.w) continue;
    if (std::abs(clip.z) > (1.0 + kPull) * clip.w) continue;
    ShapeVertex flat;
    const double radius = point.radius * frame.scale;
    flat.box = glm::vec4(pixels_of(clip, frame), radius, radius);
    flat.fill = glm::vec4(role_color(point.role), opacity);
    flat.outline = glm::vec4(glm::vec3(frame.theme == Theme::light ? 0.1f : 0.95f), 0.85f * opacity);
    flat.shape = glm::vec2(radius, 1.25 * frame.scale);
    append_shape(vertices, flat, pulled_depth(clip), frame);
  }
  return vertices;
}

void append_plate(std::vector<ShapeVertex>& to, const PictureFrame& frame, glm::dvec2 top_left, glm::dvec2 size, double radius,
                  const glm::vec4& fill, const glm::vec4& outline) {
  ShapeVertex flat;
  flat.box = glm::vec4(top_left.x + 0.5 * size.x, frame.size.y - top_left.y - 0.5 * size.y, 0.5 * size.x, 0.5 * size.y);
  flat.fill = fill;
  flat.outline = outline;
  flat.shape = glm::vec2(radius, frame.scale);
  append_shape(to, flat, -1.0, frame);
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
    const glm::vec4 color(fill_color(fill.role, frame.theme), float(fill.alpha));
    for (std::size_t i = 2; i < corners.size(); ++i) {
      for (const glm::vec4& corner : {corners[0], corners[i - 1], corners[i]}) vertices.push_back({corner, color});
    }
  }
  return vertices;
}

}  // namespace psm::gl
