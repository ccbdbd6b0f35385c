// SPDX-License-Identifier: GPL-3.0-or-later
// Where the labels of a chart's marks stand: within the plot, apart from each other, on as little of its curves as can be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/chart.h"
#include "draw/split_at_infinity.h"

namespace psm {

constexpr double kChartLine = 19.0;  // height of a line of text, pixels at scale 1

/// About: a chart is laid out before anyone measures its texts.
double chart_text_width(const std::string& text);

class MarkLabels {
 public:
  /// `plot`: the axes' box on the page; `curves`: lines on the page; `marks`: where all marks stand.
  MarkLabels(const Box& plot, const std::vector<DrawLine>& curves, const std::vector<double>& marks)
      : plot_(plot), curves_(curves), marks_(marks) {}

  struct Place {
    glm::dvec2 at{0.0};  // the upper end beside the mark
    std::string text;
    bool to_left = false;
  };
  /// None where the plot has no room. What has a place keeps it.
  std::optional<Place> place(const ChartMark& mark, double x);

 private:
  void consider(const ChartMark& mark, const std::string& text, bool is_short, double x);
  bool is_free(const Box& box) const;
  double covered(const Box& box, double x) const;

  const Box& plot_;
  const std::vector<DrawLine>& curves_;
  const std::vector<double>& marks_;
  std::vector<Box> taken_;

  struct Candidate {
    Place place;
    Box box;
    double cost;
  };
  std::optional<Candidate> best_;  // for the mark that is being placed
};

}  // namespace psm
