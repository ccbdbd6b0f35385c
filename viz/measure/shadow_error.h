// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of a shadow map: its verdicts against ray-traced hard shadows, pixel by pixel, each error with its cause.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "measure/visible_image.h"

namespace psm {

/// The truth at a pixel. `away`: the triangle faces away from the light or lies outside a spot's cone, dark without any map.
enum class Lit : std::uint8_t { unseen, away, dark, lit };

/// What the eye pass read in the shadow map at a pixel.
enum class MapVerdict : std::uint8_t { unseen, dark, lit, outside };

/// The same for an image. `lit`: the fraction of the filter's comparisons that are lit, 0 or 1 without a filter, 1 outside the
/// map; from half on the verdict is lit.
struct MapReading {
  std::vector<MapVerdict> verdicts;
  std::vector<float> lit;
};

/// Why map and truth differ at a pixel, in the order of the questions: outside the map; else within that pixel's own m (at least
/// one pixel) of a place where the truth changes: resolution; else dark in the map only: acne; else lit in the map only: leak.
enum class ErrorCause : std::uint8_t { none, outside, resolution, acne, leak };

/// The fraction of the light that each point sees (visible_fraction): rows top to bottom, as long as the image; negative where
/// nothing is seen, or where the surface faces away from the light's centre or is outside a spot's cone.
std::vector<float> trace_fractions(const RayTracer& tracer, const VisibleImage& image, const Experiment& experiment);

/// The truth: lit where half of the light or more is seen.
std::vector<Lit> lit_by_half(const VisibleImage& image, const std::vector<float>& fractions);
std::vector<Lit> trace_light(const RayTracer& tracer, const VisibleImage& image, const Experiment& experiment);

/// The mean absolute difference between the fraction that is seen and the one that the map says, over the pixels that have both;
/// nothing where there are none.
std::optional<double> lit_difference(const std::vector<float>& fractions, const MapReading& map);

/// m in pixels of the image's own size, for every pixel in the light or in a shadow; 0 where nothing is seen, where the surface
/// faces away from the light, and outside a spot's cone; infinite where the surface holds the light ray.
std::vector<float> texel_sizes(const VisibleImage& image, const Analysis& analysis);

/// Over the pixels with m > 0; nothing where there are none. An infinite m counts as undersampled and as the largest.
std::optional<TexelStatistics> texel_statistics(const std::vector<float>& m);

/// The same over points that the eye sees, such as visible_points(): those that face the light and lie in its cone.
std::optional<TexelStatistics> texel_statistics(const std::vector<SurfacePoint>& visible, const Analysis& analysis);

/// analyze() with those statistics over the points that it is given itself: what is shown live.
Analysis analyze_with_statistics(const Experiment& experiment, const Scene& scene, const RayTracer& tracer);

/// Pixels that the truth calls dark or lit are compared; `verdicts` are what the shadow map said at the same pixels.
std::vector<ErrorCause> find_errors(const std::vector<Lit>& truth, const std::vector<MapVerdict>& verdicts,
                                    const std::vector<float>& m, int width, int height);

struct ShadowError {
  std::size_t compared = 0, wrongly_lit = 0, wrongly_dark = 0;  // pixels
  std::array<std::size_t, 5> by_cause{};                        // indexed by ErrorCause
  double fraction() const { return compared ? double(wrongly_lit + wrongly_dark) / double(compared) : 0.0; }
};
ShadowError count_errors(const std::vector<Lit>& truth, const std::vector<ErrorCause>& errors);

}  // namespace psm
