// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/stroke.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

constexpr Dash kDash{6.0, 4.0}, kHiddenDash{5.0, 4.0};
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

/// What is left has w > 0 and modest coordinates.
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

}  // namespace

bool finite(const glm::dvec4& p) { return std::isfinite(p.x + p.y + p.z + p.w); }

glm::dvec2 pixels_of(const glm::dvec4& clip, const PictureFrame& frame) {
  return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * frame.size;
}

double pulled_depth(const glm::dvec4& clip) { return std::clamp(clip.z / clip.w - kPull, -1.0, 1.0); }

Dash dash_of(Seen seen) { return seen == Seen::behind ? kHiddenDash : kDash; }

ArrowHead arrow_head(double stroke_width, double scale) {
  const double length = kArrowLength * scale + kArrowPerWidth * stroke_width;
  return {length, kArrowSlope * length};
}

std::optional<Stroke> stroke_of(const DrawLine& line, const glm::dmat4& clip_from_list, const PictureFrame& frame, Seen seen) {
  const auto piece = clipped(clip_from_list * line.a, clip_from_list * line.b, frame);
  if (!piece) return std::nullopt;
  const bool behind = seen == Seen::behind;
  const double opacity = behind ? kHiddenOpacity : 1.0;
  Stroke stroke;
  stroke.a = pixels_of(piece->a, frame);
  stroke.b = pixels_of(piece->b, frame);
  stroke.depth_a = pulled_depth(piece->a);
  stroke.depth_b = pulled_depth(piece->b);
  stroke.opacity_a = opacity * glm::mix(line.fade_a, line.fade_b, piece->t_a);
  stroke.opacity_b = opacity * glm::mix(line.fade_a, line.fade_b, piece->t_b);
  stroke.width = line.width * frame.scale * (behind ? kHiddenWidth : 1.0);
  stroke.dashed = behind || line.style == LineStyle::dashed;
  stroke.arrow = line.arrow && piece->t_b == 1.0;
  return stroke;
}

}  // namespace psm
