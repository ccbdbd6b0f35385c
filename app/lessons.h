// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab lesson: lessons are listed and checked without a window.
#pragma once

#include <string>
#include <vector>

#include "lesson/check.h"

namespace psm {

/// A line for each shipped lesson: its name, its title, its summary.
int list_lessons();

/// Each file is a lesson's folder, its lesson.json, or the name of a shipped lesson; none: all that are shipped. What is wrong
/// goes to standard error, a line each.
int check_lessons(const std::vector<std::string>& files);

/// What --lesson opens can be read: a lesson as above, "/3" behind it for its third step.
std::optional<InputError> check_lesson_argument(const std::string& argument);

/// Analyses as `psmlab analyze` does; keeps the rays' acceleration structure of the scene it saw last.
Analyze ray_traced_analyze();

}  // namespace psm
