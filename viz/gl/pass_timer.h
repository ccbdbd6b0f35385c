// SPDX-License-Identifier: GPL-3.0-or-later
// How long drawing takes, by the wall clock and by the graphics card's own.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// The card's time for each of several stages of a frame, without ever waiting for it: what a stage cost is known some frames
/// later. Needs a current context, which outlives it; stages follow one another, they do not nest.
class StageTimers {
 public:
  explicit StageTimers(std::size_t stages) : stages_(stages) {}
  ~StageTimers();
  StageTimers(const StageTimers&) = delete;
  StageTimers& operator=(const StageTimers&) = delete;

  /// Around a stage. Not measured: a stage whose last time has not arrived yet, and all where the driver has no timer queries.
  void begin(std::size_t stage);
  void end();
  /// Takes what has arrived.
  void poll();
  /// Something is still to arrive; false once a driver has had so many polls that it never will.
  bool waiting() const;
  /// Seconds, of the last time that has arrived.
  std::optional<double> gpu(std::size_t stage) const { return stages_[stage].gpu; }

 private:
  struct Stage {
    std::uint32_t query = 0;
    bool running = false, pending = false;
    int polls = 0;
    std::optional<double> gpu;
  };
  std::vector<Stage> stages_;
};

/// What the driver calls itself: renderer and version.
std::string gl_renderer_name();

}  // namespace psm
