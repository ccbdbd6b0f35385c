// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/seen_rect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace psm::gl {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

PixelRect pixel_rect(const glm::dvec4& rect, glm::ivec2 size) {
  const auto pixel = [](double clip, int extent) { return int(std::lround((std::clamp(clip, -1.0, 1.0) * 0.5 + 0.5) * extent)); };
  return {pixel(rect.x, size.x), pixel(rect.y, size.y), pixel(rect.z, size.x), pixel(rect.w, size.y)};
}

PixelRect common(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.left, b.left), std::max(a.bottom, b.bottom), std::min(a.right, b.right), std::min(a.top, b.top)};
}

PixelRect joined(const PixelRect& a, const PixelRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right), std::max(a.top, b.top)};
}

void SeenRect::add_point(const glm::dvec4& p) {
  if (!std::isfinite(p.x + p.y + p.w)) min_ = glm::dvec2(-kInfinity), max_ = glm::dvec2(kInfinity);  // it may be anywhere
  if (!(p.w > 0.0)) return;
  const glm::dvec2 at = glm::dvec2(p) / p.w;
  min_ = glm::min(min_, at);
  max_ = glm::max(max_, at);
}

void SeenRect::add_segment(const glm::dvec4& a, const glm::dvec4& b) {
  add_point(a);
  add_point(b);
  if ((a.w > 0.0) == (b.w > 0.0)) return;
  // It leaves towards where w = 0, where only the direction is left.
  const glm::dvec4 leaving = glm::mix(a, b, a.w / (a.w - b.w));
  for (int axis = 0; axis < 2; ++axis) {
    if (leaving[axis] <= 0.0) min_[axis] = -kInfinity;
    if (leaving[axis] >= 0.0) max_[axis] = kInfinity;
  }
}

void SeenRect::add_polygon(const glm::dmat4& clip_from_space, std::span<const glm::dvec4> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    add_segment(clip_from_space * corners[i], clip_from_space * corners[(i + 1) % corners.size()]);
}

void SeenRect::add_box(const glm::dmat4& clip_from_world, const Bounds& box) {
  if (box.empty()) return;
  std::array<glm::dvec4, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[std::size_t(i)] = clip_from_world * glm::dvec4((i & 1 ? box.max : box.min).x, (i & 2 ? box.max : box.min).y,
                                                           (i & 4 ? box.max : box.min).z, 1.0);
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4})
      if (!(i & bit)) add_segment(corners[std::size_t(i)], corners[std::size_t(i | bit)]);
}

PixelRect SeenRect::pixels(glm::ivec2 size, int margin) const {
  if (!(min_.x <= max_.x && min_.y <= max_.y)) return {};
  const auto at = [](double clip, int extent) { return (std::clamp(clip, -2.0, 2.0) * 0.5 + 0.5) * extent; };
  return {std::clamp(int(std::floor(at(min_.x, size.x))) - margin, 0, size.x),
          std::clamp(int(std::floor(at(min_.y, size.y))) - margin, 0, size.y),
          std::clamp(int(std::ceil(at(max_.x, size.x))) + margin, 0, size.x),
          std::clamp(int(std::ceil(at(max_.y, size.y))) + margin, 0, size.y)};
}

}  // namespace psm::gl
