// SPDX-License-Identifier: GPL-3.0-or-later
// What lies under a pixel or a texel, by ray.
#pragma once

#include <optional>

#include "measure/ray_tracer.h"

namespace psm {

struct Pick {
  SurfacePoint receiver;               // normal on the side that was pointed at
  std::optional<glm::dvec3> occluder;  // the surface nearest to the light on the same light ray, where it is another one
  bool seen = false;                   // by the eye: inside the frustum, with nothing before it
};

/// The first surface on the ray at distances in [from, to], in lengths of `direction`.
std::optional<Pick> pick_ray(const RayTracer& tracer, const Analysis& analysis, const glm::dvec3& origin,
                             const glm::dvec3& direction, double from, double to);

/// Of the eye's image, from its top left; nothing outside it.
std::optional<Pick> pick_pixel(const RayTracer& tracer, const Analysis& analysis, const glm::dvec2& pixel);

/// Along the light ray of a point of a map (clip coordinates of layer 0, or of one of six): the first surface that the eye sees
/// and that faces the light; where there is none, the first surface.
std::optional<Pick> pick_texel(const RayTracer& tracer, const Analysis& analysis, int layer, const glm::dvec2& at);

}  // namespace psm
