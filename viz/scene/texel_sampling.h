// SPDX-License-Identifier: GPL-3.0-or-later
// Texel sizes on surfaces; and, where nobody has visible points, stand-ins for them: small surfaces all through R that face eye
// and light alike, seen through a coarse grid of pixels.
#pragma once

#include <optional>
#include <vector>

#include "geom/frustum.h"
#include "math/texel_footprint.h"
#include "scene/analysis.h"

namespace psm {

/// Along each of 8 x 5 view rays three points of R: where it enters, the middle, where it leaves. Normals halve the angle
/// between the directions to the eye and to the light.
std::vector<SurfacePoint> sample_receivers(const ViewFrame& view, const Analysis& analysis);

/// The map that answers for a point: the single one, the first of two, or that one of six that looks the point's way.
struct MapAt {
  int layer = 0;
  glm::dmat4 map_from_world{1.0};
};
/// Nothing where the analysis has no map.
std::optional<MapAt> map_at(const Analysis& analysis, const glm::dvec3& position);

/// The footprint of the texel at a surface point, in pixels of an image of `pixels` (the experiment's own, unless given): of the
/// single map, or of that one of the six that the point lies in.
TexelFootprint<double> footprint_at(const Analysis& analysis, const SurfacePoint& point);
TexelFootprint<double> footprint_at(const Analysis& analysis, const SurfacePoint& point, glm::ivec2 pixels);

/// Rays from one place (outside or inside) through a convex body, which must outlive this.
class RaysFrom {
 public:
  RaysFrom(const ConvexBody& body, const glm::dvec3& origin);

  /// The part of the ray inside the body, in multiples of `along`, and the plane through which it leaves; null where it misses.
  struct Passage {
    double enter = 0, leave = 0;
    const Plane* exit = nullptr;
  };
  Passage pass(const glm::dvec3& along) const;

  /// Where the ray leaves the body, with the normal of the face there, inwards; nothing where it misses the body or leaves it
  /// through a face of V rather than of S.
  std::optional<SurfacePoint> far_side(const glm::dvec3& along) const;

 private:
  const ConvexBody& body_;
  glm::dvec3 origin_;
  std::vector<double> heights_;  // of the origin over the planes
};

/// Percentile (0 to 1) of the texel size m in pixels over the points; infinite where the receiver holds the light ray.
double texel_percentile(std::span<const SurfacePoint> points, const glm::dmat4& map_from_world, const Analysis& analysis,
                        double fraction);

}  // namespace psm
