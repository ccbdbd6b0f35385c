// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/builtin_shapes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace psm::shapes {
namespace {

constexpr double kPi = glm::pi<double>();

void add_triangle(Solid& solid, std::size_t a, std::size_t b, std::size_t c) {
  for (std::size_t i : {a, b, c}) solid.triangles.push_back(std::uint32_t(i));
}

void add_quad(Solid& solid, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  add_triangle(solid, a, b, c);
  add_triangle(solid, a, c, d);
}

/// The builders below need not know which way round they went.
Solid turned_outward(Solid solid) {
  if (signed_volume(solid) < 0)
    for (std::size_t i = 0; i < solid.triangles.size(); i += 3) std::swap(solid.triangles[i + 1], solid.triangles[i + 2]);
  return solid;
}

/// Joins rings of `sides` vertices each, the first one at vertex 0.
void join_rings(Solid& solid, std::size_t rings, std::size_t sides) {
  for (std::size_t r = 0; r + 1 < rings; ++r)
    for (std::size_t i = 0; i < sides; ++i) {
      const std::size_t j = (i + 1) % sides, low = r * sides, high = low + sides;
      add_quad(solid, low + i, low + j, high + j, high + i);
    }
}

/// Closes the first and last ring with a fan each around two new vertices.
void cap_rings(Solid& solid, std::size_t rings, std::size_t sides, const glm::dvec3& first, const glm::dvec3& last) {
  const std::size_t bottom = solid.positions.size(), top = bottom + 1, ring = (rings - 1) * sides;
  solid.positions.push_back(first);
  solid.positions.push_back(last);
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t j = (i + 1) % sides;
    add_triangle(solid, bottom, j, i);
    add_triangle(solid, top, ring + i, ring + j);
  }
}

/// |cos|^p with the sign of cos: the coordinates of a superellipse.
double rounded(double cosine, double power) { return std::copysign(std::pow(std::abs(cosine), power), cosine); }

}  // namespace

double signed_volume(const Solid& solid) {
  double six_volumes = 0;
  for (std::size_t i = 0; i < solid.triangles.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return solid.positions[solid.triangles[i + k]]; };
    six_volumes += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
  }
  return six_volumes / 6;
}

Solid transformed(Solid solid, const glm::dmat4& dest_from_source) {
  for (glm::dvec3& p : solid.positions) p = glm::dvec3(dest_from_source * glm::dvec4(p, 1.0));
  return turned_outward(std::move(solid));
}

void append(Solid& solid, const Solid& other) {
  const auto first = std::uint32_t(solid.positions.size());
  solid.positions.insert(solid.positions.end(), other.positions.begin(), other.positions.end());
  for (std::uint32_t i : other.triangles) solid.triangles.push_back(first + i);
}

Outline& Outline::to(double radius, double height) {
  points_.push_back({radius, height});
  return *this;
}

Outline& Outline::curve(glm::dvec2 control, glm::dvec2 end, int steps) {
  const glm::dvec2 start = points_.back();
  for (int i = 1; i <= steps; ++i) {
    const double t = double(i) / steps;
    points_.push_back(glm::mix(glm::mix(start, control, t), glm::mix(control, end, t), t));
  }
  return *this;
}

Outline& Outline::bead(double bulge, double height, int steps) {
  const glm::dvec2 start = points_.back();
  for (int i = 1; i <= steps; ++i) {
    const double angle = kPi * i / steps;
    points_.push_back({start.x + bulge * std::sin(angle), start.y + height * 0.5 * (1 - std::cos(angle))});
  }
  return *this;
}

Outline& Outline::ball(double radius, int steps) {
  const glm::dvec2 start = points_.back();
  assert(start.x <= radius);
  const double first = std::acos(-std::sqrt(1 - start.x * start.x / (radius * radius)));  // from the top
  const double center = start.y - radius * std::cos(first);
  for (int i = 1; i < steps; ++i) {
    const double angle = first * (1 - double(i) / steps);
    points_.push_back({radius * std::sin(angle), center + radius * std::cos(angle)});
  }
  points_.push_back({0.0, center + radius});
  return *this;
}

