// SPDX-License-Identifier: GPL-3.0-or-later
// The names of an experiment's choices, in the order of their enums. Private to experiment*.cpp.
#pragma once

#include <array>

#include "scene/experiment.h"

namespace psm {

inline constexpr std::array kLightTypes{"directional", "point", "spot"};
inline constexpr std::array kTechniques{
    "uniform",         "psm",           "lispsm",     "lispsm_reference", "glpr",        "gmnpr",        "minimax",
    "minimax_frustum", "plane_optimal", "best_plane", "psm_recipe",       "psm_divided", "psm_two_maps", "custom"};
inline constexpr std::array kShiftRules{"auto", "in_front", "inside"};
inline constexpr std::array kEyeOverlays{"none", "texel_size", "anisotropy", "errors", "penumbra"};
inline constexpr std::array kCulls{"none", "front", "back"};
inline constexpr std::array kFilters{"none", "hardware", "pcf"};
inline constexpr std::array kCurveKindNames{"lambda",  "log_lambda", "rho", "F_max",   "E_max", "E_frustum",
                                            "storage", "F_z",        "E_z", "surface", "relief"};
static_assert(kCurveKindNames.size() == kCurveKinds);
inline constexpr std::array kViews{"world", "cube", "map", "eye", "body", "curves", "explorer"};
static_assert(kViews.size() == kAllViews.size());

}  // namespace psm
