// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/texel_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace psm {
namespace {

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
  const RaysFrom rays(analysis.receivers_body, view.eye);
  for (int i = 0; i < columns * rows; ++i) {
    const double x = (2.0 * (i % columns) + 1) / columns - 1, y = (2.0 * (i / columns) + 1) / rows - 1;
    const glm::dvec3 direction = view.at(x, y, 1) - view.eye;
    const RaysFrom::Passage inside = rays.pass(direction);
    if (!inside.exit) continue;
    for (const double t : {inside.enter, (inside.enter + inside.leave) / 2, inside.leave}) {
      const glm::dvec3 p = view.eye + t * direction;
      const glm::dvec3 to_light = safe_normalize(glm::dvec3(analysis.light) - analysis.light.w * p);
      points.push_back({p, safe_normalize(to_light - safe_normalize(direction))});
    }
  }
  return points;
}

RaysFrom::RaysFrom(const ConvexBody& body, const glm::dvec3& origin) : body_(body), origin_(origin) {
  for (const Plane& p : body.planes) heights_.push_back(glm::dot(p, glm::dvec4(origin, 1)));
}

/// Distances stay fractions, height over slope, until the last of them is known: divisions are the slowest part.
RaysFrom::Passage RaysFrom::pass(const glm::dvec3& along) const {
  double enter_height = 0, enter_slope = 1, leave_height = 1, leave_slope = 0;
  const Plane* exit = nullptr;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const Plane& p = body_.planes[i];
    const double height = heights_[i], slope = glm::dot(glm::dvec3(p), along);
    if (slope == 0 && height < 0) return {};
    if (slope > 0 && -height * enter_slope > enter_height * slope) enter_height = -height, enter_slope = slope;
    if (slope < 0 && height * leave_slope < leave_height * -slope) leave_height = height, leave_slope = -slope, exit = &p;
  }
  const double enter = enter_height / enter_slope, leave = leave_height / leave_slope;
  return exit && enter <= leave ? Passage{enter, leave, exit} : Passage{};
}

std::optional<SurfacePoint> RaysFrom::far_side(const glm::dvec3& along) const {
  const Passage inside = pass(along);
  if (!inside.exit || !bounds_scene(*inside.exit)) return std::nullopt;
  return SurfacePoint{origin_ + inside.leave * along, safe_normalize(glm::dvec3(*inside.exit))};
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
