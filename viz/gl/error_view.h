// SPDX-License-Identifier: GPL-3.0-or-later
// The eye's image as the difference between the shadow map's verdicts and ray-traced truth: greys where they agree, a colour for
// each cause where they do not.
#pragma once

#include <array>

#include "draw/legend.h"
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
  std::optional<double> lit_difference;            // mean, of the lit fraction
  bool reduced = false;                            // smaller than the experiment's image
};

/// At the size of the experiment's image, or as much smaller as it takes for `most_pixels`. The shadow map of this
/// analysis is what `renderer` drew last.
ErrorView compare_with_truth(Renderer& renderer, const RayTracer& tracer, const Analysis& analysis, double most_pixels);

Legend error_legend(const ErrorView& view);

}  // namespace psm
