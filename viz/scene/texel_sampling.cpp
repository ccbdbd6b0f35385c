// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/texel_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace psm {
namespace {

/// The part of the ray inside the body, as distances; false where it misses the body.
bool ray_inside(const ConvexBody& body, const glm::dvec3& origin, const glm::dvec3& direction, double& enter, double& leave) {
  enter = 0;
  leave = std::numeric_limits<double>::infinity();
  for (const Plane& p : body.planes) {
    const double at = glm::dot(p, glm::dvec4(origin, 1)), slope = glm::dot(glm::dvec3(p), direction);
    if (slope > 0) enter = std::max(enter, -at / slope);
    if (slope < 0) leave = std::min(leave, -at / slope);
    if (slope == 0 && at < 0) return false;
  }
  return enter <= leave && std::isfinite(leave);
}

/// The one of six maps that looks the point's way: it has the largest w there.
const glm::dmat4& map_of(const std::array<glm::dmat4, 6>& maps, const glm::dvec3& position) {
  const auto w = [&](const glm::dmat4& map) { return glm::dot(row(map, 3), glm::dvec4(position, 1)); };
  return *std::max_element(maps.begin(), maps.end(), [&](const auto& a, const auto& b) { return w(a) < w(b); });
}

TexelFootprint<double> footprint_in(const glm::dmat4& map_from_world, const Analysis& analysis, const SurfacePoint& p,
                                    glm::ivec2 pixels) {
  return texel_footprint<double>(analysis.clip_from_world(), map_from_world, p.position, p.normal, pixels.x, pixels.y,
                                 analysis.experiment.shadow.resolution);
}

glm::ivec2 pixels_of(const Analysis& analysis) { return {analysis.experiment.image.width, analysis.experiment.image.height}; }

}  // namespace

TexelFootprint<double> footprint_at(const Analysis& analysis, const SurfacePoint& point) {
  return footprint_at(analysis, point, pixels_of(analysis));
}

TexelFootprint<double> footprint_at(const Analysis& analysis, const SurfacePoint& point, glm::ivec2 pixels) {
  const glm::dmat4& map =
      analysis.map_from_world ? *analysis.map_from_world : map_of(*analysis.cube_maps_from_world, point.position);
  return footprint_in(map, analysis, point, pixels);
}

std::vector<SurfacePoint> sample_receivers(const ViewFrame& view, const Analysis& analysis) {
  constexpr int columns = 16, rows = 9;
  std::vector<SurfacePoint> points;
  for (int i = 0; i < columns * rows; ++i) {
    const double x = (2.0 * (i % columns) + 1) / columns - 1, y = (2.0 * (i / columns) + 1) / rows - 1;
    const glm::dvec3 direction = view.at(x, y, 1) - view.eye;
    double enter = 0, leave = 0;
    if (!ray_inside(analysis.receivers_body, view.eye, direction, enter, leave)) continue;
    for (const double t : {enter, (enter + leave) / 2, leave}) {
      const glm::dvec3 p = view.eye + t * direction;
      const glm::dvec3 to_light = safe_normalize(glm::dvec3(analysis.light) - analysis.light.w * p);
      points.push_back({p, safe_normalize(to_light - safe_normalize(direction))});
    }
  }
  return points;
}

double texel_percentile(std::span<const SurfacePoint> points, const glm::dmat4& map_from_world, const Analysis& analysis,
                        double fraction) {
  std::vector<double> m;
  m.reserve(points.size());
  for (const SurfacePoint& p : points) m.push_back(footprint_in(map_from_world, analysis, p, pixels_of(analysis)).m);
  const auto at = m.begin() + std::ptrdiff_t(fraction * double(m.size() - 1));
  std::nth_element(m.begin(), at, m.end());
  return *at;
}

}  // namespace psm
