// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "draw/chart_labels.h"
#include "draw/split_at_infinity.h"

namespace psm {
namespace {

using glm::dvec2;

// On the page: pixels at scale 1.
constexpr double kLine = kChartLine;
constexpr double kLeft = 58.0, kTop = 62.0, kBottom = 50.0;  // the view's title and the axis's above; ticks and title below
constexpr double kLabelGap = 16.0, kLabelPad = 8.0;
constexpr double kMinor = 4.0;
constexpr double kBroken = 13.0;  // a second line of the axis's title, which then begins closer to the view's

glm::dvec4 on_page(const dvec2& p) { return {p, 0.0, 1.0}; }

double label_width(const Chart& chart) {
  double longest = 0.0;
  for (const ChartCurve& curve : chart.curves) longest = std::max(longest, chart_text_width(curve.label));
  return longest > 0.0 ? longest + kLabelGap + kLabelPad : 12.0;
}

std::string title_in_one_line(const ChartAxis& axis) {
  return axis.remark.empty() ? axis.title : axis.title + ";  " + axis.remark;
}

/// What stands at the right end of a curve.
struct EndLabel {
  std::string text;
  Role role;
  dvec2 end;
  int rank;
};

class ChartDrawing {
 public:
  ChartDrawing(const Chart& chart, const ChartFrame& frame)
      : chart_(chart), frame_(frame), box_{{frame.x.from(), frame.y.to(), -1.0}, {frame.x.to(), frame.y.from(), 1.0}} {}

  DrawList list() {
    cells();
    axes();
    for (const ChartMark& mark : chart_.marks) vertical(mark);
    for (const ChartLevel& level : chart_.levels) iso_line(level);
    const auto before_curves = std::ptrdiff_t(list_.lines.size());
    for (const ChartCurve& curve : chart_.curves) polyline(curve);
    curves_.assign(list_.lines.begin() + before_curves, list_.lines.end());
    for (const ChartPoint& p : chart_.points)
      if (frame_.contains(frame_.at(p.at))) list_.points.push_back({on_page(frame_.at(p.at)), p.role, p.radius});
    level_labels();
    end_labels();
    mark_labels();
    return std::move(list_);
  }

 private:
  void line(const dvec2& a, const dvec2& b, Role role, double width, double opacity = 1.0, LineStyle style = LineStyle::solid) {
    list_.lines.push_back({on_page(a), on_page(b), role, width, style, false, opacity, opacity});
  }
  void text(const dvec2& at, const std::string& words, Role role, const dvec2& pivot) {
    list_.texts.push_back({on_page(at), words, role, pivot});
  }

  void cells() {
    for (const ChartCell& cell : chart_.cells) {
      const dvec2 a = frame_.at(cell.min), b = frame_.at(cell.max);
      list_.fills.push_back({{on_page(a), on_page({b.x, a.y}), on_page(b), on_page({a.x, b.y})}, cell.role, cell.alpha});
    }
  }

  std::vector<double> ticks(const ChartAxis& axis, double length, double apart) const {
    const int most = std::max(2, int(length / apart));
    return axis.angles ? angle_ticks(axis.low, axis.high, most) : plot_ticks(axis.low, axis.high, axis.log, most);
  }

  void axes() {
    const double left = frame_.x.from(), right = frame_.x.to(), bottom = frame_.y.from(), top = frame_.y.to();
    for (const double tick : ticks(chart_.x, right - left, 70.0)) {
      const double x = frame_.x.at(tick);
      line({x, top}, {x, bottom}, Role::neutral, 1.0, 0.25);
      text({x, bottom + 3.0}, tick_text(tick) + (chart_.x.angles ? "°" : ""), Role::neutral, {0.5, 0.0});
    }
    for (const double tick : ticks(chart_.y, bottom - top, 34.0)) {
      const double y = frame_.y.at(tick);
      line({left, y}, {right, y}, Role::neutral, 1.0, 0.25);
      text({left - 9.0, y}, tick_text(tick), Role::neutral, {1.0, 0.5});
    }
    if (chart_.x.log)
      for (const double tick : minor_ticks(chart_.x.low, chart_.x.high))
        line({frame_.x.at(tick), bottom}, {frame_.x.at(tick), bottom - kMinor}, Role::neutral, 1.0);
    if (chart_.y.log)
      for (const double tick : minor_ticks(chart_.y.low, chart_.y.high))
        line({left, frame_.y.at(tick)}, {left + kMinor, frame_.y.at(tick)}, Role::neutral, 1.0);
    line({left, bottom}, {right, bottom}, Role::neutral, 1.25);
    line({left, bottom}, {left, top}, Role::neutral, 1.25);
    const ChartAxis& y = chart_.y;
    text({left, top - 4.0}, frame_.title_broken ? y.remark : title_in_one_line(y), Role::text, {0.0, 1.0});
    if (frame_.title_broken) text({left, top - 4.0 - kLine}, y.title, Role::text, {0.0, 1.0});
    text({right, bottom + kLine + 3.0}, chart_.x.title, Role::text, {1.0, 0.0});
  }

  void vertical(const ChartMark& mark) {
    if (!frame_.x.contains(mark.x)) return;
    const double x = frame_.x.at(mark.x);
    line({x, frame_.y.from()}, {x, frame_.y.to()}, mark.role, mark.width, 1.0, mark.style);
  }

  /// Labels of neighbouring lines at two heights in turn.
  void level_labels() {
    double height = 0.5 * (frame_.y.from() + frame_.y.to()) - 0.5 * kLine;
    for (const ChartLevel& level : chart_.levels) {
      dvec2 nearest(INFINITY);
      for (const auto& segment : level.segments) {
        const dvec2 p = frame_.at(segment[0]);
        if (frame_.contains(p) && std::abs(p.y - height) < std::abs(nearest.y - height)) nearest = p;
      }
      if (std::isfinite(nearest.y)) text(nearest, level.label, level.role, {0.5, 0.5});
      height = frame_.y.from() + frame_.y.to() - height;
    }
  }

