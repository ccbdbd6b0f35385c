// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/assets.h"
#include "app/caption.h"
#include "draw/probe.h"
#include "gl/error_view.h"
#include "measure/pick.h"

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

std::optional<Probe> probe_at(const RayTracer& tracer, const Analysis& analysis, const glm::dvec2& pixel) {
  const auto pick = pick_pixel(tracer, analysis, pixel);
  return pick ? make_probe(analysis, pick->receiver, pick->occluder, pick->seen) : std::nullopt;
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
  const RayTracer tracer(loaded.scene);
  const Analysis analysis = analyze_with_statistics(loaded.experiment, loaded.scene, tracer);
  const ViewSettings& view = loaded.experiment.view;
  const std::optional<Probe> probe = view.probe ? probe_at(tracer, analysis, *view.probe) : std::nullopt;
  Renderer renderer(assets_folder(), font_file());
  renderer.set_scene(loaded.scene);
  renderer.draw_shadow_map(analysis);
  const auto view_image = [&](ViewId id) {
    ViewPicture picture = describe_view(id, analysis, loaded.scene, layout.tile);
    if (id == ViewId::eye && view.eye_overlay == EyeOverlay::errors)
      show_errors(picture, compare_with_truth(renderer, tracer, analysis, kAllPixels));
    if (probe) append(picture.list, probe_list(*probe, id, analysis, layout.tile));
    renderer.draw_view(picture, analysis, layout.tile, request.scale, request.theme);
    return renderer.read_view(picture.id);
  };
  if (request.views.size() == 1) return view_image(request.views[0]);

  const Colors colors = colors_of(request.theme);
  Image whole = filled(request.size, colors.ground);
  for (std::size_t i = 0; i < request.views.size(); ++i) paste(view_image(request.views[i]), layout.origins[i], whole);
  const Caption caption(font_file(), 18 * request.scale);
  const int inset = int(std::lround(5 * request.scale));
  caption.draw(whole, inset, request.size.y - layout.status_height + inset, status_text(analysis), colors.text);
  return whole;
}

}  // namespace psm
