// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "draw/sketch.h"
#include "math/projective.h"
#include "scene/texel_sampling.h"

namespace psm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// 1 / smallest singular value of d(texel)/d(length) across the ray: the widest a beam of one texel is.
double beam_width(const glm::dmat4& map, const glm::dvec3& p, const glm::dvec3& ray, double resolution) {
  const glm::dvec3 t1 = perpendicular(ray), t2 = glm::cross(ray, t1);
  const glm::dvec2 a = 0.5 * resolution * detail::projected_derivative(map, p, t1),
                   b = 0.5 * resolution * detail::projected_derivative(map, p, t2);
  const double largest = (std::hypot(a.x + b.y, a.y - b.x) + std::hypot(a.x - b.y, a.y + b.x)) / 2;
  const double determinant = std::abs(a.x * b.y - a.y * b.x);
  return determinant > 0.0 ? largest / determinant : kInfinity;
}

/// Where the light ray of the map's point `uv` (clip coordinates) meets the receiver's tangent plane: on it u = a/c and v = b/c
/// are two linear equations. Nothing where they have no solution or the map does not hold it (c <= 0).
std::optional<glm::dvec3> on_tangent_plane(const glm::dmat4& map, const SurfacePoint& receiver, const glm::dvec2& uv) {
  const glm::dvec3 t1 = perpendicular(receiver.normal), t2 = glm::cross(receiver.normal, t1);
  const glm::dvec4 c = row(map, 3), f = row(map, 0) - uv.x * c, g = row(map, 1) - uv.y * c;
  const auto along = [](const glm::dvec4& plane, const glm::dvec3& t) { return glm::dot(glm::dvec3(plane), t); };
  const double f0 = glm::dot(f, at(receiver.position)), g0 = glm::dot(g, at(receiver.position));
  const double determinant = along(f, t1) * along(g, t2) - along(f, t2) * along(g, t1);
  const double s = (along(f, t2) * g0 - f0 * along(g, t2)) / determinant,
               t = (f0 * along(g, t1) - along(f, t1) * g0) / determinant;
  const glm::dvec3 p = receiver.position + s * t1 + t * t2;
  if (!std::isfinite(s + t) || !(glm::dot(c, at(p)) > 0.0)) return std::nullopt;
  return p;
}

std::vector<glm::dvec3> footprint_polygon(const glm::dmat4& map, const SurfacePoint& receiver, const glm::ivec2& texel,
                                          double resolution) {
  std::vector<glm::dvec3> corners;
  for (const glm::ivec2& step : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(1, 1), glm::ivec2(0, 1)}) {
    const auto corner = on_tangent_plane(map, receiver, glm::dvec2(texel + step) / resolution * 2.0 - 1.0);
    if (!corner) return {};
    corners.push_back(*corner);
  }
  return corners;
}

}  // namespace

std::optional<Probe> make_probe(const Analysis& analysis, const SurfacePoint& receiver, std::optional<glm::dvec3> occluder,
                                bool seen) {
  const auto map = map_at(analysis, receiver.position);
  if (!map) return std::nullopt;
  const Experiment& x = analysis.experiment;
  const double n = x.shadow.resolution;
  const glm::dvec3 &p = receiver.position, to_light = safe_normalize(glm::dvec3(analysis.light) - analysis.light.w * p),
                   to_eye = x.camera.position - p;
  const glm::dvec4 q = map->map_from_world * at(p);
  if (!(q.w > 0.0)) return std::nullopt;

  Probe out;
  out.receiver = receiver, out.occluder = occluder, out.seen = seen;
  out.lit_side = glm::dot(receiver.normal, to_light) > 0.0;
  out.layer = map->layer;
  out.in_map = glm::dvec2(q) / q.w;
  const glm::dvec2 texels = glm::floor(glm::clamp((0.5 * out.in_map + 0.5) * n, -1e6, 1e6));
  out.texel = glm::ivec2(texels);
  out.inside_map = texels.x >= 0.0 && texels.y >= 0.0 && texels.x < n && texels.y < n;
  out.footprint = footprint_polygon(map->map_from_world, receiver, out.texel, n);
  out.r_s = analysis.light.w != 0.0 ? glm::length(glm::dvec3(analysis.light) / analysis.light.w - p) : kInfinity;
  out.r_i = glm::length(to_eye);
  out.alpha = angle_between(to_light, receiver.normal);
  out.beta = angle_between(to_eye, receiver.normal);
  out.beam = beam_width(map->map_from_world, p, to_light, n);
  out.pixel = 2.0 * std::tan(0.5 * glm::radians(x.camera.vertical_fov_deg)) / x.image.height;
  out.d = out.lit_side ? out.beam * std::cos(out.beta) / (out.r_i * std::cos(out.alpha) * out.pixel) : kInfinity;
  out.size = footprint_at(analysis, receiver);
  return out;
}

std::vector<std::pair<std::string, std::string>> probe_numbers(const Probe& probe) {
  const auto degrees = [](double radians) { return short_number(glm::degrees(radians)) + "°"; };
  std::vector<std::pair<std::string, std::string>> out;
  out.emplace_back("texel", probe.inside_map ? std::to_string(probe.texel.x) + ", " + std::to_string(probe.texel.y) : "outside");
  out.emplace_back("rₛ", short_number(probe.r_s));
  out.emplace_back("rᵢ", short_number(probe.r_i));
  out.emplace_back("dₛ rₛ", short_number(probe.beam));
  out.emplace_back("α", degrees(probe.alpha));
  out.emplace_back("β", degrees(probe.beta));
  out.emplace_back("d, formula", probe.lit_side ? short_number(probe.d) + " px" : "unlit side");
  out.emplace_back("m, measured", short_number(probe.size.m) + " px");
  out.emplace_back("anisotropy", short_number(probe.size.anisotropy));
  out.emplace_back("orientation", degrees(probe.size.orientation));
  return out;
}

}  // namespace psm
