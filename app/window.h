// SPDX-License-Identifier: GPL-3.0-or-later
// The real window: GLFW, the event loop, and idle waiting.
#pragma once

#include <optional>
#include <string>

#include "scene/experiment_file.h"

namespace psm {

/// False where no window can be opened (no display).
bool display_available();

/// Opens the window on this experiment and runs until it is closed. `lesson`: see WorkbenchOptions. `present`: in front of a
/// class, at once. An error if the window cannot be opened.
std::optional<InputError> run_window(const LoadedExperiment& loaded, const std::string& lesson, bool present);

}  // namespace psm
