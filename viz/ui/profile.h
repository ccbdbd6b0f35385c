// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame computed, how long that took, and why it left out the rest.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "gl/pass_timer.h"
#include "scene/experiment.h"

namespace psm {

/// In the order of a frame.
enum class Stage {
  points,
  analysis,
  scene,
  map,
  truth,
  view_world,
  view_cube,
  view_map,
  view_eye,
  view_body,
  view_curves,
  view_explorer,
  compare,
  texels,
  gain,
  interface
};
inline constexpr std::size_t kStages = 16;

const char* name_of(Stage stage);
Stage stage_of(ViewId view);

struct StageRun {
  bool ran = false;
  std::string why;               // it did not run
  std::optional<double> cpu_ms;  // of the last time that it ran
};

/// One frame. Everything that is not reported is taken for unchanged.
using FrameProfile = std::array<StageRun, kStages>;

class Profile {
 public:
  /// Times on the card are asked for only while somebody looks.
  void watch(bool watched) { watched_ = watched; }
  bool watched() const { return watched_; }

  void begin_frame();
  /// Runs it, with the clocks around it; needs a current context.
  template <class Work>
  void run(Stage stage, Work&& work) {
    const auto start = Clock::now();
    begin_gpu(stage);
    work();
    end_gpu();
    ran(stage, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  /// It was timed by whoever ran it.
  void ran(Stage stage, double cpu_ms);
  void skipped(Stage stage, const std::string& why);
  void end_frame();

  /// The last frame that has ended.
  const FrameProfile& last() const { return last_; }
  /// The last frame that computed anything but what the interface and the profile itself need, and how many have been drawn
  /// since.
  const FrameProfile& busy() const { return busy_; }
  std::uint64_t frames_since_busy() const { return frames_since_busy_; }
  std::optional<double> gpu_ms(Stage stage) const;
  /// Times are on their way from the card: they are shown by a frame after this one.
  bool waiting() const { return watched_ && timers_ && timers_->waiting(); }

 private:
  using Clock = std::chrono::steady_clock;
  void begin_gpu(Stage stage);
  void end_gpu();
  double computed_ms() const;  // in this frame

  bool watched_ = false;
  Clock::time_point frame_start_;
  FrameProfile now_, last_, busy_;
  std::uint64_t frames_since_busy_ = 0;
  std::unique_ptr<StageTimers> timers_;
};

}  // namespace psm
