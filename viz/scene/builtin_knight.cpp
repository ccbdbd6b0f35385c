// SPDX-License-Identifier: GPL-3.0-or-later
// The knight: a horse's head and neck lofted through sections of its side view, on a turned foot.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin_pieces.h"

namespace psm::shapes {
namespace {

/// From the foot of the neck to the lips. `front` is the chest, throat, jaw and chin; `back` the crest, forehead and nose.
const std::vector<Section>& head_sections() {
  static const std::vector<Section> sections{
      {{0.190, 0.19}, {-0.190, 0.19}, 0.170},  {{0.215, 0.27}, {-0.215, 0.28}, 0.165},  {{0.215, 0.37}, {-0.240, 0.42}, 0.150},
      {{0.165, 0.48}, {-0.245, 0.58}, 0.135},  {{0.105, 0.57}, {-0.225, 0.74}, 0.122},  {{0.062, 0.65}, {-0.175, 0.89}, 0.114},
      {{0.052, 0.70}, {-0.095, 1.00}, 0.110},  {{0.072, 0.725}, {0.000, 1.05}, 0.112},  {{0.112, 0.69}, {0.085, 1.03}, 0.120},
      {{0.155, 0.64}, {0.165, 0.955}, 0.116},  {{0.200, 0.605}, {0.240, 0.870}, 0.098}, {{0.245, 0.565}, {0.310, 0.785}, 0.082},
      {{0.285, 0.520}, {0.368, 0.715}, 0.080}, {{0.325, 0.500}, {0.408, 0.645}, 0.072}, {{0.358, 0.515}, {0.410, 0.595}, 0.046}};
  return sections;
}

Section catmull_rom(const Section& a, const Section& b, const Section& c, const Section& d, double t) {
  const auto blend = [t](auto p, auto q, auto r, auto s) {
    return q + 0.5 * t * (r - p + t * (2.0 * p - 5.0 * q + 4.0 * r - s + t * (3.0 * (q - r) + s - p)));
  };
  return {blend(a.front, b.front, c.front, d.front), blend(a.back, b.back, c.back, d.back),
          blend(a.half_width, b.half_width, c.half_width, d.half_width)};
}

std::vector<Section> refined(const std::vector<Section>& s, int steps) {
  std::vector<Section> fine;
  for (std::size_t i = 0; i + 1 < s.size(); ++i)
    for (int k = 0; k < steps; ++k)
      fine.push_back(catmull_rom(s[i ? i - 1 : 0], s[i], s[i + 1], s[std::min(i + 2, s.size() - 1)], double(k) / steps));
  fine.push_back(s.back());
  return fine;
}

/// A thin ridge of locks along the crest of the neck.
Solid mane(const std::vector<Section>& fine, std::size_t first, std::size_t last) {
  std::vector<Section> ridge;
  for (std::size_t i = first; i <= last; ++i) {
    const glm::dvec2 along = glm::normalize(fine[i + 1].back - fine[i - 1].back), out{-along.y, along.x};
    const bool at_end = i == first || i == last;
    const double height = at_end ? 0.005 : (i - first) % 3 == 0 ? 0.022 : 0.048;
    ridge.push_back({fine[i].back - 0.05 * out, fine[i].back + height * out, 0.036});
  }
  return loft(ridge, 6, 0.7);
}

void add_ears_and_eyes(Solid& solid) {
  for (double side : {-1.0, 1.0}) {
    glm::dmat4 ear = glm::translate(glm::dmat4(1.0), glm::dvec3(-0.015, 1.00, 0.058 * side));
    ear = glm::rotate(ear, 0.18 * side, glm::dvec3(1, 0, 0));
    append(solid,
           transformed(lathe(Outline().to(0.044, 0.01).curve({0.05, 0.09}, {0.008, 0.165}, 4).to(0, 0.17).points(), 8), ear));
    const glm::dmat4 eye = glm::translate(glm::dmat4(1.0), glm::dvec3(0.135, 0.900, 0.088 * side));
    append(solid, transformed(lathe(Outline().ball(0.026, 4).points(), 8), eye));
  }
}

}  // namespace

Solid knight() {
  Outline outline = foot(0.31, {0.235, 0.21});
  Solid solid = lathe(outline.curve({0.23, 0.235}, {0.2, 0.24}, 2).to(0, 0.24).points(), 26);
  const std::vector<Section> fine = refined(head_sections(), 2);
  append(solid, loft(fine, 12, 0.85));
  append(solid, mane(fine, 3, 14));
  add_ears_and_eyes(solid);
  return solid;
}

}  // namespace psm::shapes
