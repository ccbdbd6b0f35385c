// SPDX-License-Identifier: GPL-3.0-or-later
// Draws views with OpenGL (ES 3.0 subset). Needs a current context, which outlives it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "draw/image.h"
#include "draw/theme.h"
#include "draw/view.h"
#include "measure/shadow_error.h"
#include "scene/analysis.h"
#include "scene/scene.h"

namespace psm {

/// What is where nothing is drawn: the theme's ground, or nothing, for pictures with a transparent background.
enum class Backdrop { ground, none };

class Renderer {
 public:
  /// `assets`: the folder with shaders/. `font`: a TrueType file for labels. Aborts with a clear line if a shader does not
  /// compile.
  Renderer(const std::filesystem::path& assets, const std::filesystem::path& font);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Uploads the scene; call again when the scene changed.
  void set_scene(const Scene& scene);

  /// Draws the shadow map (or the two, or the six) of this analysis; none where nothing can cast a shadow.
  void draw_shadow_map(const Analysis& analysis);
  /// The same, unless the map would come out as it is; call when the analysis changed.
  void update_shadow_map(const Analysis& analysis);

  /// Draws one view into its own texture and returns the texture's OpenGL name, valid until the next call for the same id.
  /// `size` in pixels; `scale` multiplies widths and type. The texture's first row is the bottom one.
  std::uint32_t draw_view(const ViewPicture& picture, const Analysis& analysis, glm::ivec2 size, double scale, Theme theme,
                          Backdrop backdrop = Backdrop::ground);

  /// What draw_view drew last for this id; colours are not multiplied by their opacity.
  Image read_view(ViewId id);

  /// The depth that lines over what draw_view drew last were tested against, in [0, 1], rows top to bottom, of the size that it
  /// was drawn in; empty where it had neither lines nor points.
  std::vector<float> read_overlay_depth();

  /// What the map that was drawn last says at each pixel of the eye's image, width x height, rows top to bottom, whichever way
  /// the surface faces the light: dark where less than half of the filter's comparisons are lit.
  MapReading read_map(const Analysis& analysis, int width, int height);

  /// Asks the card for what this analysis's eye sees in the middle of each cell of the coarse grid that analyze() takes; never
  /// waits. The answer is there some frames later: points in world space, cells that see nothing left out.
  void ask_for_visible_points(const Analysis& analysis);
  std::optional<std::vector<SurfacePoint>> take_visible_points();

  /// Depth in [0, 1] of layer 0 of the shadow map, rows bottom to top; for tests.
  std::vector<float> read_map_depth();

  /// What the map in use holds: 0 where nothing can cast a shadow, and no map was drawn.
  std::size_t map_triangles() const;
  /// How often a map had to be drawn so far.
  int maps_drawn() const;

  /// Texels along a side of the map that was drawn last: less than the experiment asks for where the card has no room for more.
  int map_resolution() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace psm
