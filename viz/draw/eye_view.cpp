// SPDX-License-Identifier: GPL-3.0-or-later
// What the eye sees: the experiment's own image, letterboxed.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "draw/sketch.h"

namespace psm {

ViewPicture describe_eye(const Analysis& analysis, glm::ivec2 size) {
  const double ratio = analysis.experiment.image.aspect() / aspect_of(size);
  const glm::dvec2 half(std::min(1.0, ratio), std::min(1.0, 1.0 / ratio));
  ViewPicture picture;
  picture.id = ViewId::eye;
  picture.title = (analysis.cube_maps_from_world ? "Eye, six maps" : "Eye") + map_remark(analysis);
  picture.image_rect = {-half, half};
  picture.clip_from_list = glm::scale(glm::dmat4(1.0), glm::dvec3(half, 1.0));
  picture.clip_from_world = picture.clip_from_list * analysis.clip_from_world();

  // The list is in the image's own normalised coordinates; the light is the one thing that the image itself does not show.
  const glm::dvec4 light = analysis.clip_from_world() * analysis.light;
  const glm::dvec3 p = glm::dvec3(light) / light.w;
  if (light.w > 0.0 && std::abs(p.x) <= 1.0 && std::abs(p.y) <= 1.0 && p.z >= -1.0) {
    const glm::dvec4 shown(p.x, p.y, std::min(p.z, 1.0 - 1e-6), 1.0);
    picture.list.points.push_back({shown, Role::light, 6.5});
    picture.list.labels.push_back({shown, "light", Role::light, 10});
  }
  return picture;
}

}  // namespace psm
