// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows as a picture file, drawn by the same code as `psmlab render`.
#pragma once

#include <filesystem>
#include <memory>

#include "scene/result.h"
#include "ui/shown_views.h"

namespace psm {

/// .png, .svg or .pdf: the views; .mp4 or .gif: the animation of the lesson's step.
Result<std::unique_ptr<ViewsWriter>> shown_views_writer(const std::filesystem::path& file, const ShownViews& shown);

}  // namespace psm
