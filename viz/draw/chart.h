// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as a DrawList, on a page whose unit is a pixel at scale 1; y downwards.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "draw/plot_axis.h"

namespace psm {

/// Told apart by colour, dashes, width and the label at its right end.
struct ChartCurve {
  std::string label;
  std::vector<glm::dvec2> points;  // a gap where a value is not finite
  Role role = Role::text;
  double width = 1.75;
  std::vector<double> dash;  // lengths drawn and left out in turn; empty: solid
  int rank = 0;              // where there is no room for all labels the highest ranks go without
};

/// All points of one height of a surface; the label stands on the line.
struct ChartLevel {
  std::string label;
  std::vector<std::array<glm::dvec2, 2>> segments;
  Role role = Role::text;
};

/// A part of the plot between values, filled.
struct ChartCell {
  glm::dvec2 min{0.0}, max{0.0};
  double alpha = 0.0;
  Role role = Role::text;
};

/// A vertical line over the whole plot; its label stands beside it, as near as can be to the top, or to the bottom.
struct ChartMark {
  double x = 0.0;
  std::string label, short_label;  // the short one, if there is one, where there is no room for the other
  Role role = Role::neutral;
  double width = 1.25;
  LineStyle style = LineStyle::dashed;
  bool label_below = false;
};

struct ChartAxis {
  std::string title;
  std::string remark;  // behind the title, or below it on a narrow page
  double low = 0.0, high = 1.0;
  bool log = false;
  bool angles = false;
};

struct ChartPoint {
  glm::dvec2 at{0.0};
  Role role = Role::text;
  double radius = 4.0;
};

struct Chart {
  ChartAxis x, y;
  std::vector<ChartCell> cells;
  std::vector<ChartLevel> levels;
  std::vector<ChartCurve> curves;
  std::vector<ChartMark> marks;
  std::vector<ChartPoint> points;
};

/// Where values stand on the page.
struct ChartFrame {
  PlotScale x, y;
  bool title_broken = false;  // the remark of y stands below its title
  glm::dvec2 at(const glm::dvec2& value) const { return {x.at(value.x), y.at(value.y)}; }
  bool contains(const glm::dvec2& page) const;  // within the axes
};

ChartFrame chart_frame(const Chart& chart, const glm::dvec2& page);
DrawList chart_list(const Chart& chart, const ChartFrame& frame);

/// Clip space from the page.
glm::dmat4 clip_from_page(const glm::dvec2& page);

}  // namespace psm
