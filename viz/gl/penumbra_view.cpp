// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/penumbra_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "measure/shadow_error.h"

namespace psm {
namespace {

// sRGB. Umbra and lit stand apart from the penumbra's orange by hue and by tone; in it, tone follows the light that is seen.
constexpr glm::vec3 kUmbra{0.13f, 0.19f, 0.33f}, kDarkest{0.52f, 0.26f, 0.02f}, kBrightest{1.0f, 0.85f, 0.55f},
    kLit{0.93f, 0.93f, 0.90f}, kAway{0.42f};

glm::vec3 color_of(float fraction) {
  if (fraction < 0) return kAway;
  if (fraction == 0) return kUmbra;
  return fraction == 1 ? kLit : glm::mix(kDarkest, kBrightest, fraction);
}

struct Counts {
  std::size_t umbra = 0, penumbra = 0, lit = 0;
  std::size_t all() const { return umbra + penumbra + lit; }
};

Counts count(const std::vector<float>& fractions) {
  Counts counts;
  for (const float f : fractions)
    if (f >= 0) ++(f == 0 ? counts.umbra : f == 1 ? counts.lit : counts.penumbra);
  return counts;
}

Legend legend_of(const Counts& counts, const LightSettings& light, const std::string& size) {
  Legend legend;
  legend.title = "light that is seen, " + size;
  const auto share = [&](std::size_t part) { return ": " + percent_text(part, counts.all()); };
  legend.entries = {{kUmbra, "umbra" + share(counts.umbra)},
                    {color_of(0.25f), "penumbra" + share(counts.penumbra) + "; 1/4"},
                    {color_of(0.5f), "1/2"},
                    {color_of(0.75f), "3/4 of the light"},
                    {kLit, "lit" + share(counts.lit)},
                    {kAway, "faces away"}};
  if (!(light.radius > 0)) legend.lines.push_back("light.radius is 0: a point of light has no penumbra");
  return legend;
}

}  // namespace

TracedOverlay trace_penumbra(const RayTracer& tracer, const Experiment& experiment, double most_pixels) {
  const glm::ivec2 size = traced_size(experiment, most_pixels);
  const VisibleImage seen = see(tracer, experiment, size.x, size.y);
  const std::vector<float> fractions = trace_fractions(tracer, seen, experiment);
  TracedOverlay out;
  out.image = {size.x, size.y, std::vector<std::uint8_t>(fractions.size() * 4, 0)};
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    if (!seen.sees(i)) continue;
    const glm::vec3 color = color_of(fractions[i]);
    for (int k = 0; k < 3; ++k) out.image.rgba[4 * i + std::size_t(k)] = std::uint8_t(std::lround(255.0f * color[k]));
    out.image.rgba[4 * i + 3] = 255;
  }
  const bool reduced = size != glm::ivec2(experiment.image.width, experiment.image.height);
  out.legend = legend_of(count(fractions), experiment.light, traced_size_text(out.image, reduced));
  return out;
}

}  // namespace psm
