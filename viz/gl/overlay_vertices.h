// SPDX-License-Identifier: GPL-3.0-or-later
// From a DrawList to what the overlay shaders draw, on the processor and without OpenGL. Pixels are counted from the bottom left,
// as gl_FragCoord counts them; positions are divided, so that a shader measures distances in pixels exactly.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "draw/draw_list.h"
#include "gl/renderer.h"

namespace psm::gl {

/// A corner of the quad around a segment. All but `position` are the same at the six corners.
struct LineVertex {
  glm::vec3 position;  // normalised device coordinates
  glm::vec4 segment;   // a.xy, b.xy in pixels
  glm::vec4 color;     // sRGB and opacity at a
  glm::vec4
      shape;  // half width in pixels, opacity at b, length of dash + gap (0: none), taper (1: an arrow head with its tip at b)
};

/// A corner of the box around a disc or a rounded plate.
struct ShapeVertex {
  glm::vec3 position;
  glm::vec4 box;  // centre, half size in pixels
  glm::vec4 fill;
  glm::vec4 outline;
  glm::vec2 shape;  // corner radius, outline width in pixels
};

struct FillVertex {
  glm::vec4 position;  // clip space, homogeneous
  glm::vec4 color;
};

struct PictureFrame {
  glm::dvec2 size{1.0};  // pixels
  double scale = 1.0;
  Theme theme = Theme::light;
};

/// Lines as they are where nothing hides them, or as they show behind the scene: thinner, dashed, 60 %.
enum class Seen { in_front, behind };

/// Segments clipped to the picture before they are divided by w; lines that are not finite or outside are left out.
std::vector<LineVertex> line_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame,
                                      Seen seen);

/// One solid line between two pixels, in front of everything; for leaders.
void append_screen_line(std::vector<LineVertex>& to, const PictureFrame& frame, glm::dvec2 a, glm::dvec2 b,
                        const glm::vec4& color, double width);

std::vector<ShapeVertex> point_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame,
                                        Seen seen);

/// A rounded plate; `top_left` and `size` in pixels, y downwards.
void append_plate(std::vector<ShapeVertex>& to, const PictureFrame& frame, glm::dvec2 top_left, glm::dvec2 size, double radius,
                  const glm::vec4& fill, const glm::vec4& outline);

std::vector<FillVertex> fill_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame);

}  // namespace psm::gl
