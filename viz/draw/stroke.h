// SPDX-License-Identifier: GPL-3.0-or-later
// A line of a DrawList on the picture: where it is and how it looks, for the screen and for figures alike.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "draw/draw_list.h"
#include "draw/theme.h"

namespace psm {

/// Lines as they are where nothing hides them, or as they show behind the scene: thinner, dashed, fainter.
enum class Seen { in_front, behind };
constexpr double kHiddenWidth = 0.7, kHiddenOpacity = 0.6, kHiddenPointOpacity = 0.45;  // times their own

/// Pixels, y upwards; depths in normalised device coordinates, a little nearer than the line, so that what lies on a surface is
/// not hidden by it.
struct Stroke {
  glm::dvec2 a{0.0}, b{0.0};
  double depth_a = -1.0, depth_b = -1.0;
  double opacity_a = 1.0, opacity_b = 1.0;
  double width = 1.0;  // pixels; may be less than one
  bool dashed = false;
  bool arrow = false;  // a head at b
};

/// Of dashed strokes, pixels at scale 1.
struct Dash {
  double on, off;
  double period() const { return on + off; }
};
Dash dash_of(Seen seen);

/// A head's length and half its width, for a stroke of this width.
struct ArrowHead {
  double length, half_width;
};
ArrowHead arrow_head(double stroke_width, double scale);

/// The part of the line that the picture, a margin around it, and the depth range hold: clipped before it is divided by w. None
/// where all of it is outside or not finite.
std::optional<Stroke> stroke_of(const DrawLine& line, const glm::dmat4& clip_from_list, const PictureFrame& frame, Seen seen);

/// How much nearer than what they lie on lines, points and fills are drawn, in normalised depth: 1e-5 of its range.
constexpr double kPull = 2e-5;

glm::dvec2 pixels_of(const glm::dvec4& clip, const PictureFrame& frame);
double pulled_depth(const glm::dvec4& clip);
bool finite(const glm::dvec4& p);

}  // namespace psm
