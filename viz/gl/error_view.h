// SPDX-License-Identifier: GPL-3.0-or-later
// The eye's image as the difference between the shadow map's verdicts and ray-traced truth: greys where they agree, a colour for
// each cause where they do not.
#pragma once

#include <array>

#include "gl/renderer.h"
#include "measure/ray_tracer.h"
#include "measure/shadow_error.h"

namespace psm {

/// Warm colours are wrongly lit, cool ones wrongly dark. Only too few texels do both.
enum class ErrorKind { resolution_lit, resolution_dark, leak, outside, acne };
constexpr std::size_t kErrorKinds = 5;

struct ErrorView {
  Image image;
  ShadowError errors;
  std::array<std::size_t, kErrorKinds> by_kind{};  // pixels
  bool reduced = false;                            // smaller than the experiment's image
};

/// At the size of the experiment's image, or as much smaller as it takes for `most_pixels`. The shadow map of this analysis is
/// what `renderer` drew last.
ErrorView compare_with_truth(Renderer& renderer, const RayTracer& tracer, const Analysis& analysis, double most_pixels);

/// What the error view shows in the window, tens of milliseconds; and in a file.
constexpr double kQuickPixels = 640.0 * 360.0, kAllPixels = 1920.0 * 1080.0;

/// Over the eye view, with its legend.
void show_errors(ViewPicture& eye, const ErrorView& view);

/// In the legend's place until the errors are known.
void announce_errors(ViewPicture& eye);

}  // namespace psm
