// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/builtin_pieces.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace psm::shapes {
namespace {

constexpr double kPi = glm::pi<double>();
constexpr int kPawnSegments = 22, kSegments = 26;

/// A disc with a round rim around the stem, then back to the stem's radius.
void add_collar(Outline& outline, double radius, double thickness, double stem) {
  const double y = outline.height();
  outline.curve({stem, y + 0.02}, {radius - 0.5 * thickness, y + 0.03}, 1);
  outline.bead(0.5 * thickness, thickness, 3);
  outline.to(stem, outline.height() + 0.012);
}

/// Cross with flaring arms, its foot at the origin.
Solid cross_pattee(double size, double depth) {
  const double tip = 0.5 * size, wide = 0.30 * size, narrow = 0.11 * size;
  std::vector<glm::dvec2> contour;
  for (int arm = 0; arm < 4; ++arm) {
    const double angle = 0.5 * kPi * arm, c = std::cos(angle), s = std::sin(angle);
    for (const glm::dvec2& p : {glm::dvec2(tip, -wide), {tip, wide}, {narrow, narrow}})
      contour.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
  }
  return transformed(extrude(contour, depth), glm::translate(glm::dmat4(1.0), glm::dvec3(0, tip, 0)));
}

// ---- the bishop's mitre: an ogive with a slanting cut on its front ----------------------------------------------------

constexpr double kMitreBottom = 0.905, kMitreHeight = 0.36, kCutSlope = 0.75, kCutFloor = 0.01;
constexpr double kCutLow = 0.44, kCutMiddle = 0.475, kCutHigh = 0.51;  // heights of its lips and floor on the axis

double mitre_radius(double t) { return 0.34 * std::sqrt(t + 0.1) * std::pow(std::max(1 - t, 0.0), 0.75); }

/// Slants the horizontal ring at t so that the cut's lips lie in parallel planes, and stays on the ogive.
glm::dvec3 slanted(double t, double angle) {
  const double slope = kCutSlope * std::min(1.0, 3.2 * t * (1 - t) * (1 + t));
  double u = t;
  for (int i = 0; i < 12; ++i) u = std::clamp(t + slope * mitre_radius(u) * std::cos(angle) / kMitreHeight, 0.0, 0.97);
  const double radius = mitre_radius(u);
  return {radius * std::cos(angle), kMitreBottom + kMitreHeight * u, radius * std::sin(angle)};
}

/// The floor of the cut is a chord: nothing of that ring reaches beyond it.
glm::dvec3 mitre_point(double t, double angle) {
  glm::dvec3 p = slanted(t, angle);
  if (t == kCutMiddle && p.x > kCutFloor) {
    p.x = kCutFloor;
    p.y = kMitreBottom + kMitreHeight * t + kCutSlope * p.x;
  }
  return p;
}

}  // namespace

Outline foot(double radius, glm::dvec2 waist) {
  Outline outline;
  outline.to(0.96 * radius, 0).to(radius, 0.02).to(radius, 0.075);
  outline.curve({radius, 0.125}, {0.84 * radius, 0.135}, 2);
  outline.to(0.78 * radius, 0.142).bead(0.035, 0.055, 3);
  outline.curve({waist.x + 0.02, 0.14 + 0.32 * waist.y}, waist, 4);
  return outline;
}

Solid pawn() {
  Outline outline = foot(0.27, {0.095, 0.50});
  add_collar(outline, 0.185, 0.045, 0.095);
  outline.ball(0.152, 6);
  return lathe(outline.points(), kPawnSegments);
}

Solid rook() {
  Outline outline = foot(0.31, {0.175, 0.56});
  add_collar(outline, 0.235, 0.05, 0.18);
  outline.curve({0.185, 0.78}, {0.255, 0.82}, 4);
  const double rim = 0.93, floor = 0.87;
  outline.to(0.265, 0.84).to(0.265, rim).to(0.175, rim).to(0.17, floor).to(0, floor);
  Solid solid = lathe(outline.points(), kSegments);
  for (int i = 0; i < 6; ++i) {
    const double middle = kPi * i / 3;
    append(solid, ring_sector({0.177, 0.263}, {rim - 0.01, 1.04}, {middle - 0.37, middle + 0.37}, 4));
  }
  return solid;
}

Solid bishop() {
  Outline outline = foot(0.29, {0.098, 0.72});
  add_collar(outline, 0.19, 0.045, 0.115);
  outline.to(0.115, outline.height() + 0.01).bead(0.03, kMitreBottom - outline.height() - 0.02, 3);
  const int first = outline.last() + 1;
  std::vector<glm::dvec2> points = outline.points();
  const std::vector<double> rings{0.0, 0.08, 0.17, 0.26, 0.35, kCutLow, kCutMiddle, kCutHigh, 0.6, 0.7, 0.8, 0.9};
  for (double t : rings) points.push_back({mitre_radius(t), kMitreBottom + kMitreHeight * t});
  points.push_back({0.0, kMitreBottom + kMitreHeight});
  Solid solid = lathe(points, kSegments, [&](glm::dvec3 p, int index, double angle) {
    return index < first ? p : mitre_point(rings[std::size_t(index - first)], angle);
  });
  append(solid, transformed(lathe(Outline().ball(0.045, 5).points(), 12),
                            glm::translate(glm::dmat4(1.0), glm::dvec3(0, kMitreBottom + kMitreHeight - 0.03, 0))));
  return solid;
}

Solid queen() {
  Outline outline = foot(0.335, {0.115, 0.95});
  add_collar(outline, 0.215, 0.05, 0.13);
  add_collar(outline, 0.17, 0.04, 0.115);
  outline.curve({0.125, 1.27}, {0.235, 1.36}, 6);
  const int rim = outline.last();
  outline.to(0.205, 1.362);
  outline.to(0.155, 1.33).curve({0.12, 1.41}, {0.04, 1.425}, 4);
  outline.ball(0.058, 6);
  // Eight points: the rim rises and falls, and both its edges go along.
  return lathe(outline.points(), 32, [&](glm::dvec3 p, int index, double angle) {
    if (index == rim || index == rim + 1) p.y += 0.055 * (std::pow(0.5 + 0.5 * std::cos(8 * angle), 0.8) - 0.35);
    return p;
  });
}

Solid king() {
  Outline outline = foot(0.35, {0.125, 1.02});
  add_collar(outline, 0.225, 0.05, 0.14);
  add_collar(outline, 0.18, 0.04, 0.125);
  outline.curve({0.135, 1.33}, {0.225, 1.44}, 5).to(0.228, 1.465).to(0.205, 1.475);
  outline.curve({0.15, 1.54}, {0.05, 1.55}, 4).to(0.05, 1.565).curve({0.045, 1.58}, {0.025, 1.585}, 2).to(0, 1.585);
  Solid solid = lathe(outline.points(), kSegments);
  append(solid, transformed(cross_pattee(0.25, 0.08), glm::translate(glm::dmat4(1.0), glm::dvec3(0, 1.565, 0))));
  return solid;
}

}  // namespace psm::shapes
