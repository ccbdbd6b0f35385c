// SPDX-License-Identifier: GPL-3.0-or-later
// The profile as text: each stage with its times, or why it was left out; and what the visible points cost and bring.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "math/shadow_map.h"
#include "ui/depth_readback.h"
#include "ui/profile.h"
#include "ui/ui_context.h"

namespace psm {

/// What fits to what is visible would gain over fits to bounds, for this experiment's technique.
struct FitGain {
  Range<double> bounds, visible;              // eye depths of R, and of the visible points that face the light
  std::optional<double> m_bounds, m_visible;  // 95th percentile over these points of the texel size m, in pixels
};
/// Nothing where no visible point is known.
std::optional<FitGain> fit_gain(const Model& model);

class ProfilePanel {
 public:
  /// `show`: opens and scrolls to it; `hide`: closes it.
  void draw(UiContext& ui, Profile& profile, const DepthReadback& readback, std::optional<bool> show);

 private:
  void update_gain(const Model& model, Profile& profile);

  std::uint64_t gain_of_ = 0;  // analysis
  std::optional<FitGain> gain_;
};

}  // namespace psm
