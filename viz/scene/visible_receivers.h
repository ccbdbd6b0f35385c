// SPDX-License-Identifier: GPL-3.0-or-later
// What visible points say about the receivers; private to viz/scene.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geom/frustum.h"
#include "math/shadow_map.h"
#include "scene/analysis.h"

namespace psm {

/// Those that a map has to serve: their surface faces the light, and they lie in L. The others are dark without any map.
std::vector<SurfacePoint> points_to_serve(std::span<const SurfacePoint> visible, const glm::dvec4& light,
                                          const ConvexBody& receivers);

/// The part of R that the points, one in each cell of the image, stand for: R between planes along the world's axes, the view and
/// the map's window. R itself where nothing would be left.
ConvexBody visible_part(const ConvexBody& receivers, const ViewFrame& view, const LightFrame<double>& frame,
                        std::span<const SurfacePoint> points);

/// Stand-ins where nobody has visible points: the far faces of R that S bounds, seen from inside, where they face the light; on
/// the coarse grid of visible points, or a coarser one, by this factor along both sides.
std::vector<SurfacePoint> face_points(const ViewFrame& view, const Analysis& analysis, int coarser = 1);

/// The plane (unit normal on the visible side, distance) that most of the points lie on, within a degree and a ten-thousandth of
/// their extent.
std::optional<glm::dvec4> largest_flat_area(std::span<const SurfacePoint> points);

}  // namespace psm
