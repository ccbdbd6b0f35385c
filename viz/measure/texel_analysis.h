// SPDX-License-Identifier: GPL-3.0-or-later
// An analysis with the texel statistics of every visible pixel.
#pragma once

#include "scene/analysis.h"

namespace psm {

/// What the eye sees is traced, once coarsely for the analysis itself and once at every pixel for the statistics; whether the
/// technique is worse than the uniform map is then decided by all pixels. A ray or more for each pixel of the image.
Analysis analyze_with_texels(const Experiment& experiment, const Scene& scene);

}  // namespace psm
