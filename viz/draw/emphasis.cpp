// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/emphasis.h"

#include <algorithm>

namespace psm {

void emphasise(DrawList& list, const Emphasis& emphasis) {
  remove(list, emphasis.hidden);
  const std::vector<Role>& strong = emphasis.strong;
  if (strong.empty()) return;
  const auto faint = [&](Role role) {
    return role != Role::neutral && role != Role::text && std::find(strong.begin(), strong.end(), role) == strong.end();
  };
  const auto named = [&](Role role) { return std::find(strong.begin(), strong.end(), role) != strong.end(); };
  for (DrawLine& line : list.lines) {
    if (faint(line.role)) line.fade_a *= 0.3, line.fade_b *= 0.3;
    if (named(line.role)) line.width *= 1.6;
  }
  for (DrawFill& fill : list.fills) {
    if (faint(fill.role)) fill.alpha *= 0.3;
    if (named(fill.role)) fill.alpha = std::min(1.0, 1.6 * fill.alpha);
  }
  for (DrawLabel& label : list.labels)
    if (named(label.role)) label.priority += 100;
}

}  // namespace psm
