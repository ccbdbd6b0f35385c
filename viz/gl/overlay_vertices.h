// SPDX-License-Identifier: GPL-3.0-or-later
// From a DrawList to what the overlay shaders draw, on the processor and without OpenGL. Pixels are counted from the bottom left,
// as gl_FragCoord counts them; positions are divided, so that a shader measures distances in pixels exactly.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "draw/annotation.h"
#include "draw/stroke.h"

namespace psm::gl {

/// A corner of the quad around a segment. `color` and `shape` are the same at the six corners.
struct LineVertex {
  glm::vec3 position;  // normalised device coordinates
  glm::vec4 place;  // along the segment from a, aside of it, in pixels; periods of dash and gap; the segment's length in pixels
  glm::vec4 color;  // sRGB and opacity at a
  /// Width in pixels (of an arrow head: half its base), opacity at b, length of dash + gap (0: none), taper (1: an arrow head
  /// with its tip at b). What the scene hides is drawn by the fragment shader, as stroke.h has it.
  glm::vec4 shape;
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

/// Segments clipped to the picture before they are divided by w; lines that are not finite or outside are left out.
std::vector<LineVertex> line_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame);

std::vector<ShapeVertex> point_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame);

/// In front of everything.
std::vector<LineVertex> mark_vertices(std::span<const Mark> marks, const PictureFrame& frame);
std::vector<ShapeVertex> plate_vertices(std::span<const Plate> plates, const PictureFrame& frame);

std::vector<FillVertex> fill_vertices(const DrawList& list, const glm::dmat4& clip_from_list, const PictureFrame& frame);

}  // namespace psm::gl
