// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render.h"

#include <algorithm>
#include <cmath>

#include "app/compared_sides.h"

namespace psm {
namespace {

constexpr int kSmallestTile = 16;

}  // namespace

Result<RenderLayout> lay_out(const RenderRequest& request) {
  const int count = int(request.views.size()), columns = count > 1 ? 2 : 1, rows = (count + columns - 1) / columns;
  const int status = count > 1 ? int(std::lround(28 * request.scale)) : 0;
  const int gap = count > 1 ? std::max(1, int(std::lround(4 * request.scale))) : 0;
  const glm::ivec2 tile((request.size.x - (columns - 1) * gap) / columns, (request.size.y - status - (rows - 1) * gap) / rows);
  const int smallest = count > 1 ? kSmallestTile : 1;
  if (tile.x < smallest || tile.y < smallest)
    return InputError{"--size: " + std::to_string(request.size.x) + "x" + std::to_string(request.size.y) + " is too small for " +
                      std::to_string(count) + " views; allowed: at least " + std::to_string(columns * (smallest + gap) - gap) +
                      "x" + std::to_string(rows * (smallest + gap) - gap + status)};
  RenderLayout layout{{}, status};
  for (int i = 0; i < count; ++i) {
    const glm::ivec2 corner = glm::ivec2(i % columns, i / columns) * (tile + gap);
    const bool over_both = columns == 2 && i % 2 == 0 && i == count - 1;
    layout.places.push_back({corner, corner + glm::ivec2(over_both ? 2 * tile.x + gap : tile.x, tile.y)});
  }
  return layout;
}

Sheet sheet_of(const LoadedExperiment& loaded, const RenderRequest& request, const RenderLayout& layout) {
  Sheet sheet;
  sheet.size = request.size;
  sheet.scale = request.scale;
  sheet.theme = request.theme;
  sheet.transparent = request.transparent;
  sheet.background = glm::vec3(request.theme == Theme::dark ? 0.12f : 0.86f);
  sheet.title = loaded.scene.id;
  sheet.status_height = layout.status_height;
  const auto shared = std::make_shared<const LoadedExperiment>(loaded);
  if (loaded.experiment.view.compare)
    add_compared_panels(sheet, shared, request.views, layout.places);
  else
    for (std::size_t i = 0; i < request.views.size(); ++i)
      sheet.panels.push_back({shared, request.views[i], std::nullopt, {}, layout.places[i].min, layout.places[i].size()});
  for (SheetPanel& panel : sheet.panels) panel.emphasis = request.emphasis;
  return sheet;
}

}  // namespace psm
