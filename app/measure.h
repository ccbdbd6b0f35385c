// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab measure: numbers about error, with the time that each took.
#pragma once

#include "app/commands.h"

namespace psm {

struct MeasureArguments {
  ExperimentArguments experiment;
  std::optional<std::string> techniques, resolutions, theta_deg, far;  // lists, as typed
  bool equal_error = false;
  bool hard_cases = false, csv = false, json = false;
};

int measure(const MeasureArguments& arguments);

}  // namespace psm
