// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and lists in arguments and CSV files.
#pragma once

#include <string>
#include <vector>

#include "scene/result.h"

namespace psm {

/// The parts between separators; "" has one empty part.
std::vector<std::string> split(const std::string& text, char separator);

/// "FLAG: 'VALUE' is not allowed; allowed: ...".
InputError flag_error(const char* flag, const std::string& value, const std::string& allowed);

/// An argument as a message shows it: one line, not too long, and visible where it is empty.
std::string quoted_argument(const std::string& text);

/// Any text as one line: control characters become blanks.
std::string one_line(std::string text);

}  // namespace psm
