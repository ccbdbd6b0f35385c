// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/theme.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

constexpr float kLineContrast = 3.0f, kTextContrast = 7.0f;

float decode(float s) { return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f); }
float encode(float l) { return l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1.0f / 2.4f) - 0.055f; }
glm::vec3 decode(const glm::vec3& s) { return {decode(s.r), decode(s.g), decode(s.b)}; }
glm::vec3 encode(const glm::vec3& l) { return {encode(l.r), encode(l.g), encode(l.b)}; }

float luminance(const glm::vec3& srgb) { return glm::dot(decode(srgb), glm::vec3(0.2126f, 0.7152f, 0.0722f)); }

/// Towards black on a light ground, towards white on a dark one, as little as it takes.
glm::vec3 with_contrast(const glm::vec3& color, const glm::vec3& ground, float wanted) {
  const glm::vec3 end(luminance(ground) > 0.2f ? 0.0f : 1.0f);
  constexpr int kSteps = 32;
  for (int i = 0; i < kSteps; ++i) {
    const glm::vec3 candidate = encode(glm::mix(decode(color), end, float(i) / kSteps));
    if (contrast(candidate, ground) >= wanted) return candidate;
  }
  return end;
}

}  // namespace

float contrast(const glm::vec3& a, const glm::vec3& b) {
  const float la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05f) / (std::min(la, lb) + 0.05f);
}

glm::vec3 picture_ground(Theme theme) { return theme == Theme::light ? glm::vec3(1.0f) : glm::vec3(0.118f); }
glm::vec3 picture_outside(Theme theme) { return theme == Theme::light ? glm::vec3(0.89f, 0.9f, 0.91f) : glm::vec3(0.075f); }

glm::vec3 picture_line_color(Role role, Theme theme) {
  return with_contrast(theme == Theme::light ? role_line_color(role) : role_color(role), picture_ground(theme), kLineContrast);
}

glm::vec4 picture_fill(const DrawFill& fill, Theme theme) {
  if (!fill.covers) return {role_color(fill.role), float(fill.alpha)};
  return {glm::mix(picture_ground(theme), picture_line_color(fill.role, theme), float(fill.alpha)), 1.0f};
}

glm::vec3 picture_label_color(Role role, Theme theme) {
  const glm::vec3 color = theme == Theme::light ? role_text_color(role) : role_color(role);
  const bool plain = role == Role::text || role == Role::neutral;
  return with_contrast(color, picture_ground(theme), plain && theme == Theme::dark ? 9.0f : kTextContrast);
}

}  // namespace psm
