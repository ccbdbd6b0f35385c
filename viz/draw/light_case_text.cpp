// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "draw/sketch.h"

namespace psm {
namespace {

std::string half_texel_text(const LightCase& c, int resolution) {
  return "directional (within half a texel: |kappa| = " + short_number(std::abs(c.kappa), 2) +
         " < 1/(2N) = " + short_number(0.5 / resolution, 2) + ")";
}

std::string order_text(const LightCase& c) { return c.reversed_order ? "naive depth order reversed" : "naive depth order kept"; }

/// What the light is in the world and, where that differs, what it is after projection.
std::string post_text(const LightCase& c, LightType world) {
  const bool sun = world == LightType::directional;
  const std::string w = short_number(c.w, 2);
  switch (c.post) {
    case PostLight::directional:
      return std::string(sun ? "" : "point light \u2192 ") + "directional light  w = 0";
    case PostLight::point:
      return std::string(sun ? "directional light \u2192 " : "") + "point light  w = " + w + " > 0";
    case PostLight::inverted_point:
      return std::string(sun ? "directional light \u2192 " : "point light \u2192 ") + "inverted point light  w = " + w + " < 0";
  }
  return {};
}

}  // namespace

std::string light_case_text(const Analysis& analysis) {
  const LightCase& c = analysis.light_case;
  const bool nearly_directional = c.within_half_texel && c.post != PostLight::directional;
  std::string text = nearly_directional ? half_texel_text(c, analysis.experiment.shadow.resolution)
                                        : post_text(c, analysis.experiment.light.type) + "  " + order_text(c);
  if (c.inside_receivers) text += "  light inside R: six maps";
  return text;
}

std::string short_light_case_text(const Analysis& analysis) {
  const LightCase& c = analysis.light_case;
  const bool point = c.post == PostLight::point, directional = c.post == PostLight::directional || c.within_half_texel;
  return std::string(directional ? "directional light"
                     : point     ? "point light"
                                 : "inverted point light") +
         "  w = " + short_number(c.w, 2);
}

}  // namespace psm
