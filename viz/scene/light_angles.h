// SPDX-License-Identifier: GPL-3.0-or-later
// The light seen from the camera: the quantities that decide the light case, and how to set them. No widgets.
#pragma once

#include <glm/glm.hpp>

#include "scene/experiment.h"

namespace psm {

glm::dvec3 view_forward(const CameraSettings& camera);  // unit

/// Angle between the view direction and the direction to the light, in [0, pi]; w = 0 at pi/2.
double light_theta(const Experiment& experiment);

/// Unit, perpendicular to the view direction: the side towards which the light turns when theta grows. For a light along the view
/// direction: upwards.
glm::dvec3 theta_side(const Experiment& experiment);

/// to_light of the same length at this angle in the plane of the view direction and `side`. Exact at pi/2.
glm::dvec3 to_light_at(const Experiment& experiment, double theta, const glm::dvec3& side);

/// The light at this angle from the view direction, in the plane it is in; a position turns around `middle`, at which its angle
/// is taken.
Experiment with_light_at(const Experiment& experiment, double theta, const glm::dvec3& middle);

/// Half opening angle of the frustum in the plane of the view direction and the light (FORMULAS section 1: phi_eff).
double phi_towards_light(const Experiment& experiment);

/// w = v.(l - e) of a point or spot light: its depth in front of the camera plane.
double light_depth(const Experiment& experiment);

/// The light's position moved along the view direction to this depth. Exact at 0 up to rounding.
glm::dvec3 position_at_depth(const Experiment& experiment, double depth);

/// The light as another type, where it was: positions give directions as seen from its target or from `middle`; a direction gives
/// a position at `distance` from `middle`, at which a new spot aims.
LightSettings with_type(const LightSettings& light, LightType type, const glm::dvec3& middle, double distance);

/// Compass direction and height of the light above the horizon (world y up), and back. Azimuth 0 is +z, 90 degrees is +x.
struct Bearing {
  double azimuth = 0.0, elevation = 0.0;  // radians
};
Bearing bearing_of(const glm::dvec3& to_light);
glm::dvec3 direction_of(const Bearing& bearing);  // unit

}  // namespace psm
