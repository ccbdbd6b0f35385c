// SPDX-License-Identifier: GPL-3.0-or-later
// What the eye sees, one ray through the middle of each pixel.
#pragma once

#include <vector>

#include "measure/ray_tracer.h"
#include "scene/experiment.h"

namespace psm {

/// Rows top to bottom; the normal is zero where the eye sees nothing.
struct VisibleImage {
  int width = 0, height = 0;
  std::vector<SurfacePoint> points;  // width * height
  bool sees(std::size_t pixel) const { return points[pixel].normal != glm::dvec3(0.0); }
};

/// The experiment's camera between its near and far distance, at width x height pixels.
VisibleImage see(const RayTracer& tracer, const Experiment& experiment, int width, int height);

/// What analyze() takes: the coarse grid of kVisibleColumns x kVisibleRows, without the cells that see nothing.
std::vector<SurfacePoint> visible_points(const RayTracer& tracer, const Experiment& experiment);

/// analyze() with what rays see: the same for the window, for pictures and for numbers.
Analysis analyze(const Experiment& experiment, const Scene& scene, const RayTracer& tracer);

}  // namespace psm
