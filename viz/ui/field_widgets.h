// SPDX-License-Identifier: GPL-3.0-or-later
// One row of widgets for each row of the experiment table.
#pragma once

#include <optional>
#include <string>

#include "scene/experiment.h"
#include "ui/slider.h"
#include "ui/ui_context.h"

namespace psm {

/// "vertical fov" of "camera.vertical_fov_deg"; "world yaw" of "view.world.yaw_deg".
std::string field_label(const Field& field);

/// "camera" of "camera.near".
std::string field_group(const Field& field);

/// Where a number's slider runs for a scene of this size; nothing: no slider but a field to drag or type in.
std::optional<SliderRange> slider_range(const Field& field, double scene_size);

/// Diagonal of the scene's bounds; 1 for an empty or flat-out point-like scene.
double scene_size(const Scene& scene);

/// Lines of widgets that the row takes, at most.
int field_row_lines(const Field& field);

/// Label (field_label() unless given), widget and reset button. Edits `experiment`; the model makes it valid. Nothing is drawn
/// for a field that does not apply.
void field_row(UiContext& ui, const Field& field, Experiment& experiment, const std::string& label = "");

}  // namespace psm
