// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace psm {
namespace {

std::vector<double> linear_ticks(double low, double high, int most) {
  const double rough = (high - low) / std::max(1, most - 1), decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * decade;
  for (const double nice : {1.0, 2.0, 2.5, 5.0})
    if (nice * decade >= rough * (1 - 1e-9)) step = std::min(step, nice * decade);
  std::vector<double> ticks;
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) ticks.push_back(i * step + 0.0);  // not -0
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

PlotScale::PlotScale(double low, double high, bool log, double from, double to)
    : log_(log), from_(from), to_(to), low_(low), high_(high) {
  if (!(low_ <= high_) || (log_ && !(low_ > 0))) low_ = log_ ? 1 : 0, high_ = log_ ? 10 : 1;
  if (low_ < high_) return;
  if (log_)
    low_ /= 1.5, high_ *= 1.5;
  else
    low_ -= std::max(0.5, 0.5 * std::abs(low_)), high_ += std::max(0.5, 0.5 * std::abs(high_));
}

double PlotScale::at(double value) const {
  const double t = log_ ? std::log(value / low_) / std::log(high_ / low_) : (value - low_) / (high_ - low_);
  return from_ + t * (to_ - from_);
}

double PlotScale::value_at(double place) const {
  const double t = (place - from_) / (to_ - from_);
  return log_ ? low_ * std::pow(high_ / low_, t) : low_ + t * (high_ - low_);
}

bool PlotScale::shows(double value) const { return std::isfinite(value) && (!log_ || value > 0); }

std::vector<double> plot_ticks(double low, double high, bool log, int most) {
  if (!(low < high) || (log && !(low > 0))) return {};
  return log ? log_ticks(low, high, most) : linear_ticks(low, high, most);
}

std::vector<double> minor_ticks(double low, double high) {
  if (!(low > 0 && low < high) || high / low > 1e6) return {};
  std::vector<double> ticks = decades(low, high, {2, 3, 4, 5, 6, 7, 8, 9});
  return ticks;
}

std::vector<double> angle_ticks(double low, double high, int most) {
  for (const double step : {5.0, 10.0, 15.0, 30.0, 45.0, 90.0}) {
    std::vector<double> ticks;
    const double first = step * std::ceil(low / step - 1e-9) + 0.0;  // not -0
    for (double tick = first; tick <= high + 1e-9; tick += step) ticks.push_back(tick);
    if (int(ticks.size()) <= most) return ticks;
  }
  return {};
}

std::string tick_text(double value) {
  char text[32];
  const double size = std::abs(value);
  if (size >= 1e6 || (size > 0 && size < 1e-4))
    std::snprintf(text, sizeof text, "%.0e", value);
  else
    std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

void spread(std::vector<double>& sorted, double apart, double limit) {
  for (std::size_t i = 1; i < sorted.size(); ++i) sorted[i] = std::max(sorted[i], sorted[i - 1] + apart);
  for (std::size_t i = sorted.size(); i-- > 0; limit = sorted[i] - apart) sorted[i] = std::min(sorted[i], limit);
}

}  // namespace psm
