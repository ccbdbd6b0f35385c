// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the stages of one frame, repeated until their median can be trusted.
#pragma once

#include <vector>

namespace psm {

/// Nothing may be empty.
double median(std::vector<double> values);
/// Distance of the quartiles over the median; 0 where the median is.
double relative_spread(std::vector<double> values);

/// Seconds; negative: not measured.
struct FrameTimes {
  double analysis = 0, bodies = 0, map = 0, map_gpu = -1, eye = -1, eye_gpu = -1;
};

class Repeats {
 public:
  struct Limits {
    int fewest = 5, most = 15;
    double spread = 0.05, seconds = 0.3;  // enough: a spread that small, or that much time spent
    int eyes = 3;                         // the eye's image costs much and hardly depends on the map: it is drawn this often
  };
  explicit Repeats(const Limits& limits) : limits_(limits) {}
  void add(const FrameTimes& times);
  bool enough() const;
  bool wants_eye() const { return count() < limits_.eyes; }
  /// Of each stage over the runs that measured it.
  FrameTimes medians() const;
  /// Of what the shadows cost: analysis and map.
  double spread() const;
  int count() const { return int(runs_.size()); }

 private:
  double median_of(double FrameTimes::*stage) const;

  Limits limits_;
  std::vector<FrameTimes> runs_;
  double spent_ = 0;
};

}  // namespace psm
