// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces from which the built-in scenes are made.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <initializer_list>
#include <vector>

#include "scene/scene.h"

namespace psm::shapes {

/// Closed surfaces with shared vertices, counter-clockwise seen from outside; several may lie in one solid and overlap.
struct Solid {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> triangles;
};

double signed_volume(const Solid& solid);
Solid transformed(Solid solid, const glm::dmat4& dest_from_source);
void append(Solid& solid, const Solid& other);

/// Half a section through a turned piece, as (radius, height) points; built from the foot upwards.
class Outline {
 public:
  /// Starts on the axis at height 0.
  Outline() : points_{{0.0, 0.0}} {}

  Outline& to(double radius, double height);
  /// Quadratic curve in `steps` pieces.
  Outline& curve(glm::dvec2 control, glm::dvec2 end, int steps);
  /// Half an ellipse, straight above the last point, that swells by `bulge`.
  Outline& bead(double bulge, double height, int steps);
  /// The rest of a ball that rests on the last point, up to the axis.
  Outline& ball(double radius, int steps);

  const std::vector<glm::dvec2>& points() const { return points_; }
  int last() const { return int(points_.size()) - 1; }
  double height() const { return points_.back().y; }

 private:
  std::vector<glm::dvec2> points_;
};

/// Moves a point of a turned surface: outline point `index`, at `angle` about the y axis.
using Carve = std::function<glm::dvec3(glm::dvec3 point, int index, double angle)>;

/// Surface of revolution about the y axis. The outline starts and ends on the axis and touches it nowhere else.
Solid lathe(const std::vector<glm::dvec2>& outline, int segments, const Carve& carve = {});

/// One section of a loft: it spans from `front` to `back` in the plane z = 0, and `half_width` to either side of it.
struct Section {
  glm::dvec2 front, back;
  double half_width;
};

/// Rings with `sides` points through the sections, closed at both ends. `squareness` 1: ellipses; less: boxier.
Solid loft(const std::vector<Section>& sections, int sides, double squareness);

/// A contour in the xy plane that the origin sees whole, `depth` thick about z = 0.
Solid extrude(const std::vector<glm::dvec2>& contour, double depth);

/// Part of a ring about the y axis, from one angle to another.
Solid ring_sector(glm::dvec2 radii, glm::dvec2 heights, glm::dvec2 angles, int steps);

/// A frame around the square |x|, |z| <= half: its section is given as (distance from that square, height) points.
Solid square_frame(double half, const std::vector<glm::dvec2>& section);

/// Adds normals: smooth across edges that bend by less than `crease` radians, sharp across the others.
Mesh shaded(const Solid& solid, double crease);

/// A rectangle of the floor y = 0 that faces upwards, its corners as (x, z).
void append_tile(Mesh& mesh, const glm::dvec2& low, const glm::dvec2& high);

/// A colour as in style sheets, 0xRRGGBB in sRGB, as the linear colour that materials hold.
glm::vec4 linear_from_srgb(std::uint32_t rgb);

/// A material of each such colour.
std::vector<Material> plain_materials(std::initializer_list<std::uint32_t> colours);

}  // namespace psm::shapes
