// SPDX-License-Identifier: GPL-3.0-or-later
// The pane at the right: scene and technique on top, below them every member of the experiment, the numbers and the notes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/keys.h"
#include "ui/light_controls.h"
#include "ui/ui_context.h"

namespace psm {

/// What widgets ask the workbench to do once the frame is over.
struct Requests {
  std::optional<std::string> open;  // a source for Model::open
  std::optional<Action> action;
};

/// The scrolling part's members. Edits `experiment`.
void control_fields(UiContext& ui, LightControls& light, Experiment& experiment);

/// What the selector offers, in its order.
const std::vector<Technique>& offered_techniques();

/// The technique as menus and badges write it: "LiSPSM code".
const char* display_name(Technique technique);

/// The selectors above the fields; drawn after the analysis, because it says which technique was used.
void control_header(UiContext& ui, Experiment& experiment, Requests& requests);
float control_header_height(float pane_width);

}  // namespace psm
