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

/// The last point of the body on the light ray through `p`, a point of the body: where a receiver's floor or wall is.
glm::dvec3 where_light_leaves(const ConvexBody& body, const glm::dvec4& light, const glm::dvec3& p) {
  const glm::dvec3 travel = safe_normalize(light.w * p - glm::dvec3(light));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Plane& plane : body.planes) {
    const double closing = -glm::dot(glm::dvec3(plane), travel);
    if (closing > 0.0) nearest = std::min(nearest, std::max(0.0, glm::dot(plane, at(p))) / closing);
  }
  return std::isfinite(nearest) ? p + nearest * travel : p;
}

double distance_to(const std::vector<glm::dvec3>& points, const glm::dvec3& p) {
  double distance = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& q : points) distance = std::min(distance, glm::length(p - q));
  return distance;
}

const glm::dvec3& furthest_from(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& candidates) {
  return *std::max_element(candidates.begin(), candidates.end(), [&](const glm::dvec3& p, const glm::dvec3& q) {
    return distance_to(points, p) < distance_to(points, q);
  });
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

std::optional<Piece> Viewpoint::visible_part(const glm::dvec3& a, const glm::dvec3& b) const {
  const Box picture{{-0.92, -0.92, -1.0}, {0.92, 0.92, 1.0}};
  const auto seen = clip_segment(clip_from_space * at(a), clip_from_space * at(b), picture);
  if (!seen) return std::nullopt;
  const glm::dmat4 space_from_clip = glm::inverse(clip_from_space);
  const glm::dvec4 p = space_from_clip * at(seen->a), q = space_from_clip * at(seen->b);
  return Piece{glm::dvec3(p) / p.w, glm::dvec3(q) / q.w, seen->cut_a, seen->cut_b};
}

std::optional<glm::dvec3> Viewpoint::visible_middle(const glm::dvec3& a, const glm::dvec3& b) const {
  const auto part = visible_part(a, b);
  return part ? std::optional(0.5 * (part->a + part->b)) : std::nullopt;
}

void draw_lamp(Sketch& sketch, const Viewpoint& view, const glm::dvec3& p, int rays) {
  const double inner = view.length_of(0.018, p), outer = view.length_of(0.028, p);
  for (int i = 0; i < rays; ++i) {
    const double angle = glm::radians(360.0) * (i + 0.5) / rays;
    const glm::dvec3 d = std::cos(angle) * view.right + std::sin(angle) * view.up;
    sketch.line(p + inner * d, p + outer * d, {Role::light, 2.0});
  }
  sketch.point(p, Role::light, 6.5);
}

std::vector<glm::dvec3> ray_targets(const ConvexBody& body, const glm::dvec4& light, int count) {
  if (body.empty()) return {};
  const glm::dvec3 centroid = body.centroid();
  std::vector<glm::dvec3> candidates;
  double size = 0.0;
  for (const glm::dvec3& v : body.vertices) {
    candidates.push_back(where_light_leaves(body, light, glm::mix(centroid, v, 0.8)));
    size = std::max(size, glm::length(v - centroid));
  }
  std::vector<glm::dvec3> chosen{where_light_leaves(body, light, centroid)};
  while (int(chosen.size()) < count) {
    const glm::dvec3 best = furthest_from(chosen, candidates);
    if (!(distance_to(chosen, best) > 0.3 * size)) break;
    chosen.push_back(best);
  }
  return chosen;
}

std::string short_number(double value, int digits) {
  if (std::isinf(value)) return value > 0.0 ? "∞" : "-∞";
  if (std::isnan(value)) return "none";
  std::ostringstream out;
  out.imbue(std::locale::classic());
  const double size = std::abs(value);
  const bool whole = size >= std::pow(10.0, digits) - 0.5 && size < 1e7;
  if (whole) out << std::fixed;
  out.precision(whole ? 0 : digits);
  out << (value == 0.0 ? 0.0 : value);
  return out.str();
}

}  // namespace psm
