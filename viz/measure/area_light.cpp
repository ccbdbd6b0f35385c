// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/area_light.h"

#include <array>
#include <cmath>

#include "math/projective.h"
#include "scene/eye_and_light.h"

namespace psm {
namespace {

constexpr double kGoldenAngle = 2.39996322972865332;  // pi (3 - sqrt 5)

/// On the unit disc, each for an equal area (Vogel's spiral): no straight edge meets many of them at once.
const std::array<glm::dvec2, kDiscSamples>& disc_samples() {
  static const auto samples = [] {
    std::array<glm::dvec2, kDiscSamples> places;
    for (int i = 0; i < kDiscSamples; ++i) {
      const double radius = std::sqrt((i + 0.5) / kDiscSamples), angle = i * kGoldenAngle;
      places[std::size_t(i)] = radius * glm::dvec2(std::cos(angle), std::sin(angle));
    }
    return places;
  }();
  return samples;
}

}  // namespace

double visible_fraction(const RayTracer& tracer, const SurfacePoint& point, const LightSettings& light) {
  glm::dvec4 centre = homogeneous_light(light);
  if (!(light.radius > 0)) return tracer.shadowed(point, centre) ? 0.0 : 1.0;
  if (centre.w == 0) centre = glm::dvec4(safe_normalize(glm::dvec3(centre)), 0);
  const glm::dvec3 to_light = safe_normalize(glm::dvec3(centre) - centre.w * point.position);
  const glm::dvec3 across = light.radius * perpendicular(to_light), along = glm::cross(to_light, across);
  int seen = 0;
  for (const glm::dvec2& place : disc_samples()) {
    const glm::dvec4 sample = centre + glm::dvec4(place.x * across + place.y * along, 0);
    seen += faces_light(point.position, point.normal, sample) && !tracer.shadowed(point, sample);
  }
  return double(seen) / kDiscSamples;
}

}  // namespace psm
