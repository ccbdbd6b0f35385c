// SPDX-License-Identifier: GPL-3.0-or-later
// How long drawing takes, by the wall clock and by the graphics card's own.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace psm {

/// Seconds.
struct PassTime {
  double wall = 0;            // from the first call until all of it was drawn
  std::optional<double> gpu;  // the card's timer query; nothing where the driver has none, or where it was disturbed
};

/// Needs a current context, which outlives it.
class PassTimer {
 public:
  PassTimer();
  ~PassTimer();
  PassTimer(const PassTimer&) = delete;
  PassTimer& operator=(const PassTimer&) = delete;

  /// Waits until everything before it is drawn, then calls `draw` and waits again.
  PassTime time(const std::function<void()>& draw) const;

 private:
  std::uint32_t query_ = 0;  // 0: no timer queries here
};

/// What the driver calls itself: renderer and version.
std::string gl_renderer_name();

}  // namespace psm
