// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/shadow_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "measure/area_light.h"
#include "measure/distance_transform.h"
#include "measure/parallel_rows.h"
#include "scene/eye_and_light.h"
#include "scene/texel_sampling.h"

namespace psm {
namespace {

/// A spot's cone, or all of space. `tangent`: of half the cone's angle, which is below 90 degrees.
bool in_cone(const LightSettings& light, double tangent, const glm::dvec3& position) {
  if (light.type != LightType::spot) return true;
  const glm::dvec3 axis = light.target - light.position, ray = position - light.position;
  return glm::length(glm::cross(axis, ray)) < tangent * glm::dot(axis, ray);
}

bool in_light(const SurfacePoint& p, const glm::dvec4& light, const Experiment& x, double tangent) {
  return faces_light(p.position, p.normal, light) && in_cone(x.light, tangent, p.position);
}

double cone_tangent(const Experiment& x) { return std::tan(x.light.cone_deg * kRadiansPerDegree / 2); }

bool compared(Lit lit) { return lit == Lit::dark || lit == Lit::lit; }

/// Squared distance in pixels from each pixel to the nearest one that has a 4-neighbour of another light; unseen pixels have
/// none.
std::vector<float> distances_to_change(const std::vector<Lit>& truth, int width, int height) {
  std::vector<float> distance(truth.size(), std::numeric_limits<float>::infinity());
  const auto meet = [&](std::size_t a, std::size_t b) {
    if (truth[a] == Lit::unseen || truth[b] == Lit::unseen || (truth[a] == Lit::lit) == (truth[b] == Lit::lit)) return;
    distance[a] = distance[b] = 0;
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
      if (x + 1 < width) meet(i, i + 1);
      if (y + 1 < height) meet(i, i + std::size_t(width));
    }
  }
  spread_squared_distances(distance, width, height);
  return distance;
}

}  // namespace

std::vector<float> trace_fractions(const RayTracer& tracer, const VisibleImage& image, const Experiment& experiment) {
  const glm::dvec4 light = homogeneous_light(experiment.light);
  const double tangent = cone_tangent(experiment);
  std::vector<float> fractions(image.points.size(), -1.0f);
  for_each_row(image.height, [&](int row) {
    const std::size_t first = std::size_t(row) * std::size_t(image.width), end = first + std::size_t(image.width);
    for (std::size_t i = first; i < end; ++i)
      if (image.sees(i) && in_light(image.points[i], light, experiment, tangent))
        fractions[i] = float(visible_fraction(tracer, image.points[i], experiment.light));
  });
  return fractions;
}

std::vector<Lit> lit_by_half(const VisibleImage& image, const std::vector<float>& fractions) {
  std::vector<Lit> truth(fractions.size(), Lit::unseen);
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (image.sees(i)) truth[i] = fractions[i] < 0 ? Lit::away : fractions[i] < 0.5f ? Lit::dark : Lit::lit;
  return truth;
}

std::vector<Lit> trace_light(const RayTracer& tracer, const VisibleImage& image, const Experiment& experiment) {
  return lit_by_half(image, trace_fractions(tracer, image, experiment));
}

std::optional<double> lit_difference(const std::vector<float>& fractions, const MapReading& map) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    if (fractions[i] < 0 || map.verdicts[i] == MapVerdict::unseen) continue;
    sum += std::abs(double(fractions[i]) - double(map.verdicts[i] == MapVerdict::outside ? 1.0f : map.lit[i]));
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / double(count);
}

std::vector<float> texel_sizes(const VisibleImage& image, const Analysis& analysis) {
  const Experiment& x = analysis.experiment;
  const glm::dvec4 light = homogeneous_light(x.light);
  const double tangent = cone_tangent(x);
  std::vector<float> m(image.points.size(), 0.0f);
  for_each_row(image.height, [&](int row) {
    const std::size_t first = std::size_t(row) * std::size_t(image.width), end = first + std::size_t(image.width);
    for (std::size_t i = first; i < end; ++i)
      if (image.sees(i) && in_light(image.points[i], light, x, tangent))
        m[i] = float(footprint_at(analysis, image.points[i], {image.width, image.height}).m);
  });
  return m;
}

std::optional<TexelStatistics> texel_statistics(const std::vector<float>& m) {
  std::vector<float> sizes;
  std::copy_if(m.begin(), m.end(), std::back_inserter(sizes), [](float size) { return size > 0; });
  if (sizes.empty()) return std::nullopt;
  const auto percentile = [&](double fraction) {
    const auto at = sizes.begin() + std::ptrdiff_t(fraction * double(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    return double(*at);
  };
  const double count = double(sizes.size());
  TexelStatistics out;
  out.m_mean = std::accumulate(sizes.begin(), sizes.end(), 0.0) / count;
  out.m_p50 = percentile(0.5);
  out.m_p95 = percentile(0.95);
  out.m_max = double(*std::max_element(sizes.begin(), sizes.end()));
  out.undersampled_fraction = double(std::count_if(sizes.begin(), sizes.end(), [](float size) { return size > 1; })) / count;
  return out;
}

std::optional<TexelStatistics> texel_statistics(const std::vector<SurfacePoint>& visible, const Analysis& analysis) {
  const Experiment& x = analysis.experiment;
  const glm::dvec4 light = homogeneous_light(x.light);
  const double tangent = cone_tangent(x);
  std::vector<float> m;
  for (const SurfacePoint& p : visible)
    if (in_light(p, light, x, tangent) && map_at(analysis, p.position)) m.push_back(float(footprint_at(analysis, p).m));
  return texel_statistics(m);
}

Analysis analyze_with_statistics(const Experiment& experiment, const Scene& scene, const RayTracer& tracer) {
  const std::vector<SurfacePoint> visible = visible_points(tracer, experiment);
  Analysis analysis = analyze(experiment, scene, visible);
  analysis.texels = texel_statistics(visible, analysis);
  return analysis;
}

std::vector<ErrorCause> find_errors(const std::vector<Lit>& truth, const std::vector<MapVerdict>& verdicts,
                                    const std::vector<float>& m, int width, int height) {
  const std::vector<float> squared = distances_to_change(truth, width, height);
  std::vector<ErrorCause> errors(truth.size(), ErrorCause::none);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!compared(truth[i]) || verdicts[i] == MapVerdict::unseen) continue;
    const bool lit_by_map = verdicts[i] != MapVerdict::dark;  // what lies outside is drawn lit
    if (lit_by_map == (truth[i] == Lit::lit)) continue;
    const double reach = std::max(1.0, double(m[i]));
    const bool near_change = std::isfinite(squared[i]) && double(squared[i]) <= reach * reach;
    errors[i] = verdicts[i] == MapVerdict::outside ? ErrorCause::outside
                : near_change                      ? ErrorCause::resolution
                : lit_by_map                       ? ErrorCause::leak
                                                   : ErrorCause::acne;
  }
  return errors;
}

ShadowError count_errors(const std::vector<Lit>& truth, const std::vector<ErrorCause>& errors) {
  ShadowError out;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (compared(truth[i])) ++out.compared;
    ++out.by_cause[std::size_t(errors[i])];
    if (errors[i] != ErrorCause::none) ++(truth[i] == Lit::dark ? out.wrongly_lit : out.wrongly_dark);
  }
  return out;
}

}  // namespace psm
