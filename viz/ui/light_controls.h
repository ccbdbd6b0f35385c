// SPDX-License-Identifier: GPL-3.0-or-later
// The light by the quantities that decide its case: a compass dial and theta for directions, the depth w for positions.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "ui/slider.h"
#include "ui/ui_context.h"

namespace psm {

/// What a drag must remember from where it began.
struct LightControls {
  std::optional<glm::dvec3> theta_side;  // the plane in which theta turns, kept where the light crosses the view direction
  std::optional<double> depth_reach;     // the slider's end, kept while its own value moves it
};

/// The marks: theta = phi on either side of the view line, w = 0.
std::vector<Tick> theta_ticks(const Experiment& experiment);

/// Draws what belongs to the light's type and edits `experiment`.
void light_controls(UiContext& ui, LightControls& state, Experiment& experiment);

/// The angle of a directional light alone.
void theta_slider(UiContext& ui, LightControls& state, Experiment& experiment);

/// A disc: the sky seen from above, its rim the horizon. Lights below the horizon show as a ring.
bool light_dial(UiContext& ui, Experiment& experiment);

}  // namespace psm
