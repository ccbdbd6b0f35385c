// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/traced_overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gl/error_view.h"
#include "gl/penumbra_view.h"
#include "measure/area_light.h"

namespace psm {

TracedOverlay trace_overlay(Renderer& renderer, const RayTracer& tracer, const Analysis& analysis, double most_pixels) {
  if (analysis.experiment.view.eye_overlay == EyeOverlay::penumbra)
    return trace_penumbra(tracer, analysis.experiment, most_pixels);
  const ErrorView errors = compare_with_truth(renderer, tracer, analysis, most_pixels);
  return {errors.image, error_legend(errors)};
}

double quick_pixels(const LightSettings& light) { return 640.0 * 360.0 / std::min(16, rays_to(light)); }

glm::ivec2 traced_size(const Experiment& experiment, double most_pixels) {
  const ImageSettings& image = experiment.image;
  const double factor = std::min(1.0, std::sqrt(most_pixels / (double(image.width) * image.height)));
  return glm::max(glm::ivec2(1), glm::ivec2(int(factor * image.width), int(factor * image.height)));
}

std::string traced_size_text(const Image& image, bool reduced) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + (reduced ? " (reduced)" : "");
}

std::string percent_text(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100.0 * fraction);
  return text;
}

std::string percent_text(std::size_t part, std::size_t whole) { return percent_text(whole ? double(part) / double(whole) : 0.0); }

}  // namespace psm
