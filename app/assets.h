// SPDX-License-Identifier: GPL-3.0-or-later
// Where the program's files are: the one asset loader.
#pragma once

#include <filesystem>

namespace psm {

/// The folder with shaders/ (share/psmlab/assets beside the program's bin/).
std::filesystem::path assets_folder();

/// The shipped lessons' folder (share/psmlab/lessons).
std::filesystem::path lessons_folder();

/// DejaVu Sans, from its Debian package; exits with a clear line if it is missing.
std::filesystem::path font_file();

}  // namespace psm
