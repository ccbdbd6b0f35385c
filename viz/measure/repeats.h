// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the stages of one frame, repeated until their median can be trusted.
#pragma once

#include <functional>
#include <vector>

namespace psm {

/// Nothing may be empty.
double median(std::vector<double> values);
/// Distance of the quartiles over the median; 0 where the median is.
double relative_spread(std::vector<double> values);

/// Seconds; a negative gpu time: no timer query.
struct FrameTimes {
  double analysis = 0, bodies = 0, map = 0, map_gpu = -1, eye = 0, eye_gpu = -1;
  double all() const { return analysis + map + eye; }
};

class Repeats {
 public:
  struct Limits {
    int fewest = 5, most = 15;
    double spread = 0.05, seconds = 0.4;  // enough: a spread that small, or that much time spent
  };
  explicit Repeats(const Limits& limits) : limits_(limits) {}
  void add(const FrameTimes& times);
  bool enough() const;
  FrameTimes medians() const;
  double spread() const { return relative_spread(of(&FrameTimes::analysis, &FrameTimes::map, &FrameTimes::eye)); }
  int count() const { return int(runs_.size()); }

 private:
  /// Of each run the sum of these stages.
  template <class... Stages>
  std::vector<double> of(Stages... stages) const {
    std::vector<double> values;
    for (const FrameTimes& run : runs_) values.push_back((std::invoke(stages, run) + ...));
    return values;
  }

  Limits limits_;
  std::vector<FrameTimes> runs_;
  double spent_ = 0;
};

}  // namespace psm
