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
  RenderLayout layout;
  const int count = int(request.views.size()), columns = count > 1 ? 2 : 1, rows = (count + columns - 1) / columns;
  if (count > 1) {
    layout.status_height = int(std::lround(28 * request.scale));
    layout.gap = std::max(1, int(std::lround(4 * request.scale)));
  }
  layout.tile.x = (request.size.x - (columns - 1) * layout.gap) / columns;
  layout.tile.y = (request.size.y - layout.status_height - (rows - 1) * layout.gap) / rows;
  const int smallest = count > 1 ? kSmallestTile : 1;
  if (layout.tile.x < smallest || layout.tile.y < smallest)
    return InputError{"--size: " + std::to_string(request.size.x) + "x" + std::to_string(request.size.y) + " is too small for " +
                      std::to_string(count) + " views; allowed: at least " +
                      std::to_string(columns * (smallest + layout.gap) - layout.gap) + "x" +
                      std::to_string(rows * (smallest + layout.gap) - layout.gap + layout.status_height)};
  for (int i = 0; i < count; ++i)
    layout.origins.push_back({(i % columns) * (layout.tile.x + layout.gap), (i / columns) * (layout.tile.y + layout.gap)});
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
  if (loaded.experiment.view.compare) {
    add_compared_panels(sheet, shared, request.views, layout.origins, layout.tile);
    return sheet;
  }
  for (std::size_t i = 0; i < request.views.size(); ++i)
    sheet.panels.push_back({shared, request.views[i], false, std::nullopt, {}, layout.origins[i], layout.tile});
  return sheet;
}

}  // namespace psm
