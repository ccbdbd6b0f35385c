// SPDX-License-Identifier: GPL-3.0-or-later
// Turning, moving and zooming, as edits of settings. Drags in fractions of the picture's height, to the right and up.
#pragma once

#include <glm/glm.hpp>

#include "draw/view.h"
#include "scene/experiment.h"

namespace psm {

/// The orbit with what was left to the fit written out.
OrbitSettings resolved(const OrbitSettings& orbit, const OrbitCamera& camera);

/// What was grabbed follows the mouse. The whole height is 180 degrees.
void turn(OrbitSettings& orbit, glm::dvec2 drag);
/// `orbit` resolved; the plane of the target follows the mouse.
void pan(OrbitSettings& orbit, const OrbitCamera& camera, glm::dvec2 drag);
/// One wheel step nearer for +1.
void zoom(OrbitSettings& orbit, double steps);

/// The map view; `half_height`: half the picture's height in map clip units.
void pan_map(ViewSettings& view, double half_height, glm::dvec2 drag);
/// Keeps the point `about` (map clip space) where it is.
void zoom_map(ViewSettings& view, double steps, glm::dvec2 about);

/// The experiment's own camera: around its target, to and from it, and along its image plane together with it.
void turn(CameraSettings& camera, glm::dvec2 drag);
void pan(CameraSettings& camera, glm::dvec2 drag);
void dolly(CameraSettings& camera, double steps);

}  // namespace psm
