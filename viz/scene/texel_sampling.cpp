// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/texel_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace psm {
namespace {

/// The part of a ray inside a body, as distances, and the plane through which it leaves.
struct Passage {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  const Plane* exit = nullptr;
  explicit operator bool() const { return exit && enter <= leave; }
};

Passage pass_through(const ConvexBody& body, const glm::dvec3& origin, const glm::dvec3& along) {
  Passage out;
  for (const Plane& p : body.planes) {
    const double at = glm::dot(p, glm::dvec4(origin, 1)), slope = glm::dot(glm::dvec3(p), along);
    if (slope > 0) out.enter = std::max(out.enter, -at / slope);
    if (slope == 0 && at < 0) return {};
    if (slope < 0 && -at / slope < out.leave) {
      out.leave = -at / slope;
      out.exit = &p;
    }
  }
  return out;
}

bool bounds_scene(const Plane& p) {
  const bool side_of_box = p.id >= PlaneId::min_x && p.id <= PlaneId::max_z;
  return side_of_box || p.id == PlaneId::given;
}

TexelFootprint<double> footprint_in(const glm::dmat4& map_from_world, const Analysis& analysis, const SurfacePoint& p,
                                    glm::ivec2 pixels) {
  return texel_footprint<double>(analysis.clip_from_world(), map_from_world, p.position, p.normal, pixels.x, pixels.y,
                                 analysis.experiment.shadow.resolution);
}

glm::ivec2 pixels_of(const Analysis& analysis) { return {analysis.experiment.image.width, analysis.experiment.image.height}; }

}  // namespace

std::optional<MapAt> map_at(const Analysis& analysis, const glm::dvec3& position) {
  if (analysis.map_from_world) return MapAt{0, *analysis.map_from_world};
  if (!analysis.cube_maps_from_world) return std::nullopt;
  // Of the six, the one whose w is largest there.
  const auto& maps = *analysis.cube_maps_from_world;
  const auto w = [&](const glm::dmat4& map) { return glm::dot(row(map, 3), glm::dvec4(position, 1)); };
  const auto best = std::max_element(maps.begin(), maps.end(), [&](const auto& a, const auto& b) { return w(a) < w(b); });
  return MapAt{int(best - maps.begin()), *best};
}

TexelFootprint<double> footprint_at(const Analysis& analysis, const SurfacePoint& point) {
  return footprint_at(analysis, point, pixels_of(analysis));
}

TexelFootprint<double> footprint_at(const Analysis& analysis, const SurfacePoint& point, glm::ivec2 pixels) {
  return footprint_in(map_at(analysis, point.position)->map_from_world, analysis, point, pixels);
}

std::vector<SurfacePoint> sample_receivers(const ViewFrame& view, const Analysis& analysis) {
  constexpr int columns = 8, rows = 5;
  std::vector<SurfacePoint> points;
  for (int i = 0; i < columns * rows; ++i) {
    const double x = (2.0 * (i % columns) + 1) / columns - 1, y = (2.0 * (i / columns) + 1) / rows - 1;
    const glm::dvec3 direction = view.at(x, y, 1) - view.eye;
    const Passage inside = pass_through(analysis.receivers_body, view.eye, direction);
    if (!inside) continue;
    for (const double t : {inside.enter, (inside.enter + inside.leave) / 2, inside.leave}) {
      const glm::dvec3 p = view.eye + t * direction;
      const glm::dvec3 to_light = safe_normalize(glm::dvec3(analysis.light) - analysis.light.w * p);
      points.push_back({p, safe_normalize(to_light - safe_normalize(direction))});
    }
  }
  return points;
}

std::optional<SurfacePoint> far_side(const ConvexBody& body, const glm::dvec3& origin, const glm::dvec3& along) {
  const Passage inside = pass_through(body, origin, along);
  if (!inside || !bounds_scene(*inside.exit)) return std::nullopt;
  return SurfacePoint{origin + inside.leave * along, safe_normalize(glm::dvec3(*inside.exit))};
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
