// SPDX-License-Identifier: GPL-3.0-or-later
// Where nobody has visible points yet: the lit inner sides of the scene box, seen through a coarse grid of pixels.
#pragma once

#include <vector>

#include "geom/frustum.h"
#include "scene/analysis.h"

namespace psm {

struct SurfacePoint {
  glm::dvec3 position, normal;  // world space, unit normal
};

/// At most 16 x 9 points where view rays leave S through a side that faces the light, inside R.
std::vector<SurfacePoint> sample_scene_box(const ViewFrame& view, const Analysis& analysis);

/// Percentile (0 to 1) of the texel size m in pixels over the points; infinite where the receiver holds the light ray.
double texel_percentile(const std::vector<SurfacePoint>& points, const glm::dmat4& map_from_world, const Analysis& analysis,
                        double fraction);

}  // namespace psm
