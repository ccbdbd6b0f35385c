// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/repeats.h"

#include <algorithm>
#include <cassert>

namespace psm {
namespace {

double quantile(std::vector<double>& values, double fraction) {
  assert(!values.empty());
  const auto at = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

double median(std::vector<double> values) { return quantile(values, 0.5); }

double relative_spread(std::vector<double> values) {
  const double low = quantile(values, 0.25), middle = quantile(values, 0.5), high = quantile(values, 0.75);
  return middle > 0 ? (high - low) / middle : 0.0;
}

void Repeats::add(const FrameTimes& times) {
  runs_.push_back(times);
  spent_ += times.analysis + times.bodies + times.map + std::max(times.eye, 0.0);
}

bool Repeats::enough() const {
  if (count() < limits_.fewest) return false;
  return count() >= limits_.most || spent_ >= limits_.seconds || spread() <= limits_.spread;
}

double Repeats::median_of(double FrameTimes::*stage) const {
  std::vector<double> values;
  for (const FrameTimes& run : runs_)
    if (run.*stage >= 0) values.push_back(run.*stage);
  return values.empty() ? -1 : median(std::move(values));
}

FrameTimes Repeats::medians() const {
  FrameTimes m;
  for (const auto stage : {&FrameTimes::analysis, &FrameTimes::bodies, &FrameTimes::map, &FrameTimes::map_gpu, &FrameTimes::eye,
                           &FrameTimes::eye_gpu})
    m.*stage = median_of(stage);
  return m;
}

double Repeats::spread() const {
  std::vector<double> values;
  for (const FrameTimes& run : runs_) values.push_back(run.analysis + run.map);
  return relative_spread(std::move(values));
}

}  // namespace psm
