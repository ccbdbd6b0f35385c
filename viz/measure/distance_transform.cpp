// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/distance_transform.h"

#include <cmath>
#include <limits>

#include "measure/parallel_rows.h"

namespace psm {
namespace {

/// One line of an image: n values, `stride` apart.
void spread_line(float* line, int n, std::size_t stride) {
  struct Parabola {
    int at;
    double height, from;  // the lowest one from here on
  };
  std::vector<Parabola> lowest;
  for (int x = 0; x < n; ++x) {
    const double height = double(line[std::size_t(x) * stride]);
    if (std::isinf(height)) continue;
    double from = -std::numeric_limits<double>::infinity();
    while (!lowest.empty()) {
      const Parabola& p = lowest.back();
      from = ((height + double(x) * x) - (p.height + double(p.at) * p.at)) / (2.0 * (x - p.at));
      if (from > p.from) break;
      lowest.pop_back();
      from = -std::numeric_limits<double>::infinity();
    }
    lowest.push_back({x, height, from});
  }
  if (lowest.empty()) return;
  std::size_t k = 0;
  for (int x = 0; x < n; ++x) {
    while (k + 1 < lowest.size() && lowest[k + 1].from < x) ++k;
    const double d = x - lowest[k].at;
    line[std::size_t(x) * stride] = float(lowest[k].height + d * d);
  }
}

}  // namespace

void spread_squared_distances(std::vector<float>& image, int width, int height) {
  const auto columns = std::size_t(width);
  for_each_row(width, [&](int x) { spread_line(image.data() + x, height, columns); });
  for_each_row(height, [&](int y) { spread_line(image.data() + std::size_t(y) * columns, width, 1); });
}

}  // namespace psm
