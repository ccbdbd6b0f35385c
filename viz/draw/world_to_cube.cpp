// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/world_to_cube.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/projective.h"

namespace psm {
namespace {

/// How far a body reaches, seen from the eye: depths, and sideways from the view axis.
struct Reach {
  double near, far, aside;
};

Reach reach_of(const ConvexBody& body, const Analysis& a) {
  const glm::dvec4 right = row(a.view_from_world, 0), up = row(a.view_from_world, 1), depth = row(a.cube_from_world, 3);
  const CameraSettings& camera = a.experiment.camera;
  if (body.empty()) {
    const double to_target = std::max(camera.near, glm::dot(depth, {camera.target, 1.0}));
    return {to_target, to_target, to_target};
  }
  Reach reach{std::numeric_limits<double>::infinity(), camera.near, 0.0};
  for (const glm::dvec3& vertex : body.vertices) {
    const glm::dvec4 p(vertex, 1.0);
    const double d = glm::dot(depth, p);
    reach.near = std::min(reach.near, d);
    reach.far = std::max(reach.far, d);
    reach.aside = std::max({reach.aside, std::abs(glm::dot(right, p)), std::abs(glm::dot(up, p))});
  }
  reach.near = std::clamp(reach.near, camera.near, reach.far);
  return reach;
}

/// x to the right, y up, z away from the eye, as in the cube; the body within [-1, 1]^3.
glm::dmat4 similarity(const Reach& reach, const Analysis& a) {
  const double scale = 1.0 / std::max({reach.aside, 0.5 * (reach.far - reach.near), 1e-3 * reach.far});
  glm::dvec4 along = row(a.cube_from_world, 3);
  along.w -= 0.5 * (reach.near + reach.far);
  return from_rows<double>(scale * row(a.view_from_world, 0), scale * row(a.view_from_world, 1), scale * along, {0, 0, 0, 1});
}

}  // namespace

WorldToCube world_to_cube(const Analysis& a) {
  const double t = a.experiment.view.world_to_cube;
  if (t == 1.0) return {a.cube_from_world, glm::dmat4(1.0), 0.0};
  const Reach reach = reach_of(a.receivers_body.empty() ? a.scene_body : a.receivers_body, a);
  const double d0 = std::sqrt(reach.near) * std::sqrt(reach.far);
  const glm::dmat4 world = (1.0 - t) * d0 * similarity(reach, a);
  return {world + t * a.cube_from_world, world * glm::inverse(a.cube_from_world) + glm::dmat4(t), (1.0 - t) / t * d0};
}

}  // namespace psm
