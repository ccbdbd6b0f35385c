// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psm {

/// Who tells analyze() what the eye sees: rays, in the same frame; or the card's depth, read back without waiting, some frames
/// later (PSM 2002, section 6).
enum class PointsSource { rays, depth };

}  // namespace psm
