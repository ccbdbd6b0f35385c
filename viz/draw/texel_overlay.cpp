// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/texel_overlay.h"

#include <algorithm>
#include <cmath>

#include "draw/sketch.h"
#include "scene/eye_and_light.h"
#include "scene/texel_sampling.h"
#include "scene/visible_receivers.h"

namespace psm {
namespace {

constexpr double kLineSpacing = 12.0;  // pixels

glm::vec3 rgb(unsigned hex) { return glm::vec3((hex >> 16) & 255, (hex >> 8) & 255, hex & 255) / 255.0f; }

std::string power_of_two(int exponent) {
  return exponent < 0 ? "1/" + std::to_string(1 << -exponent) : std::to_string(1 << exponent);
}

/// "<1/4", "1/4–1/2", ">16".
std::string band_text(const HeatScale& scale, std::size_t band) {
  const int low = scale.first_bound + int(band) - 1;
  if (band == 0) return "<" + power_of_two(low + 1);
  if (band + 1 == scale.colors.size()) return ">" + power_of_two(low);
  return power_of_two(low) + "–" + power_of_two(low + 1);
}

/// Of a power of two: "texel", "2nd texel", "512th texel".
std::string ordinal(int n) {
  if (n == 1) return "texel";
  return std::to_string(n) + (n % 10 == 2 && n % 100 != 12 ? "nd" : "th") + " texel";
}

std::string statistics_text(const TexelStatistics& t) {
  return "p50 " + short_number(t.m_p50) + "  p95 " + short_number(t.m_p95) + "  max " + short_number(t.m_max) +
         "  m > 1: " + short_number(100.0 * t.undersampled_fraction) + " %";
}

/// Stand-ins for visible surfaces: where view rays leave R through the scene's bounds, on the side that the light reaches.
std::vector<SurfacePoint> receivers(const Analysis& a) {
  const ViewFrame view = camera_frame(a.experiment);
  std::vector<SurfacePoint> points = face_points(view, a);
  return points.empty() ? sample_receivers(view, a) : points;
}

/// How far neighbouring lines between texels are apart on the picture; the geometric mean of the two directions.
std::vector<double> line_spacings(const Analysis& a, const glm::dmat4& clip_from_world, glm::ivec2 size) {
  std::vector<double> spacings;
  for (const SurfacePoint& p : receivers(a)) {
    const glm::dvec4 clip = clip_from_world * at(p.position);
    const auto map = map_at(a, p.position);
    if (!map || !(clip.w > 0.0) || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w) continue;
    const double area = texel_footprint<double>(clip_from_world, map->map_from_world, p.position, p.normal, size.x, size.y,
                                                a.experiment.shadow.resolution)
                            .area;
    if (std::isfinite(area) && area > 0.0) spacings.push_back(std::sqrt(area));
  }
  return spacings;
}

}  // namespace

const HeatScale* heat_scale(EyeOverlay overlay) {
  static const HeatScale size{
      -2,
      0,
      {rgb(0x00304D), rgb(0x0072B2), rgb(0x9CD0EE), rgb(0xFBD9B8), rgb(0xF0A35C), rgb(0xD55E00), rgb(0x943F00), rgb(0x4F2000)}};
  static const HeatScale anisotropy{1, 1000, {rgb(0xF4E6EE), rgb(0xDDA9C5), rgb(0xBF6597), rgb(0x853D66), rgb(0x471C35)}};
  if (overlay == EyeOverlay::texel_size) return &size;
  return overlay == EyeOverlay::anisotropy ? &anisotropy : nullptr;
}

Legend heat_legend(EyeOverlay overlay, const Analysis& analysis) {
  const HeatScale& scale = *heat_scale(overlay);
  Legend legend;
  const bool size = overlay == EyeOverlay::texel_size;
  legend.title = size ? "texel size m, pixels; hatched: m > 1" : "anisotropy: largest by smallest extent";
  for (std::size_t i = 0; i < scale.colors.size(); ++i)
    legend.entries.push_back({scale.colors[i], band_text(scale, i), scale.hatched(i)});
  legend.entries.push_back({kNoTexelColor, "unlit"});
  if (size && analysis.texels) legend.lines.push_back(statistics_text(*analysis.texels));
  return legend;
}

int readable_texel_step(const Analysis& analysis, const glm::dmat4& clip_from_world, glm::ivec2 size, double fraction) {
  if (analysis.receivers_body.empty()) return 0;
  std::vector<double> spacings = line_spacings(analysis, clip_from_world, size);
  if (spacings.empty()) return 0;
  const auto chosen = spacings.begin() + std::ptrdiff_t(fraction * double(spacings.size() - 1));
  std::nth_element(spacings.begin(), chosen, spacings.end());
  const double most = std::max(1.0, std::floor(std::log2(analysis.experiment.shadow.resolution)) - 1.0);
  return 1 << int(std::clamp(std::ceil(std::log2(kLineSpacing / *chosen)), 0.0, most));
}

void add_texel_overlay(ViewPicture& picture, const Analysis& analysis, glm::ivec2 size) {
  const ViewSettings& view = analysis.experiment.view;
  if (picture.id == ViewId::eye && heat_scale(view.eye_overlay)) {
    picture.overlay = view.eye_overlay;
    picture.legend = heat_legend(view.eye_overlay, analysis);
  }
  const bool shows_receivers = picture.scene == ScenePicture::shadowed || picture.scene == ScenePicture::projective;
  if (!view.texel_grid || !shows_receivers) return;
  picture.texel_step = readable_texel_step(analysis, picture.clip_from_world, size, picture.id == ViewId::eye ? 0.5 : 0.75);
  if (picture.texel_step == 0) return;
  std::string text = "grid: every " + ordinal(picture.texel_step);
  const int strong = picture.texel_step * kStrongLines;
  if (strong < analysis.experiment.shadow.resolution) text += ", strong: every " + ordinal(strong);
  picture.legend.lines.push_back(std::move(text));
}

}  // namespace psm
