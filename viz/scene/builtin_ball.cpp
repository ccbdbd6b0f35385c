// SPDX-License-Identifier: GPL-3.0-or-later
// One ball over a plane: its shadow alone tells how high it floats and where. One unit is a metre; the plane is y = 0.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin_scenes.h"
#include "scene/builtin_shapes.h"

namespace psm {
namespace {

enum MaterialIndex { kLightTile, kDarkTile, kBall };

constexpr double kRadius = 0.75, kBottom = 0.9;
constexpr int kTilesEachWay = 6;  // on either side of the origin, a metre and a half wide
constexpr double kTile = 1.5;

/// A chequered floor of low contrast: places can be read off it, and shadows stay the darkest thing on it.
void add_floor(Scene& scene) {
  Mesh tiles[2];
  for (int row = -kTilesEachWay; row < kTilesEachWay; ++row)
    for (int column = -kTilesEachWay; column < kTilesEachWay; ++column) {
      const glm::dvec2 corner(column * kTile, row * kTile);
      shapes::append_tile(tiles[(row + column) & 1], corner, corner + kTile);
    }
  tiles[0].name = "floor_light", tiles[0].material = kLightTile;
  tiles[1].name = "floor_dark", tiles[1].material = kDarkTile;
  for (Mesh& mesh : tiles) scene.meshes.push_back(std::move(mesh));
}

void add_ball(Scene& scene) {
  const shapes::Solid solid = shapes::transformed(shapes::lathe(shapes::Outline().ball(kRadius, 18).points(), 36),
                                                  glm::translate(glm::dmat4(1.0), glm::dvec3(0, kBottom, 0)));
  Mesh mesh = shapes::shaded(solid, glm::radians(60.0));
  mesh.name = "ball", mesh.material = kBall;
  scene.meshes.push_back(std::move(mesh));
}

}  // namespace

Scene make_ball() {
  Scene scene;
  scene.materials = shapes::plain_materials({0xECEAE4u, 0xDAD7CFu, 0xC65D2Eu});
  add_floor(scene);
  add_ball(scene);

  scene.camera =
      CameraSettings{.position = {0.0, 2.6, 8.0}, .target = {0.0, 1.0, 0.0}, .vertical_fov_deg = 40.0, .near = 0.5, .far = 60.0};

  // A lamp, so that moving it, giving it a radius or taking it to infinity shows point, area and parallel light.
  scene.light = LightSettings{.type = LightType::point, .to_light = {-2.2, 6.0, 1.6}, .position = {-2.2, 6.0, 1.6}};
  return scene;
}

}  // namespace psm
