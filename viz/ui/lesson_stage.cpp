// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_stage.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

constexpr double kColumns[] = {0.38, 0.44, 0.5, 0.56};  // of the window's width: few, so that views seldom change their size

/// The narrower column was there first.
bool better(const StageFit& a, const StageFit& b) {
  if (a.begins.size() != b.begins.size()) return a.begins.size() < b.begins.size();
  return a.divided != b.divided ? a.divided < b.divided : a.size > b.size;
}

std::size_t divided_groups(const std::vector<PartSize>& parts, const std::vector<std::size_t>& begins) {
  return std::size_t(std::count_if(begins.begin() + 1, begins.end(), [&](std::size_t i) { return !parts[i].begins; }));
}

double height_of(const std::vector<PartSize>& parts, std::size_t from, std::size_t to, double gap) {
  double sum = -gap;
  for (std::size_t i = from; i < to; ++i) sum += parts[i].height + gap;
  return sum;
}

}  // namespace

// Capitals of 22 pixels on a screen of 1080 lines; DejaVu's are 0.63 of ImGui's size.
double least_stage_type(int window_height) { return std::ceil(window_height / 30.0); }
double largest_stage_type(int window_height) { return std::round(window_height / 24.0); }

std::optional<std::vector<std::size_t>> spread_over_screens(const std::vector<PartSize>& parts, double gap, double height) {
  std::vector<std::size_t> begins{0};
  double y = 0.0;
  const auto end_of_group = [&](std::size_t i) {
    for (++i; i < parts.size() && !parts[i].begins;) ++i;
    return i;
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].height > height) return std::nullopt;
    const double needed = height_of(parts, i, parts[i].begins ? end_of_group(i) : i + 1, gap);
    if (y > 0.0 && y + needed > height) begins.push_back(i), y = 0.0;
    y += parts[i].height + gap;
  }
  return begins;
}

bool stays_on_screens(const std::vector<PartSize>& parts, const std::vector<std::size_t>& begins, double gap, double height) {
  for (std::size_t screen = 0; screen < begins.size(); ++screen) {
    const std::size_t end = screen + 1 < begins.size() ? begins[screen + 1] : parts.size();
    if (begins[screen] >= end || end > parts.size() || height_of(parts, begins[screen], end, gap) > height) return false;
  }
  return true;
}

StageFit fit_stage(glm::ivec2 window, double height, double margin, double gap, const MeasureParts& measure) {
  const double least = least_stage_type(window.y), largest = std::max(least, largest_stage_type(window.y));
  std::optional<StageFit> best;
  for (const double part : kColumns) {
    const double column = std::floor(part * window.x);
    for (double size = largest; size >= least; size -= 1.0) {
      const auto parts = measure(column - 2.0 * margin, size);
      const auto begins = parts ? spread_over_screens(*parts, gap, height) : std::nullopt;
      if (!begins) continue;
      const StageFit fit{column, size, *begins, divided_groups(*parts, *begins), true};
      if (!best || better(fit, *best)) best = fit;
    }
    if (best && best->begins.size() == 1 && best->size == largest) break;
  }
  return best.value_or(StageFit{std::floor(std::end(kColumns)[-1] * window.x), least, {0}, 0, false});
}

}  // namespace psm
