// SPDX-License-Identifier: GPL-3.0-or-later
// Whole text files of a lesson.
#pragma once

#include <filesystem>
#include <string>

#include "scene/result.h"

namespace psm {

/// Errors start with the file's name. At most 1 MiB; anything but UTF-8 is an error with its line.
Result<std::string> read_text_file(const std::filesystem::path& file);

}  // namespace psm
