// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab lesson: lessons are listed and checked without a window.
#pragma once

#include <string>
#include <vector>

#include "draw/emphasis.h"
#include "lesson/check.h"

namespace psm {

/// A line for each shipped lesson: its name, its title, its summary.
int list_lessons();

/// Each file is a lesson's folder, its lesson.json, or the name of a shipped lesson; none: all that are shipped. What is wrong
/// goes to standard error, a line each.
int check_lessons(const std::vector<std::string>& files);

/// A step of a lesson as it begins.
struct LessonPicture {
  LoadedExperiment loaded;
  std::vector<ViewId> views;
  Emphasis emphasis;
  std::optional<Animation> animation;
};
/// `argument`: a lesson as above, "/3" behind it for its third step. `overrides`, as of --set, go over its experiment. Errors
/// start with the flag.
Result<LessonPicture> lesson_picture(const std::string& argument, const std::vector<std::string>& overrides);

/// What --lesson opens can be read: a lesson as above, "/3" behind it for its third step.
std::optional<InputError> check_lesson_argument(const std::string& argument);

/// Analyses as `psmlab analyze` does; keeps the rays' acceleration structure of the scene it saw last.
Analyze ray_traced_analyze();

}  // namespace psm
