// SPDX-License-Identifier: GPL-3.0-or-later
// How far somebody has come in each lesson, kept between runs.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "lesson/lesson_run.h"

namespace psm {

using ProgressByLesson = std::map<std::string, LessonProgress>;  // by the lesson's name

/// An absent file is an empty one. The error says in one line what is wrong; progress then starts afresh. The first version's
/// files counted finished steps without saying which: only a lesson that was finished stays so.
Result<ProgressByLesson> read_progress(const std::filesystem::path& file);

/// Written whole or not at all.
std::optional<InputError> write_progress(const ProgressByLesson& progress, const std::filesystem::path& file);

}  // namespace psm
