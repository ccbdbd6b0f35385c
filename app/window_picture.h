// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows as a picture file, drawn by the same code as `psmlab render`.
#pragma once

#include <filesystem>
#include <optional>

#include "scene/result.h"
#include "ui/shown_views.h"

namespace psm {

/// .png, .svg or .pdf: the views; .mp4 or .gif: the animation of the lesson's step. Needs a current OpenGL context.
std::optional<InputError> write_shown_views(const std::filesystem::path& file, const ShownViews& shown);

}  // namespace psm
