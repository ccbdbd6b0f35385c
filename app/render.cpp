// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/assets.h"
#include "app/caption.h"
#include "measure/visible_image.h"

namespace psm {
namespace {

constexpr int kSmallestTile = 16;

struct Colors {
  glm::vec3 ground, text;
};

Colors colors_of(Theme theme) {
  if (theme == Theme::dark) return {glm::vec3(0.12f), glm::vec3(0.92f)};
  return {glm::vec3(0.86f), glm::vec3(0.08f)};
}

Image filled(const glm::ivec2& size, const glm::vec3& color) {
  Image image{size.x, size.y, std::vector<std::uint8_t>(std::size_t(size.x) * size.y * 4, 255)};
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 < 3) image.rgba[i] = std::uint8_t(std::lround(color[int(i % 4)] * 255.0f));
  return image;
}

void paste(const Image& part, const glm::ivec2& origin, Image& whole) {
  for (int y = 0; y < part.height; ++y)
    std::memcpy(&whole.rgba[(std::size_t(origin.y + y) * whole.width + origin.x) * 4],
                &part.rgba[std::size_t(y) * part.width * 4], std::size_t(part.width) * 4);
}

/// The last line of a picture of several views: what kind of light it is, and the technique.
std::string status_text(const Analysis& analysis) {
  return light_case_text(analysis) + "   |   " + name_of(analysis.technique_used);
}

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

Image draw_views(const LoadedExperiment& loaded, const RenderRequest& request, const RenderLayout& layout) {
  const Analysis analysis = analyze(loaded.experiment, loaded.scene, RayTracer(loaded.scene));
  Renderer renderer(assets_folder(), font_file());
  renderer.set_scene(loaded.scene);
  renderer.draw_shadow_map(analysis);
  const auto view_image = [&](const ViewPicture& picture) {
    renderer.draw_view(picture, analysis, layout.tile, request.scale, request.theme);
    return renderer.read_view(picture.id);
  };
  if (request.views.size() == 1) return view_image(describe_view(request.views[0], analysis, loaded.scene, layout.tile));

  const Colors colors = colors_of(request.theme);
  Image whole = filled(request.size, colors.ground);
  for (std::size_t i = 0; i < request.views.size(); ++i)
    paste(view_image(describe_view(request.views[i], analysis, loaded.scene, layout.tile)), layout.origins[i], whole);
  const Caption caption(font_file(), 18 * request.scale);
  const int inset = int(std::lround(5 * request.scale));
  caption.draw(whole, inset, request.size.y - layout.status_height + inset, status_text(analysis), colors.text);
  return whole;
}

}  // namespace psm
