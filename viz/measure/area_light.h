// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a light with an extent a point sees: umbra, penumbra, or all of it.
#pragma once

#include "measure/ray_tracer.h"
#include "scene/experiment.h"

namespace psm {

/// An area light is a disc of light.radius about the light, which faces the point: in scene units, of a directional light at
/// distance 1. The part of it that the point sees, from 0 to 1, by kDiscSamples rays to places that are spread evenly over the
/// disc and the same for all points; what lies behind the point's own surface is not seen. A light without radius takes one ray.
double visible_fraction(const RayTracer& tracer, const SurfacePoint& point, const LightSettings& light);

constexpr int kDiscSamples = 32;

/// How many rays that takes.
inline int rays_to(const LightSettings& light) { return light.radius > 0 ? kDiscSamples : 1; }

}  // namespace psm
