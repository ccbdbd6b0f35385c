// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/curve_relief.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/chart_labels.h"
#include "draw/curve_surface.h"
#include "draw/curves_view.h"
#include "draw/plot_axis.h"
#include "draw/relief_box.h"
#include "draw/sketch.h"

namespace psm {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kColumns = 45, kRows = 30;  // over theta and z, besides the ruled lines
constexpr double kLeastTheta = 0.25;      // degrees: at 0 F is infinite
constexpr double kLine = kChartLine;

/// A line of the grid, in [0, 1]; some are drawn.
struct Rule {
  double at = 0.0;
  Role role = Role::neutral;
  double width = 0.0;  // pixels; 0: not drawn
};

void sort_unique(std::vector<Rule>& rules) {
  std::stable_sort(rules.begin(), rules.end(), [](const Rule& a, const Rule& b) { return a.at < b.at; });
  std::vector<Rule> kept;
  for (const Rule& rule : rules) {
    if (kept.empty() || rule.at - kept.back().at > 1e-6)
      kept.push_back(rule);
    else if (rule.width > kept.back().width)
      kept.back() = rule;
  }
  rules = std::move(kept);
}

class Relief {
 public:
  Relief(const CurveSetting& setting, const dvec2& page) : setting_(setting), box_(page) {
    std::vector<double> all;
    for (const Warp warp : {Warp::lispsm, Warp::gmnpr, warp_}) append_values(warp, all);
    levels_ = surface_levels(all);
    if (levels_.empty()) levels_ = {1.0, 2.0};
    low_ = std::log(std::min(levels_.front(), least(all))) - 0.1, high_ = std::log(levels_.back()) + 0.35;
    rule();
  }

  DrawList list() {
    walls();
    // The lines of a strip of cells follow the next strip, whose cells would cover half of them.
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      strip(i, &Relief::faces);
      if (i > 0) strip(i - 1, &Relief::lines);
    }
    curtains();
    axes();
    names();
    return box_.list();
  }

 private:
  static double least(const std::vector<double>& values) {
    double least = INFINITY;
    for (const double value : values)
      if (value > 0.0) least = std::min(least, value);
    return least;
  }

  double theta_of(double u) const { return std::max(kLeastTheta, 90.0 * u); }
  double z_of(double v) const { return setting_.range.n * std::pow(setting_.range.f / setting_.range.n, v); }
  double v_of(double z) const { return std::log(z / setting_.range.n) / std::log(setting_.range.f / setting_.range.n); }
  double height_of(double f) const { return (std::log(f) - low_) / (high_ - low_); }
  double value(double u, double v, Warp warp) const {
    return curve_value(CurveKind::relief, setting_.range, theta_of(u), std::min(z_of(v), setting_.range.f), warp);
  }
  double height(double u, double v) const { return height_of(value(u, v, warp_)); }

  /// What the scale of heights goes by; it is the same for LiSPSM and GMNPR, which the figure compares.
  void append_values(Warp warp, std::vector<double>& values) const {
    for (int i = 0; i <= kColumns; ++i)
      for (int j = 0; j <= kRows; ++j) values.push_back(value(double(i) / kColumns, double(j) / kRows, warp));
  }

  /// The grid: even steps, and the lines that are drawn: round values, theta = phi, and the experiment's own theta.
  void rule() {
    for (int i = 0; i <= kColumns; ++i) columns_.push_back({double(i) / kColumns});
    for (int j = 0; j <= kRows; ++j) rows_.push_back({double(j) / kRows});
    for (const double angle : angle_ticks(0.0, 90.0, 9)) columns_.push_back({angle / 90.0, Role::text, 0.7});
    for (const double z : z_ticks()) rows_.push_back({v_of(z), Role::text, 0.7});
    columns_.push_back({setting_.range.phi_deg / 90.0, Role::neutral, 2.2});
    columns_.push_back({folded(setting_.theta_deg) / 90.0, Role::light, 3.0});
    sort_unique(columns_), sort_unique(rows_);
  }
  std::vector<double> z_ticks() const { return plot_ticks(setting_.range.n, setting_.range.f, true, 7); }

  double shade(std::size_t band) const { return 0.05 + 0.8 * double(band) / double(levels_.size()); }

