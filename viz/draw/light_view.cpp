// SPDX-License-Identifier: GPL-3.0-or-later
// The scene as the light sees it: through the shadow map's own projection.
#include <glm/gtc/matrix_transform.hpp>

#include "draw/sketch.h"

namespace psm {

void show_scene_in_map(ViewPicture& map, const Analysis& analysis) {
  if (!analysis.map_from_world) return;
  map.scene = ScenePicture::shadowed;
  if (map.title.starts_with("Shadow map")) map.title.replace(0, 10, "Light's view");
  // A map with a reversed depth test sees the farthest surface first.
  const double order = analysis.reversed_depth ? -1.0 : 1.0;
  map.clip_from_world = glm::scale(map.clip_from_list, {1.0, 1.0, order}) * *analysis.map_from_world;
  // The outlines have no depth of their own: they stand before the scene.
  map.clip_from_list = glm::translate(glm::dmat4(1.0), {0.0, 0.0, -1.0}) * map.clip_from_list;
  remove(map.list, {Role::texel_grid});
}

}  // namespace psm
