// SPDX-License-Identifier: GPL-3.0-or-later
// Plots as plain data, and as SVG: every curve labelled where it ends, so that no legend has to be looked up.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace psm {

/// Told apart by colour, dash and label.
struct PlotCurve {
  std::string label = {};  // empty: none
  std::vector<glm::dvec2> points = {};
  std::uint32_t color = 0x222222;  // 0xRRGGBB
  std::string dash = {};           // SVG's stroke-dasharray; empty: solid
  double width = 3.0;              // 0: only markers
  bool markers = false;
  double opacity = 1.0;  // of the line; its label is always opaque
};

struct PlotAxis {
  std::string title;          // with its unit
  bool log = false;           // values that are not positive are left out
  std::vector<double> ticks;  // empty: chosen
};

/// A horizontal line over the whole plot.
struct PlotLevel {
  double y = 0.0;
  std::string label;
};

struct Plot {
  std::string title, subtitle;
  PlotAxis x, y;
  std::vector<PlotCurve> curves;
  std::vector<PlotLevel> levels;
};

/// A slide's width; type large enough for a lecture hall.
constexpr int kPlotWidth = 1100, kPlotHeight = 640;

/// An <svg> element; `standalone`: with what a file of its own needs.
std::string plot_svg(const Plot& plot, bool standalone);

/// Text for XML and HTML.
std::string xml_text(const std::string& text);

}  // namespace psm
