// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab measure: numbers about error, with the time that each took.
#pragma once

namespace psm {

struct MeasureArguments {
  bool hard_cases = false, csv = false, json = false;
};

int measure(const MeasureArguments& arguments);

}  // namespace psm
