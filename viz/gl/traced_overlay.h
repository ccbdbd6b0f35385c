// SPDX-License-Identifier: GPL-3.0-or-later
// The overlays of the eye view that take rays, traced: errors against the truth, and how much of the light each point sees.
#pragma once

#include "draw/view.h"
#include "gl/renderer.h"
#include "measure/ray_tracer.h"

namespace psm {

/// The analysis' own overlay, at the size of its image, or as much smaller as it takes for `most_pixels`. The shadow map
/// of this analysis is what `renderer` drew last.
TracedOverlay trace_overlay(Renderer& renderer, const RayTracer& tracer, const Analysis& analysis, double most_pixels);

/// What a file takes; and the window, tens of milliseconds: larger pixels where the light has an extent and takes many rays.
constexpr double kAllPixels = 1920.0 * 1080.0;
double quick_pixels(const LightSettings& light);

// ---- for those who make overlays ----

/// The image's size within the limit.
glm::ivec2 traced_size(const Experiment& experiment, double most_pixels);
/// "640 x 360 (reduced)".
std::string traced_size_text(const Image& image, bool reduced);
/// "1.5 %".
std::string percent_text(double fraction);
std::string percent_text(std::size_t part, std::size_t whole);

}  // namespace psm