Solid lathe(const std::vector<glm::dvec2>& outline, int segments, const Carve& carve) {
  assert(outline.size() >= 3 && outline.front().x == 0 && outline.back().x == 0);
  Solid solid;
  const std::size_t rings = outline.size() - 2;
  for (std::size_t r = 1; r <= rings; ++r)
    for (int i = 0; i < segments; ++i) {
      const double angle = 2 * kPi * i / segments;
      const glm::dvec3 p{outline[r].x * std::cos(angle), outline[r].y, outline[r].x * std::sin(angle)};
      solid.positions.push_back(carve ? carve(p, int(r), angle) : p);
    }
  join_rings(solid, rings, std::size_t(segments));
  cap_rings(solid, rings, std::size_t(segments), {0, outline.front().y, 0}, {0, outline.back().y, 0});
  return turned_outward(std::move(solid));
}

Solid loft(const std::vector<Section>& sections, int sides, double squareness) {
  assert(sections.size() >= 2);
  Solid solid;
  for (const Section& s : sections)
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * kPi * i / sides;
      const glm::dvec2 p = 0.5 * (s.front + s.back) + 0.5 * rounded(std::cos(angle), squareness) * (s.front - s.back);
      solid.positions.push_back({p, s.half_width * rounded(std::sin(angle), squareness)});
    }
  const auto middle = [](const Section& s) { return glm::dvec3(0.5 * (s.front + s.back), 0.0); };
  join_rings(solid, sections.size(), std::size_t(sides));
  cap_rings(solid, sections.size(), std::size_t(sides), middle(sections.front()), middle(sections.back()));
  return turned_outward(std::move(solid));
}

Solid extrude(const std::vector<glm::dvec2>& contour, double depth) {
  Solid solid;
  for (double z : {-0.5 * depth, 0.5 * depth})
    for (const glm::dvec2& p : contour) solid.positions.push_back({p, z});
  join_rings(solid, 2, contour.size());
  cap_rings(solid, 2, contour.size(), {0, 0, -0.5 * depth}, {0, 0, 0.5 * depth});
  return turned_outward(std::move(solid));
}

Solid ring_sector(glm::dvec2 radii, glm::dvec2 heights, glm::dvec2 angles, int steps) {
  Solid solid;
  for (int i = 0; i <= steps; ++i) {
    const double angle = glm::mix(angles.x, angles.y, double(i) / steps);
    const glm::dvec2 out{std::cos(angle), std::sin(angle)};
    for (const glm::dvec2& section :
         {glm::dvec2(radii.x, heights.x), {radii.y, heights.x}, {radii.y, heights.y}, {radii.x, heights.y}})
      solid.positions.push_back({section.x * out.x, section.y, section.x * out.y});
  }
  const std::size_t end = std::size_t(steps) * 4;
  join_rings(solid, std::size_t(steps) + 1, 4);
  add_quad(solid, 3, 2, 1, 0);
  add_quad(solid, end, end + 1, end + 2, end + 3);
  return turned_outward(std::move(solid));
}

Solid square_frame(double half, const std::vector<glm::dvec2>& section) {
  Solid solid;
  const std::size_t sides = section.size();
  for (const glm::dvec2& corner : {glm::dvec2(1, 1), {-1, 1}, {-1, -1}, {1, -1}})
    for (const glm::dvec2& s : section) solid.positions.push_back({corner.x * (half + s.x), s.y, corner.y * (half + s.x)});
  join_rings(solid, 4, sides);
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t j = (i + 1) % sides;
    add_quad(solid, 3 * sides + i, 3 * sides + j, j, i);
  }
  return turned_outward(std::move(solid));
}

void append_tile(Mesh& mesh, const glm::dvec2& low, const glm::dvec2& high) {
  const auto first = std::uint32_t(mesh.positions.size());
  for (const glm::dvec3& p : {glm::dvec3(low.x, 0, high.y), {high.x, 0, high.y}, {high.x, 0, low.y}, {low.x, 0, low.y}}) {
    mesh.positions.push_back(p);
    mesh.normals.push_back({0, 1, 0});
  }
  for (std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.triangles.push_back(first + k);
}

glm::vec4 linear_from_srgb(std::uint32_t rgb) {
  glm::vec4 linear(1.0f);
  for (int i = 0; i < 3; ++i) {
    const double s = ((rgb >> (16 - 8 * i)) & 255u) / 255.0;  // IEC 61966-2-1
    linear[i] = float(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
  }
  return linear;
}

std::vector<Material> plain_materials(std::initializer_list<std::uint32_t> colours) {
  std::vector<Material> materials;
  for (const std::uint32_t colour : colours) materials.emplace_back().base_color = linear_from_srgb(colour);
  return materials;
}

}  // namespace psm::shapes
