// SPDX-License-Identifier: GPL-3.0-or-later
// Everything about a lesson that reading it alone does not prove.
#pragma once

#include "lesson/evaluate.h"

namespace psm {

struct LessonSurroundings {
  Analyze analyze;
  std::function<bool(char32_t)> has_glyph;  // of the font that shows lessons
  std::vector<std::string> lessons;         // the names that links may lead to
};

/// Experiments are valid, formulas can be shown, links lead somewhere, answers exist, tasks can be done and are not done at
/// once, claims hold. Each error is one line that starts with file and line; none: the lesson is fine.
std::vector<InputError> check_lesson(const Lesson& lesson, const LessonSurroundings& surroundings);

/// What the step's experiment is made of, before a scene is loaded: the lesson's base, and its own members; where it continues,
/// those of the step before lie between.
ExperimentMembers members_at_start(const Lesson& lesson, std::size_t step);

/// The members that "set:light.to_light=0,1,1&light.type=directional" sets.
Result<ExperimentMembers> members_of_link(const std::string& link);

}  // namespace psm
