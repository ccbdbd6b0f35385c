// SPDX-License-Identifier: GPL-3.0-or-later
// One axis of a plot: from values to places and back, its ticks, and labels that keep apart.
#pragma once

#include <string>
#include <vector>

namespace psm {

/// Values in [low, high], or their logarithms, along [from, to] on the page.
class PlotScale {
 public:
  /// The range as it is; one that has no extent is widened.
  PlotScale(double low, double high, bool log, double from, double to);

  double at(double value) const;
  double value_at(double place) const;
  bool shows(double value) const;  // finite, and positive where the axis is logarithmic
  bool contains(double value) const { return shows(value) && value >= low_ && value <= high_; }
  double low() const { return low_; }
  double high() const { return high_; }
  double from() const { return from_; }
  double to() const { return to_; }
  bool is_log() const { return log_; }

 private:
  bool log_;
  double from_, to_, low_, high_;
};

/// Round numbers within [low, high], at most `most` of them; of a logarithmic axis decades, with 2 and 5 between where there are
/// few.
std::vector<double> plot_ticks(double low, double high, bool log, int most);

/// 2 to 9 between the decades of a logarithmic axis, unlabelled; none where there are more than six decades.
std::vector<double> minor_ticks(double low, double high);

/// Angles: every 5, 10, 15, 30, 45 or 90 degrees.
std::vector<double> angle_ticks(double low, double high, int most);

std::string tick_text(double value);

/// Places along a line, in order, moved as little as it takes to be `apart` from each other and not beyond `limit`.
void spread(std::vector<double>& sorted, double apart, double limit);

}  // namespace psm