  void iso_line(const ChartLevel& level) {
    for (const auto& [a, b] : level.segments)
      if (const auto piece = clip_segment(on_page(frame_.at(a)), on_page(frame_.at(b)), box_))
        line(dvec2(piece->a), dvec2(piece->b), level.role, 1.5);
  }

  void polyline(const ChartCurve& curve) {
    double walked = 0.0;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const bool shown = shows(curve.points[i - 1]) && shows(curve.points[i]);
      if (!shown) {
        walked = 0.0;
        continue;
      }
      const auto piece = clip_segment(on_page(frame_.at(curve.points[i - 1])), on_page(frame_.at(curve.points[i])), box_);
      if (piece) walked = dashed(dvec2(piece->a), dvec2(piece->b), curve, walked);
    }
  }
  bool shows(const dvec2& p) const { return frame_.x.shows(p.x) && frame_.y.shows(p.y); }

  /// Draws the segment of a curve of which `walked` has been drawn; returns how much that is now.
  double dashed(const dvec2& a, const dvec2& b, const ChartCurve& curve, double walked) {
    const double length = glm::length(b - a), period = std::accumulate(curve.dash.begin(), curve.dash.end(), 0.0);
    if (!(period > 0.0)) {
      line(a, b, curve.role, curve.width);
      return walked + length;
    }
    double t = 0.0;
    while (t < length) {
      double into = std::fmod(walked + t, period);
      std::size_t part = 0;
      while (part + 1 < curve.dash.size() && into >= curve.dash[part]) into -= curve.dash[part++];
      const double end = std::min(length, t + std::max(1e-3, curve.dash[part] - into));
      if (part % 2 == 0) line(glm::mix(a, b, t / length), glm::mix(a, b, end / length), curve.role, curve.width);
      t = end;
    }
    return walked + length;
  }

  std::vector<EndLabel> ends() const {
    std::vector<EndLabel> out;
    for (const ChartCurve& curve : chart_.curves) {
      if (curve.label.empty()) continue;
      const auto last = std::find_if(curve.points.rbegin(), curve.points.rend(),
                                     [&](const dvec2& p) { return shows(p) && frame_.contains(frame_.at(p)); });
      if (last != curve.points.rend()) out.push_back({curve.label, curve.role, frame_.at(*last), curve.rank});
    }
    return out;
  }

  void end_labels() {
    std::vector<EndLabel> labels = ends();
    const double room = frame_.y.from() - frame_.y.to() + 0.5 * kLine;
    std::stable_sort(labels.begin(), labels.end(), [](const EndLabel& a, const EndLabel& b) { return a.rank < b.rank; });
    if (double(labels.size()) * kLine > room) labels.resize(std::size_t(std::max(0.0, room / kLine)));
    std::stable_sort(labels.begin(), labels.end(), [](const EndLabel& a, const EndLabel& b) { return a.end.y < b.end.y; });
    std::vector<double> places;
    for (const EndLabel& label : labels) places.push_back(label.end.y);
    spread(places, kLine, frame_.y.from());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const dvec2 at(frame_.x.to() + kLabelGap, places[i]);
      line(labels[i].end, at - dvec2(3.0, 0.0), labels[i].role, 1.0, 0.7);
      text(at, labels[i].text, labels[i].role, {0.0, 0.5});
    }
  }

  void mark_labels() {
    std::vector<double> at;
    for (const ChartMark& mark : chart_.marks)
      if (frame_.x.contains(mark.x)) at.push_back(frame_.x.at(mark.x));
    MarkLabels labels(box_, curves_, at);
    for (const bool below : {true, false})
      for (const ChartMark& mark : chart_.marks) {
        if (mark.label_below != below || mark.label.empty() || !frame_.x.contains(mark.x)) continue;
        const auto place = labels.place(mark, frame_.x.at(mark.x));
        if (place) text(place->at, place->text, mark.role, {place->to_left ? 1.0 : 0.0, 0.0});
      }
  }

  const Chart& chart_;
  const ChartFrame& frame_;
  Box box_;
  std::vector<DrawLine> curves_;
  DrawList list_;
};

}  // namespace

bool ChartFrame::contains(const dvec2& page) const {
  constexpr double rounding = 1e-6;
  return page.x >= x.from() - rounding && page.x <= x.to() + rounding && page.y >= y.to() - rounding &&
         page.y <= y.from() + rounding;
}

ChartFrame chart_frame(const Chart& chart, const dvec2& page) {
  const double right = std::max(kLeft + 20.0, page.x - std::min(label_width(chart), 0.4 * page.x));
  const bool broken = !chart.y.remark.empty() && kLeft + chart_text_width(title_in_one_line(chart.y)) > page.x;
  const double top = kTop + (broken ? kBroken : 0.0), bottom = std::max(top + 20.0, page.y - kBottom);
  return {PlotScale(chart.x.low, chart.x.high, chart.x.log, kLeft, right),
          PlotScale(chart.y.low, chart.y.high, chart.y.log, bottom, top), broken};
}

DrawList chart_list(const Chart& chart, const ChartFrame& frame) { return ChartDrawing(chart, frame).list(); }

glm::dmat4 clip_from_page(const dvec2& page) {
  glm::dmat4 m(1.0);
  m[0][0] = 2.0 / page.x;
  m[1][1] = -2.0 / page.y;
  m[3] = glm::dvec4(-1.0, 1.0, 0.0, 1.0);
  return m;
}

}  // namespace psm
