// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/texel_sampling.h"

#include <algorithm>
#include <limits>

#include "math/texel_footprint.h"

namespace psm {
namespace {

/// Distance along the ray to where it leaves the box, and the axis of that side; false where it misses the box.
bool leave_box(const ConvexBody& box, const glm::dvec3& origin, const glm::dvec3& direction, double& distance,
               glm::dvec3& inner_normal) {
  double enter = 0;
  distance = std::numeric_limits<double>::infinity();
  for (const Plane& p : box.planes) {
    const double at = glm::dot(p, glm::dvec4(origin, 1)), slope = glm::dot(glm::dvec3(p), direction);
    if (slope > 0) enter = std::max(enter, -at / slope);
    if (slope == 0 && at < 0) return false;
    if (slope < 0 && -at / slope < distance) {
      distance = -at / slope;
      inner_normal = glm::dvec3(p);
    }
  }
  return enter <= distance;
}

}  // namespace

std::vector<SurfacePoint> sample_scene_box(const ViewFrame& view, const Analysis& analysis) {
  constexpr int columns = 16, rows = 9;
  std::vector<SurfacePoint> points;
  const glm::dvec3 l(analysis.light);
  for (int i = 0; i < columns * rows; ++i) {
    const double x = (2.0 * (i % columns) + 1) / columns - 1, y = (2.0 * (i / columns) + 1) / rows - 1;
    const glm::dvec3 direction = view.at(x, y, 1) - view.eye;
    double distance = 0;
    glm::dvec3 normal(0);
    if (!leave_box(analysis.scene_body, view.eye, direction, distance, normal)) continue;
    const glm::dvec3 p = view.eye + distance * direction;
    const glm::dvec3 to_light = analysis.light.w == 0 ? l : l - p;
    if (glm::dot(normal, to_light) <= 0) continue;
    const bool in_range = distance >= *analysis.near * (1 - 1e-9) && distance <= *analysis.far * (1 + 1e-9);
    const glm::dvec4 m = *analysis.map_from_world * glm::dvec4(p, 1);
    if (in_range && std::abs(m.x) <= m.w * (1 + 1e-9) && std::abs(m.y) <= m.w * (1 + 1e-9)) points.push_back({p, normal});
  }
  return points;
}

double texel_percentile(const std::vector<SurfacePoint>& points, const glm::dmat4& map_from_world, const Analysis& analysis,
                        double fraction) {
  std::vector<double> m;
  m.reserve(points.size());
  const Experiment& x = analysis.experiment;
  const glm::dmat4 clip_from_world = analysis.clip_from_world();
  for (const SurfacePoint& p : points)
    m.push_back(texel_footprint<double>(clip_from_world, map_from_world, p.position, p.normal, x.image.width, x.image.height,
                                        x.shadow.resolution)
                    .m);
  const auto at = m.begin() + std::ptrdiff_t(fraction * double(m.size() - 1));
  std::nth_element(m.begin(), at, m.end());
  return *at;
}

}  // namespace psm
