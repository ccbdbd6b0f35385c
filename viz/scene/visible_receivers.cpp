// SPDX-License-Identifier: GPL-3.0-or-later
// What visible points say about the receivers: which of them the map has to serve, how far they reach, and which plane most lie
// on.
#include "scene/visible_receivers.h"

#include <algorithm>
#include <cmath>

#include "scene/eye_and_light.h"
#include "scene/texel_sampling.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4;

bool in_light(const SurfacePoint& p, const ConvexBody& receivers) {
  return std::all_of(receivers.planes.begin(), receivers.planes.end(),
                     [&](const Plane& plane) { return !plane.of_light || glm::dot(plane, dvec4(p.position, 1)) >= 0; });
}

/// The corners of the patch that the point stands for: its cell of the image, on its tangent plane, no nearer than half and no
/// farther than twice the point's depth.
void add_patch(const ViewFrame& view, const SurfacePoint& p, std::vector<dvec3>& corners) {
  const double depth = view.depth(p.position), height = glm::dot(p.normal, p.position - view.eye);
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const dvec3 along = (p.position - view.eye) / depth + (x * view.tan_x / kVisibleColumns) * view.right +
                          (y * view.tan_y / kVisibleRows) * view.up;
      const double slope = glm::dot(p.normal, along);
      const double t = slope < 0 ? height / slope : 2 * depth;
      corners.push_back(view.eye + std::clamp(t, depth / 2, 2 * depth) * along);
    }
}

}  // namespace

std::vector<SurfacePoint> points_to_serve(std::span<const SurfacePoint> visible, const dvec4& light,
                                          const ConvexBody& receivers) {
  std::vector<SurfacePoint> out;
  for (const SurfacePoint& p : visible)
    if (faces_light(p.position, p.normal, light) && in_light(p, receivers)) out.push_back(p);
  return out;
}

ConvexBody visible_part(const ConvexBody& receivers, const ViewFrame& view, const LightFrame<double>& frame,
                        std::span<const SurfacePoint> points) {
  std::vector<dvec3> corners;
  corners.reserve(4 * points.size());
  for (const SurfacePoint& p : points) add_patch(view, p, corners);
  std::vector<dvec3> directions{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, view.forward};
  if (frame.light.w == 0) directions.insert(directions.end(), {dvec3(frame.a), dvec3(frame.b)});
  std::vector<Plane> slabs;
  for (const dvec3& d : directions) {
    const Range<double> r = value_range<double>(dvec4(d, 0), corners);
    const double rounding = 1e-7 * std::max({r.size(), std::abs(r.min), std::abs(r.max)});
    slabs.push_back(Plane(d, rounding - r.min));
    slabs.push_back(Plane(-d, rounding + r.max));
  }
  ConvexBody part = clip(receivers, slabs);
  return part.empty() ? receivers : part;
}

std::vector<SurfacePoint> face_points(const ViewFrame& view, const Analysis& analysis, int coarser) {
  const int columns = kVisibleColumns / coarser, rows = kVisibleRows / coarser;
  std::vector<SurfacePoint> points;
  const RaysFrom rays(analysis.receivers_body, view.eye);
  for (int i = 0; i < columns * rows; ++i) {
    const dvec3 along = view.at((2.0 * (i % columns) + 1) / columns - 1, (2.0 * (i / columns) + 1) / rows - 1, 1) - view.eye;
    if (const auto p = rays.far_side(along); p && faces_light(p->position, p->normal, analysis.light)) points.push_back(*p);
  }
  return points;
}

std::optional<dvec4> largest_flat_area(std::span<const SurfacePoint> points) {
  constexpr double cosine = 0.9998;  // one degree
  Range<double> x, y, z;
  for (const SurfacePoint& p : points) x.add(p.position.x), y.add(p.position.y), z.add(p.position.z);
  const double thickness = 1e-4 * std::max({x.size(), y.size(), z.size()});
  std::size_t most = 0;
  std::optional<dvec4> plane;
  std::vector<const SurfacePoint*> counted;  // of points in one plane, up to rounding, the first stands for all
  for (const SurfacePoint& p : points) {
    const bool known = std::any_of(counted.begin(), counted.end(), [&](const SurfacePoint* q) {
      return p.normal == q->normal && std::abs(glm::dot(p.normal, q->position - p.position)) <= 1e-6 * thickness;
    });
    if (known) continue;
    counted.push_back(&p);
    const auto on_it = [&](const SurfacePoint& q) {
      return glm::dot(p.normal, q.normal) > cosine && std::abs(glm::dot(p.normal, q.position - p.position)) <= thickness;
    };
    const auto count = std::size_t(std::count_if(points.begin(), points.end(), on_it));
    if (count <= most) continue;
    most = count;
    plane = dvec4(p.normal, -glm::dot(p.normal, p.position));
  }
  return plane;
}

}  // namespace psm
