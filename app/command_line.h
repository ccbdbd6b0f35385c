// SPDX-License-Identifier: GPL-3.0-or-later
// The program's commands. Results go to standard output, everything else to standard error.
#pragma once

namespace psm {

/// Exit codes.
constexpr int kDone = 0, kOtherFailure = 1, kBadInput = 2;

int run_command_line(int argc, char** argv);

}  // namespace psm
