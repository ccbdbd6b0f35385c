// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "scene/result.h"

namespace psm {

/// Refuses, besides what is not JSON, members given twice, of which a tree would keep one, and more than 16 levels.
std::optional<InputError> check_json(const std::string& text);

}  // namespace psm
