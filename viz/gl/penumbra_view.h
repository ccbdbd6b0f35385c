// SPDX-License-Identifier: GPL-3.0-or-later
// The eye's image as the part of the light that each point sees: umbra, penumbra, lit.
#pragma once

#include "gl/traced_overlay.h"

namespace psm {

TracedOverlay trace_penumbra(const RayTracer& tracer, const Experiment& experiment, double most_pixels);

}  // namespace psm