  /// The part of a triangle between two heights, which cut it along lines.
  static std::vector<dvec3> between(const std::array<dvec3, 3>& corners, double low, double high) {
    std::vector<dvec3> part(corners.begin(), corners.end());
    for (const double side : {1.0, -1.0}) {
      const double limit = side > 0.0 ? low : high;
      std::vector<dvec3> kept;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const dvec3 a = part[i], b = part[(i + 1) % part.size()];
        const double over_a = side * (a.z - limit), over_b = side * (b.z - limit);
        if (over_a >= 0.0) kept.push_back(a);
        if ((over_a < 0.0) != (over_b < 0.0)) kept.push_back(a + over_a / (over_a - over_b) * (b - a));
      }
      part = std::move(kept);
    }
    return part;
  }

  void triangle(const std::array<dvec3, 3>& corners) {
    for (std::size_t band = 0; band <= levels_.size(); ++band) {
      const double low = band == 0 ? 0.0 : height_of(levels_[band - 1]);
      const double high = band == levels_.size() ? 1.0 : height_of(levels_[band]);
      box_.fill(between(corners, low, high), Role::curve_gmnpr, shade(band));
    }
  }
  void contours(const std::array<dvec3, 3>& corners) {
    for (const double level : levels_) {
      const std::vector<dvec3> cut = between(corners, height_of(level), height_of(level));
      for (std::size_t i = 1; i < cut.size(); ++i) box_.stroke(cut[i - 1], cut[i], Role::text, 1.5);
    }
  }

  /// The part of a line of the grid below the top.
  void ruled(const Rule& rule, dvec3 a, dvec3 b) {
    if (!(rule.width > 0.0)) return;
    if (a.z > b.z) std::swap(a, b);
    if (a.z >= 1.0 || b.z < 0.0) return;
    if (b.z > 1.0) b = glm::mix(a, b, (1.0 - a.z) / (b.z - a.z));
    box_.stroke(a, b, rule.role, rule.width);
  }

  /// A cell's corners, from the farthest around.
  using Corners = std::array<dvec3, 4>;
  void strip(std::size_t i, void (Relief::*draw)(std::size_t, std::size_t, const Corners&)) {
    for (std::size_t j = 0; i + 1 < columns_.size() && j + 1 < rows_.size(); ++j) {
      const Corners corners{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      if (std::isfinite(corners[0].z + corners[1].z + corners[2].z + corners[3].z)) (this->*draw)(i, j, corners);
    }
  }
  dvec3 at(std::size_t i, std::size_t j) const {
    const double u = columns_[i].at, v = rows_[j].at;
    return {u, v, std::max(0.0, height(u, v))};
  }
  void faces(std::size_t, std::size_t, const Corners& c) { triangle({c[0], c[1], c[3]}), triangle({c[1], c[2], c[3]}); }
  void lines(std::size_t i, std::size_t j, const Corners& c) {
    contours({c[0], c[1], c[3]}), contours({c[1], c[2], c[3]});
    ruled(columns_[i], c[0], c[3]), ruled(rows_[j], c[0], c[1]);
    ruled(columns_[i + 1], c[1], c[2]), ruled(rows_[j + 1], c[3], c[2]);
  }

  /// What closes the relief towards the eye, down to the floor.
  void curtains() {
    const auto curtain = [&](const dvec3& a, const dvec3& b) {
      if (!std::isfinite(a.z + b.z)) return;
      const auto at_most = [](dvec3 p, double z) { return dvec3(p.x, p.y, std::clamp(p.z, 0.0, z)); };
      const dvec3 top_a = at_most(a, 1.0), top_b = at_most(b, 1.0);
      box_.fill({at_most(a, 0.0), at_most(b, 0.0), top_b, top_a}, Role::neutral, 0.22);
      box_.stroke(top_a, top_b, Role::text, 1.5);
    };
    const auto top = [&](double u, double v) { return dvec3(u, v, height(u, v)); };
    for (std::size_t i = 0; i + 1 < columns_.size(); ++i) curtain(top(columns_[i].at, 1.0), top(columns_[i + 1].at, 1.0));
    for (std::size_t j = 0; j + 1 < rows_.size(); ++j) curtain(top(1.0, rows_[j].at), top(1.0, rows_[j + 1].at));
  }

  /// The far sides of the box, with a line for each level.
  void walls() {
    for (const double level : levels_) {
      const double z = height_of(level);
      wall_line({0, 1, z}, {0, 0, z}), wall_line({0, 0, z}, {1, 0, z});
    }
    for (const dvec2& foot : {dvec2(0, 0), dvec2(1, 0), dvec2(0, 1)}) wall_line({foot, 0}, {foot, 1});
    wall_line({0, 1, 0}, {0, 0, 0}), wall_line({0, 0, 0}, {1, 0, 0});
    wall_line({0, 1, 1}, {0, 0, 1}), wall_line({0, 0, 1}, {1, 0, 1});
  }
  void wall_line(const dvec3& a, const dvec3& b) { box_.stroke(a, b, Role::neutral, 0.8); }

  void axes() {
    box_.line({0, 1, 0}, {1, 1, 0}), box_.line({1, 1, 0}, {1, 0, 0}), box_.line({0, 1, 0}, {0, 1, 1});
    const dvec2 front = box_.at({1, 1, 0}), left = box_.at({0, 1, 0}), right = box_.at({1, 0, 0});
    const auto most = [](const dvec2& a, const dvec2& b) { return std::max(2, int(std::abs(a.y - b.y) / (0.75 * kLine))); };
    for (const double angle : angle_ticks(0.0, 90.0, most(left, front)))
      box_.text(box_.at({angle / 90.0, 1, 0}) + dvec2(-4, 2), tick_text(angle) + "°", Role::neutral, {1.0, 0.0});
    for (const double z : plot_ticks(setting_.range.n, setting_.range.f, true, most(right, front)))
      box_.text(box_.at({1, v_of(z), 0}) + dvec2(4, 2), tick_text(z), Role::neutral, {0.0, 0.0});
    double last = INFINITY;
    for (const double level : levels_) {
      const dvec2 at = box_.at({0, 1, height_of(level)});
      if (last - at.y < kLine) continue;
      box_.text(at - dvec2(6, 0), tick_text(level), Role::neutral, {1.0, 0.5});
      last = at.y;
    }
  }

  void names() {
    const double phi = setting_.range.phi_deg;
    const dvec2 left = 0.5 * (box_.at({0, 1, 0}) + box_.at({1, 1, 0})), right = 0.5 * (box_.at({1, 1, 0}) + box_.at({1, 0, 0}));
    box_.text(left + dvec2(-34, 0.9 * kLine), "angle θ", Role::text, {1.0, 0.0});
    box_.text(right + dvec2(34, 0.9 * kLine), "depth z", Role::text, {0.0, 0.0});
    box_.text(ReliefBox::kTopLeft - dvec2(12.0, 6.0), "F, logarithmic;  " + frustum_text(setting_), Role::text, {0.0, 1.0});
    const double theta = folded(setting_.theta_deg);
    const std::string of_light = "θ = " + short_number(theta, 4) + "°", of_phi = "θ = φ = " + short_number(phi, 4) + "°";
    const dvec2 light_end = slice_end(theta);
    dvec2 phi_end = slice_end(phi);
    const double widths = 0.5 * (chart_text_width(of_light) + chart_text_width(of_phi));
    if (std::abs(phi_end.x - light_end.x) < widths && std::abs(phi_end.y - light_end.y) < kLine) phi_end.y = light_end.y - kLine;
    slice_name(light_end, of_light, Role::light);
    if (std::abs(theta - phi) > 0.01) slice_name(phi_end, of_phi, Role::neutral);
  }

  /// The far end of a line of constant theta; not finite where there is none.
  dvec2 slice_end(double theta_deg) const {
    const double u = theta_deg / 90.0, z = height(u, 0.0);
    return std::isnan(z) ? dvec2(NAN) : box_.at({u, 0.0, std::clamp(z, 0.0, 1.0)});
  }
  void slice_name(const dvec2& end, const std::string& words, Role role) {
    if (std::isfinite(end.x)) box_.text(end - dvec2(0, 4.0), words, role, {0.5, 1.0});
  }

  const CurveSetting& setting_;
  ReliefBox box_;  // of (theta, log z, log F): seen from where the relief is low
  Warp warp_ = surface_warp(setting_);
  std::vector<double> levels_;
  double low_ = 0.0, high_ = 1.0;  // of log F
  std::vector<Rule> columns_, rows_;
};

}  // namespace

DrawList relief_list(const CurveSetting& setting, const dvec2& page) { return Relief(setting, page).list(); }

}  // namespace psm
