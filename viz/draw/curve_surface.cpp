// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/curve_surface.h"

#include <algorithm>
#include <cmath>

#include "draw/sketch.h"

namespace psm {
namespace {

constexpr int kColumns = 180, kRows = 100;
constexpr double kMostAboveLeast = 150.0;

/// F at the corners of a grid over theta (degrees) and z (equal ratios).
class Grid {
 public:
  Grid(const CurveSetting& setting, Warp warp) : range_(setting.range), warp_(warp) {
    values_.reserve((kColumns + 1) * (kRows + 1));
    for (int i = 0; i <= kColumns; ++i)
      for (int j = 0; j <= kRows; ++j) values_.push_back(value(place(i, j)));
  }
  double theta(int i) const { return 90.0 * i / kColumns; }
  double z(int j) const { return j == kRows ? range_.f : range_.n * std::pow(range_.f / range_.n, double(j) / kRows); }
  double at(int i, int j) const { return values_[std::size_t(i * (kRows + 1) + j)]; }
  glm::dvec2 place(int i, int j) const { return {theta(i), z(j)}; }
  double value(const glm::dvec2& at) const { return curve_value(CurveKind::surface, range_, at.x, at.y, warp_); }
  const std::vector<double>& values() const { return values_; }

 private:
  CurveRange range_;
  Warp warp_;
  std::vector<double> values_;
};

/// Runs of one band along each column.
void add_bands(const Grid& grid, const std::vector<double>& levels, Chart& chart) {
  const auto band = [&](int i, int j) {
    const double v =
        std::sqrt(std::sqrt(grid.at(i, j) * grid.at(i + 1, j)) * std::sqrt(grid.at(i, j + 1) * grid.at(i + 1, j + 1)));
    return std::isnan(v) ? -1 : int(std::upper_bound(levels.begin(), levels.end(), v) - levels.begin());
  };
  const double step = 0.85 / double(levels.size() + 1);
  for (int i = 0; i < kColumns; ++i)
    for (int j = 0; j < kRows;) {
      const int here = band(i, j);
      int end = j + 1;
      while (end < kRows && band(i, end) == here) ++end;
      if (here >= 0) chart.cells.push_back({grid.place(i, j), grid.place(i + 1, end), 0.03 + step * here, Role::curve_gmnpr});
      j = end;
    }
}

/// Where F has this level between two corners of a cell, by bisection.
bool crossing(const Grid& grid, const int (&from)[2], const int (&to)[2], double level, glm::dvec2& at) {
  const double v_a = grid.at(from[0], from[1]), v_b = grid.at(to[0], to[1]);
  if (!((v_a < level) != (v_b < level)) || std::isnan(v_a) || std::isnan(v_b)) return false;
  glm::dvec2 a = grid.place(from[0], from[1]), b = grid.place(to[0], to[1]);
  for (int i = 0; i < 12; ++i) {
    at = 0.5 * (a + b);
    ((grid.value(at) < level) == (v_a < level) ? a : b) = at;
  }
  return true;
}

void add_level(const Grid& grid, double level, Chart& chart) {
  ChartLevel out{tick_text(level), {}, Role::text};
  for (int i = 0; i < kColumns; ++i)
    for (int j = 0; j < kRows; ++j) {
      const int corner[4][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}};
      std::vector<glm::dvec2> points;
      for (int k = 0; k < 4; ++k) {
        const auto& a = corner[k];
        const auto& b = corner[(k + 1) % 4];
        glm::dvec2 p;
        if (crossing(grid, a, b, level, p)) points.push_back(p);
      }
      for (std::size_t k = 1; k < points.size(); k += 2) out.segments.push_back({points[k - 1], points[k]});
    }
  if (!out.segments.empty()) chart.levels.push_back(std::move(out));
}

}  // namespace

Warp surface_warp(const CurveSetting& setting) { return setting.current.value_or(Warp::gmnpr); }

std::vector<double> surface_levels(const std::vector<double>& values) {
  double low = INFINITY, high = 0.0;
  for (const double v : values)
    if (std::isfinite(v) && v > 0.0) low = std::min(low, v), high = std::max(high, v);
  high = std::min(high, low * kMostAboveLeast);
  std::vector<double> levels;
  if (!(low < high)) return levels;
  for (int e = int(std::floor(std::log10(low))); e <= int(std::ceil(std::log10(high))); ++e)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double level = digit * std::pow(10.0, e);
      if (level > low && level < high) levels.push_back(level);
    }
  return levels;
}

void add_surface(const CurveSetting& setting, Chart& chart) {
  const Grid grid(setting, surface_warp(setting));
  const std::vector<double> levels = surface_levels(grid.values());
  add_bands(grid, levels, chart);
  for (const double level : levels) add_level(grid, level, chart);
}

}  // namespace psm
