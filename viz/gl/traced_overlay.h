// SPDX-License-Identifier: GPL-3.0-or-later
// Overlays of the eye view that take rays: errors against the truth, and how much of the light each point sees.
#pragma once

#include "draw/view.h"
#include "gl/renderer.h"
#include "measure/ray_tracer.h"

namespace psm {

bool takes_rays(EyeOverlay overlay);

/// The eye's image, opaque where it sees something, and what its colours mean.
struct TracedOverlay {
  Image image;
  Legend legend;
};

/// The analysis' own overlay, at the size of its image, or as much smaller as it takes for `most_pixels`. The shadow map
/// of this analysis is what `renderer` drew last.
TracedOverlay trace_overlay(Renderer& renderer, const RayTracer& tracer, const Analysis& analysis, double most_pixels);

/// What a file takes; and the window, tens of milliseconds: larger pixels where the light has an extent and takes many rays.
constexpr double kAllPixels = 1920.0 * 1080.0;
double quick_pixels(const LightSettings& light);

/// Over the eye view, with its legend.
void show_overlay(ViewPicture& eye, const TracedOverlay& overlay);

/// In the legend's place until the rays are traced.
void announce_overlay(ViewPicture& eye);

// ---- for those who make overlays ----

/// The image's size within the limit.
glm::ivec2 traced_size(const Experiment& experiment, double most_pixels);
/// "640 x 360 (reduced)".
std::string traced_size_text(const Image& image, bool reduced);
/// "1.5 %".
std::string percent_text(double fraction);
std::string percent_text(std::size_t part, std::size_t whole);

}  // namespace psm
