// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/visible_image.h"

#include <cmath>

#include "measure/parallel_rows.h"
#include "scene/eye_and_light.h"

namespace psm {

VisibleImage see(const RayTracer& tracer, const Experiment& experiment, int width, int height) {
  const ViewFrame view = camera_frame(experiment);
  VisibleImage image{width, height, std::vector<SurfacePoint>(std::size_t(width) * std::size_t(height))};
  for_each_row(height, [&](int row) {
    const double y = 1 - (2.0 * row + 1) / height;
    for (int column = 0; column < width; ++column) {
      // Of depth 1, so that distances along it are depths.
      const double x = (2.0 * column + 1) / width - 1;
      const glm::dvec3 direction = view.forward + x * view.tan_x * view.right + y * view.tan_y * view.up;
      const auto hit = tracer.nearest(view.eye, direction, experiment.camera.near, experiment.camera.far);
      if (hit) image.points[std::size_t(row) * std::size_t(width) + std::size_t(column)] = hit->point;
    }
  });
  return image;
}

std::vector<SurfacePoint> visible_points(const RayTracer& tracer, const Experiment& experiment) {
  std::vector<SurfacePoint> points = see(tracer, experiment, kVisibleColumns, kVisibleRows).points;
  std::erase_if(points, [](const SurfacePoint& p) { return p.normal == glm::dvec3(0.0); });
  return points;
}

Analysis analyze(const Experiment& experiment, const Scene& scene, const RayTracer& tracer) {
  return analyze(experiment, scene, visible_points(tracer, experiment));
}

}  // namespace psm
