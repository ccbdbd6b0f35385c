// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "draw/plot_axis.h"
#include "figure/plot.h"

namespace psm {
namespace {

using glm::dvec2;

constexpr double kLeft = 130, kRight = 250, kTop = 92, kBottom = 84;
constexpr double kType = 20, kTitle = 27;
constexpr double kPlotRight = kPlotWidth - kRight, kPlotBottom = kPlotHeight - kBottom;
constexpr double kLineHeight = 1.2 * kType;

std::string coordinate(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string color_text(std::uint32_t color) {
  char text[16];
  std::snprintf(text, sizeof text, "#%06X", color & 0xFFFFFFu);
  return text;
}

/// The axis's range with some room around it, along [from, to].
PlotScale scale_of(const PlotAxis& axis, double low, double high, double from, double to) {
  if (!(low <= high)) low = axis.log ? 1 : 0, high = axis.log ? 10 : 1;
  const double margin = high > low ? 0.04 : 0.5;
  if (axis.log) {
    const double ratio = high / low > 1.01 ? std::pow(high / low, margin) : 1.5;
    return {low / ratio, high * ratio, true, from, to};
  }
  const double extra = high > low ? margin * (high - low) : std::max(0.5, std::abs(low) * margin);
  return {low - extra, high + extra, false, from, to};
}

struct Frame {
  PlotScale x, y;
  bool shows(const dvec2& p) const { return x.shows(p.x) && y.shows(p.y); }
  dvec2 at(const dvec2& p) const { return {x.at(p.x), y.at(p.y)}; }
};

Frame frame_of(const Plot& plot) {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  const auto add = [&](int i, double v, bool log) {
    if (!std::isfinite(v) || (log && !(v > 0))) return;
    low[i] = std::min(low[i], v), high[i] = std::max(high[i], v);
  };
  for (const PlotCurve& curve : plot.curves)
    for (const dvec2& p : curve.points) add(0, p.x, plot.x.log), add(1, p.y, plot.y.log);
  for (const double tick : plot.x.ticks) add(0, tick, plot.x.log);
  for (const PlotLevel& level : plot.levels) add(1, level.y, plot.y.log);
  return {scale_of(plot.x, low[0], high[0], kLeft, kPlotRight), scale_of(plot.y, low[1], high[1], kPlotBottom, kTop)};
}

std::string text_at(double x, double y, const std::string& text, const std::string& attributes) {
  return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" " + attributes + ">" + xml_text(text) + "</text>\n";
}

std::string line(const dvec2& a, const dvec2& b, const std::string& attributes) {
  return "<line x1=\"" + coordinate(a.x) + "\" y1=\"" + coordinate(a.y) + "\" x2=\"" + coordinate(b.x) + "\" y2=\"" +
         coordinate(b.y) + "\" " + attributes + "/>\n";
}

constexpr const char* kGrid = "stroke=\"#DDDDDD\" stroke-width=\"1.5\"";
constexpr const char* kAxis = "stroke=\"#444444\" stroke-width=\"1.5\"";

std::vector<double> ticks_of(const PlotAxis& axis, const PlotScale& scale, int most) {
  return axis.ticks.empty() ? plot_ticks(scale.low(), scale.high(), axis.log, most) : axis.ticks;
}

std::vector<double> minor_ticks_of(const PlotAxis& axis, const PlotScale& scale) {
  return axis.log && axis.ticks.empty() ? minor_ticks(scale.low(), scale.high()) : std::vector<double>();
}

std::string axes_svg(const Plot& plot, const Frame& frame) {
  std::string svg;
  for (const double tick : ticks_of(plot.x, frame.x, int((kPlotRight - kLeft) / 90))) {
    const double x = frame.x.at(tick);
    svg += line({x, kTop}, {x, kPlotBottom}, kGrid);
    svg += text_at(x, kPlotBottom + 1.25 * kType, tick_text(tick), "text-anchor=\"middle\"");
  }
  for (const double tick : ticks_of(plot.y, frame.y, int((kPlotBottom - kTop) / 55))) {
    const double y = frame.y.at(tick);
    svg += line({kLeft, y}, {kPlotRight, y}, kGrid);
    svg += text_at(kLeft - 10, y + 0.35 * kType, tick_text(tick), "text-anchor=\"end\"");
  }
  for (const double tick : minor_ticks_of(plot.x, frame.x))
    svg += line({frame.x.at(tick), kPlotBottom}, {frame.x.at(tick), kPlotBottom - 6}, kAxis);
  for (const double tick : minor_ticks_of(plot.y, frame.y))
    svg += line({kLeft, frame.y.at(tick)}, {kLeft + 6, frame.y.at(tick)}, kAxis);
  svg += line({kLeft, kPlotBottom}, {kPlotRight, kPlotBottom}, kAxis) + line({kLeft, kTop}, {kLeft, kPlotBottom}, kAxis);
  svg += text_at((kLeft + kPlotRight) / 2, kPlotHeight - 22, plot.x.title, "text-anchor=\"middle\"");
  const double middle = (kTop + kPlotBottom) / 2;
  svg += text_at(36, middle, plot.y.title, "text-anchor=\"middle\" transform=\"rotate(-90 36 " + coordinate(middle) + ")\"");
  return svg;
}

/// The stretches of the curve that can be shown.
std::vector<std::vector<dvec2>> stretches(const PlotCurve& curve, const Frame& frame) {
  std::vector<std::vector<dvec2>> parts(1);
  for (const dvec2& p : curve.points) {
    if (frame.shows(p))
      parts.back().push_back(frame.at(p));
    else if (!parts.back().empty())
      parts.emplace_back();
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

std::string curve_svg(const PlotCurve& curve, const Frame& frame) {
  std::string svg;
  const std::string color = color_text(curve.color);
  for (const auto& part : stretches(curve, frame)) {
    std::string points;
    for (const dvec2& p : part) points += (points.empty() ? "" : " ") + coordinate(p.x) + "," + coordinate(p.y);
    if (curve.width > 0 && part.size() > 1)
      svg += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + color + "\" stroke-width=\"" +
             coordinate(curve.width) + "\" stroke-linejoin=\"round\"" +
             (curve.dash.empty() ? "" : " stroke-dasharray=\"" + curve.dash + "\"") +
             (curve.opacity < 1 ? " stroke-opacity=\"" + coordinate(curve.opacity) + "\"" : "") + "/>\n";
    if (!curve.markers && part.size() > 1) continue;
    for (const dvec2& p : part)
      svg += "<circle cx=\"" + coordinate(p.x) + "\" cy=\"" + coordinate(p.y) + "\" r=\"5\" fill=\"" + color +
             "\" stroke=\"#FFFFFF\" stroke-width=\"1\"/>\n";
  }
  return svg;
}

struct Label {
  std::string text, color;
  dvec2 end;  // of what it names
  double y;
  std::string dash = "";
};

/// In the order of the curves' ends, at least a line apart, as close to the ends as that allows.
void spread_labels(std::vector<Label>& labels) {
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  std::vector<double> places;
  for (const Label& label : labels) places.push_back(label.y);
  spread(places, kLineHeight, kPlotBottom);
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i].y = places[i];
}

std::string labels_svg(const Plot& plot, const Frame& frame) {
  std::vector<Label> labels;
  for (const PlotCurve& curve : plot.curves) {
    const auto parts = stretches(curve, frame);
    if (curve.label.empty() || parts.empty()) continue;
    labels.push_back({curve.label, color_text(curve.color), parts.back().back(), parts.back().back().y, curve.dash});
  }
  for (const PlotLevel& level : plot.levels)
    labels.push_back({level.label, "#222222", {kPlotRight - 7, frame.y.at(level.y)}, frame.y.at(level.y), "2 5"});
  spread_labels(labels);
  std::string svg;
  for (const Label& label : labels) {
    const dvec2 at{kPlotRight + 40, label.y};
    svg += line(label.end + dvec2(7, 0), at - dvec2(6, 0),
                "stroke=\"" + label.color + "\" stroke-width=\"1.2\"" +
                    (label.dash.empty() ? "" : " stroke-dasharray=\"" + label.dash + "\""));
    svg += text_at(at.x, at.y + 0.35 * kType, label.text, "font-weight=\"bold\" fill=\"" + label.color + "\"");
  }
  return svg;
}

std::string levels_svg(const Plot& plot, const Frame& frame) {
  std::string svg;
  for (const PlotLevel& level : plot.levels) {
    const double y = frame.y.at(level.y);
    svg += line({kLeft, y}, {kPlotRight, y}, "stroke=\"#222222\" stroke-width=\"2\" stroke-dasharray=\"2 5\"");
  }
  return svg;
}

}  // namespace

std::string xml_text(const std::string& text) {
  // XML has no control characters but these.
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' && c != '\r'; };
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += is_control(c) ? ' ' : c;
  }
  return out;
}

std::string plot_svg(const Plot& plot, bool standalone) {
  const Frame frame = frame_of(plot);
  const std::string size = std::to_string(kPlotWidth) + " " + std::to_string(kPlotHeight);
  std::string svg = standalone ? "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" : "";
  svg += "<svg viewBox=\"0 0 " + size + "\" role=\"img\" aria-label=\"" + xml_text(plot.title) +
         "\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" font-size=\"" + coordinate(kType) + "\" fill=\"#222222\"";
  if (standalone)
    svg += " xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(kPlotWidth) + "\" height=\"" +
           std::to_string(kPlotHeight) + "\"";
  svg += ">\n<rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>\n";
  svg += text_at(kLeft, 36, plot.title, "font-size=\"" + coordinate(kTitle) + "\" font-weight=\"bold\"");
  svg += text_at(kLeft, 66, plot.subtitle, "fill=\"#444444\" font-size=\"18\"");
  svg += axes_svg(plot, frame) + levels_svg(plot, frame);
  for (const PlotCurve& curve : plot.curves) svg += curve_svg(curve, frame);
  return svg + labels_svg(plot, frame) + "</svg>\n";
}

}  // namespace psm
