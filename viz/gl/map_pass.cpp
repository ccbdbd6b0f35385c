// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/map_pass.h"

#include <algorithm>
#include <array>

#include "draw/theme.h"

namespace psm::gl {
namespace {

struct MapCorner {
  glm::vec4 clip;
  glm::vec2 map;  // 0 to 1 over the picture
};

}  // namespace

MapPass::MapPass(const std::filesystem::path& shaders)
    : programs_{Program(shaders, "map_depth", "map_depth", "#define EMPTY\n"), Program(shaders, "map_depth", "map_depth"),
                Program(shaders, "map_depth", "map_depth", "#define SHEET\n")},
      corners_(sizeof(MapCorner), {{0, 4, offsetof(MapCorner, clip)}, {1, 2, offsetof(MapCorner, map)}}) {}

void MapPass::draw(const ViewPicture& picture, const ShadowPass& map, double scale, Theme theme) {
  const auto clip = narrow(picture.clip_from_list);
  if (!clip) return;
  const glm::vec2 tiles = map.layers() == 6 ? glm::vec2(3.0f, 2.0f) : glm::vec2(std::max(1, map.layers()), 1.0f);
  const float half_height = tiles.y / tiles.x;
  const auto corner = [&](float u, float v) {
    return MapCorner{*clip * glm::vec4(2.0f * u - 1.0f, (2.0f * v - 1.0f) * half_height, 0.0f, 1.0f), {u, v}};
  };
  const std::array<MapCorner, 6> corners{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)};
  Program& program = programs_[std::size_t(std::min(map.layers(), 2))];
  program.use();
  program.set("u_map", 0);
  program.set("u_blocks", 1);
  program.set("u_tiles", tiles);
  program.set("u_ground", picture_ground(theme));
  program.set("u_scale", float(scale));
  map.bind_for_reading(0);
  map.bind_range(1);
  glDisable(GL_DEPTH_TEST);
  corners_.upload(std::span<const MapCorner>(corners));
  corners_.draw_triangles();
}

}  // namespace psm::gl
