// SPDX-License-Identifier: GPL-3.0-or-later
// What can be grabbed in the world view: the camera, its target, the light, its target, the sun of a directional light, and the
// vanishing plane.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "draw/view.h"
#include "scene/experiment.h"

namespace psm {

enum class HandleKind { camera_position, camera_target, light_position, light_target, sun, plane };

struct Handle {
  HandleKind kind = HandleKind::camera_position;
  glm::dvec3 position{0.0};  // world space
  glm::dvec2 pixel{0.0};     // of the picture, y downwards
};

const char* name_of(HandleKind kind);
Role role_of(HandleKind kind);

/// Those in front of the viewer, whether or not they lie on the picture. `world`: the picture of the world view.
std::vector<Handle> handles(const ViewPicture& world, const Experiment& experiment, glm::ivec2 size);

/// Whether the picture itself writes a name at this place.
bool is_labelled(const Handle& handle, const ViewPicture& world, glm::ivec2 size);

/// The nearest one within `reach` pixels.
std::optional<Handle> picked_handle(const std::vector<Handle>& handles, glm::dvec2 pixel, double reach);

/// Where a drag began.
struct HandleDrag {
  Handle handle;
  Experiment before;
  OrbitCamera camera;  // of the world view, which stays while a handle moves
  glm::ivec2 size{1};
  glm::dvec2 start{0.0};  // pixels
  glm::dvec4 plane{0.0};  // that the world view shows
};

/// The experiment with the handle moved to where the mouse is now: in the plane through the handle parallel to the picture, or
/// along the world's vertical if `vertical`. The sun turns around the middle of the view. A light within `snap_pixels` of where
/// its w is 0 snaps there. The vanishing plane, from then on technique custom's own, follows its handle and keeps passing through
/// the light: a sun's moves along its normal, a lamp's turns; `vertical` turns a sun's about the light's direction.
Experiment dragged(const HandleDrag& drag, glm::dvec2 pixel, bool vertical, double snap_pixels = 0.0);

}  // namespace psm
