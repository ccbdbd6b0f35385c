// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/chart_labels.h"

#include <algorithm>
#include <cmath>

#include "draw/utf8.h"

namespace psm {
namespace {

using glm::dvec2;

// Pixels at scale 1.
constexpr double kGlyph = 8.2;  // width, on average
constexpr double kGap = 5.0, kFromEdge = 2.0;

// What a place costs, in pixels of curve that the label covers.
constexpr double kOfRow = 2.0, kOfShortText = 60.0;
constexpr double kOfMark = 40.0, kOfCloseMark = 150.0, kClose = 24.0;  // over another mark, which it may seem to name

bool overlap(const Box& a, const Box& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

}  // namespace

double chart_text_width(const std::string& text) { return kGlyph * double(decode_utf8(text).size()); }

bool MarkLabels::is_free(const Box& box) const {
  return box.min.x >= plot_.min.x && box.max.x <= plot_.max.x &&
         std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) { return overlap(box, other); });
}

double MarkLabels::covered(const Box& box, double x) const {
  double sum = 0.0;
  for (const DrawLine& line : curves_)
    if (const auto piece = clip_segment(line.a, line.b, box)) sum += glm::length(piece->b - piece->a);
  for (const double mark : marks_)
    if (mark != x && mark > box.min.x && mark < box.max.x) sum += std::abs(mark - x) < kClose ? kOfCloseMark : kOfMark;
  return sum;
}

void MarkLabels::consider(const ChartMark& mark, const std::string& text, bool is_short, double x) {
  const int rows = text.empty() ? 0 : int((plot_.max.y - plot_.min.y - kFromEdge) / kChartLine);
  const double width = chart_text_width(text);
  for (const bool to_left : {false, true})
    for (int row = 0; row < rows; ++row) {
      const double y =
          mark.label_below ? plot_.max.y - kFromEdge - (row + 1) * kChartLine : plot_.min.y + kFromEdge + row * kChartLine;
      const double near = to_left ? x - kGap : x + kGap, left = to_left ? near - width : near;
      const Box box{{left, y, -1.0}, {left + width, y + kChartLine, 1.0}};
      if (!is_free(box)) continue;
      const double cost = covered(box, x) + kOfRow * row + (is_short ? kOfShortText : 0.0);
      if (!best_ || cost < best_->cost) best_ = Candidate{{{near, y}, text, to_left}, box, cost};
    }
}

std::optional<MarkLabels::Place> MarkLabels::place(const ChartMark& mark, double x) {
  best_.reset();
  consider(mark, mark.label, false, x);
  consider(mark, mark.short_label, true, x);
  if (!best_) return {};
  taken_.push_back(best_->box);
  return best_->place;
}

}  // namespace psm
