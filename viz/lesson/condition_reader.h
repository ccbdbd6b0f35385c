// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities and conditions from lesson.json. Private to viz/lesson.
#pragma once

#include "lesson/member_reader.h"

namespace psm {

Quantity read_quantity(const MemberReader& json);

/// `besides`: members that the object may have for other purposes.
Condition read_condition(const MemberReader& json, const std::vector<std::string>& besides);

}  // namespace psm
