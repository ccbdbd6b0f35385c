// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols and the choices that depend on where a view looks from.
#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "draw/sketch.h"
#include "math/projective.h"

namespace psm {
namespace {

/// Distance behind the light along its rays, up to a constant: larger where light arrives later.
double arrival(const glm::dvec3& p, const glm::dvec4& light) {
  return light.w == 0.0 ? -glm::dot(p, glm::dvec3(light)) : glm::length(p - glm::dvec3(light) / light.w);
}

/// The half of the vertices on which light falls last; rays that end there have crossed the body.
std::vector<glm::dvec3> lit_last(const ConvexBody& body, const glm::dvec4& light) {
  std::vector<glm::dvec3> points = body.vertices;
  std::stable_sort(points.begin(), points.end(),
                   [&](const glm::dvec3& p, const glm::dvec3& q) { return arrival(p, light) > arrival(q, light); });
  points.resize((points.size() + 1) / 2);
  return points;
}

}  // namespace

Viewpoint::Viewpoint(const OrbitCamera& camera)
    : clip_from_space(camera.clip_from_view * camera.view_from_space),
      eye(camera.eye),
      right(row(camera.view_from_space, 0)),
      up(row(camera.view_from_space, 1)),
      forward(-glm::dvec3(row(camera.view_from_space, 2))),
      tan_half(1.0 / camera.clip_from_view[1][1]) {}

double Viewpoint::length_of(double fraction, const glm::dvec3& p) const {
  return fraction * 2.0 * tan_half * std::abs(glm::dot(p - eye, forward));
}

bool Viewpoint::sees(const glm::dvec3& p, double margin) const {
  const glm::dvec4 q = clip_from_space * at(p);
  return q.w > 0.0 && std::abs(q.x) <= margin * q.w && std::abs(q.y) <= margin * q.w;
}

glm::dvec3 Viewpoint::furthest(const std::vector<glm::dvec3>& points, const glm::dvec2& direction) const {
  glm::dvec3 best = points.front();
  double best_value = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : points) {
    if (!sees(p, 0.97)) continue;
    const glm::dvec4 q = clip_from_space * at(p);
    const double value = glm::dot(glm::dvec2(q) / q.w, direction);
    if (value > best_value) {
      best_value = value;
      best = p;
    }
  }
  return best;
}

std::optional<glm::dvec3> Viewpoint::visible_middle(const glm::dvec3& a, const glm::dvec3& b) const {
  const Box picture{{-0.94, -0.94, -1.0}, {0.94, 0.94, 1.0}};
  const auto visible = clip_segment(clip_from_space * at(a), clip_from_space * at(b), picture);
  if (!visible) return std::nullopt;
  const glm::dvec4 middle = glm::inverse(clip_from_space) * at(0.5 * (visible->a + visible->b));
  return glm::dvec3(middle) / middle.w;
}

void draw_lamp(Sketch& sketch, const Viewpoint& view, const glm::dvec3& p, int rays) {
  const double inner = view.length_of(0.020, p), outer = view.length_of(0.033, p);
  for (int i = 0; i < rays; ++i) {
    const double angle = glm::radians(360.0) * (i + 0.5) / rays;
    const glm::dvec3 d = std::cos(angle) * view.right + std::sin(angle) * view.up;
    sketch.line(p + inner * d, p + outer * d, {Role::light, 2.0});
  }
  sketch.point(p, Role::light, 6.5);
}

std::vector<glm::dvec3> ray_targets(const ConvexBody& body, const glm::dvec4& light, int count) {
  if (body.empty()) return {};
  const std::vector<glm::dvec3> points = lit_last(body, light);
  std::vector<glm::dvec3> chosen{points.front()};
  while (int(chosen.size()) < count) {
    glm::dvec3 best{0.0};
    double best_distance = 0.0;
    for (const glm::dvec3& p : points) {
      double distance = std::numeric_limits<double>::infinity();
      for (const glm::dvec3& c : chosen) distance = std::min(distance, glm::length(p - c));
      if (distance > best_distance) {
        best_distance = distance;
        best = p;
      }
    }
    if (!(best_distance > 0.0)) break;
    chosen.push_back(best);
  }
  return chosen;
}

std::string short_number(double value, int digits) {
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  if (std::isnan(value)) return "none";
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(digits);
  out << (value == 0.0 ? 0.0 : value);
  return out.str();
}

}  // namespace psm
