// SPDX-License-Identifier: GPL-3.0-or-later
// The real window: GLFW, the event loop, and idle waiting.
#pragma once

#include <optional>
#include <string>

#include "scene/experiment_file.h"

namespace psm {

/// False where no window can be opened (no display).
bool display_available();

struct WindowStart {
  std::string lesson;             // see WorkbenchOptions
  bool present = false;           // in front of a class, at once
  bool asks_for_nothing = false;  // no experiment, lesson or presentation: the first run says where to begin
};

/// Opens the window on this experiment and runs until it is closed. An error if the window cannot be opened.
std::optional<InputError> run_window(const LoadedExperiment& loaded, const WindowStart& start);

}  // namespace psm
