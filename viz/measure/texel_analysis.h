// SPDX-License-Identifier: GPL-3.0-or-later
// An analysis with the texel statistics of every visible pixel.
#pragma once

#include "measure/visible_image.h"
#include "scene/analysis.h"

namespace psm {

/// The statistics of this analysis over every pixel of the image in place of those over a coarse grid, or none; they decide, too,
/// whether the technique is worse than the uniform map. `tracer`: of the scene; `image`: what the experiment's camera sees.
void count_texels(Analysis& analysis, const Scene& scene, const RayTracer& tracer, const VisibleImage& image);

/// An analysis with them.
Analysis analyze_with_texels(const Experiment& experiment, const Scene& scene);

}  // namespace psm
