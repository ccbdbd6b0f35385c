// SPDX-License-Identifier: GPL-3.0-or-later
// What numbers about speed were made with.
#pragma once

#include "measure/hard_case_report.h"

namespace psm {

Machine this_machine();

}  // namespace psm
