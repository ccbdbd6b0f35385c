// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "figure/plot.h"

namespace psm {
namespace {

std::vector<double> linear_ticks(double low, double high, int most) {
  const double rough = (high - low) / std::max(1, most - 1), decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * decade;
  for (const double nice : {1.0, 2.0, 2.5, 5.0})
    if (nice * decade >= rough * (1 - 1e-9)) step = std::min(step, nice * decade);
  std::vector<double> ticks;
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) ticks.push_back(i * step);
  return ticks;
}

std::vector<double> decades(double low, double high, const std::vector<double>& within) {
  std::vector<double> ticks;
  for (int e = int(std::floor(std::log10(low))); e <= int(std::ceil(std::log10(high))); ++e)
    for (const double digit : within) {
      const double tick = digit * std::pow(10.0, e);
      if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9)) ticks.push_back(tick);
    }
  return ticks;
}

std::vector<double> log_ticks(double low, double high, int most) {
  std::vector<double> ticks = decades(low, high, {1});
  if (ticks.size() < 3) ticks = decades(low, high, {1, 2, 5});
  if (ticks.size() < 3) ticks = linear_ticks(low, high, most);
  if (int(ticks.size()) <= most) return ticks;
  std::vector<double> fewer;
  const std::size_t every = (ticks.size() + std::size_t(most) - 1) / std::size_t(most);
  for (std::size_t i = 0; i < ticks.size(); i += every) fewer.push_back(ticks[i]);
  return fewer;
}

}  // namespace

std::vector<double> plot_ticks(double low, double high, bool log, int most) {
  if (!(low < high) || (log && !(low > 0))) return {};
  return log ? log_ticks(low, high, most) : linear_ticks(low, high, most);
}

}  // namespace psm
