// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile.h"

#include <algorithm>

namespace psm {
namespace {

bool computes(const FrameProfile& frame) {
  return std::any_of(frame.begin(), frame.end() - 3, [](const StageRun& run) { return run.ran; });
}

}  // namespace

const char* name_of(Stage stage) {
  constexpr const char* names[kStages] = {
      "visible points", "analysis",  "scene upload", "shadow map", "truth (rays)", "world view", "cube view",       "map view",
      "eye view",       "body view", "curves",       "explorer",   "technique B",  "all texels", "gain of the fit", "interface"};
  return names[std::size_t(stage)];
}

Stage stage_of(ViewId view) { return Stage(int(Stage::view_world) + int(view)); }

void Profile::begin_frame() {
  frame_start_ = Clock::now();
  if (timers_) timers_->poll();
  for (StageRun& run : now_) run.ran = false, run.why = "unchanged";
}

void Profile::begin_gpu(Stage stage) {
  if (!watched_) return;
  if (!timers_) timers_ = std::make_unique<StageTimers>(kStages);
  timers_->begin(std::size_t(stage));
}

void Profile::end_gpu() {
  if (timers_) timers_->end();
}

void Profile::ran(Stage stage, double cpu_ms) { now_[std::size_t(stage)] = {true, "", cpu_ms}; }

void Profile::skipped(Stage stage, const std::string& why) {
  StageRun& run = now_[std::size_t(stage)];
  run.ran = false;
  run.why = why;
}

double Profile::computed_ms() const {
  double sum = 0.0;
  for (const StageRun& run : now_)
    if (run.ran) sum += run.cpu_ms.value_or(0.0);
  return sum;
}

// The interface is what nobody else has taken of the frame.
void Profile::end_frame() {
  const double all = std::chrono::duration<double, std::milli>(Clock::now() - frame_start_).count();
  ran(Stage::interface, std::max(0.0, all - computed_ms()));
  last_ = now_;
  const bool busy = computes(now_);
  if (busy) busy_ = now_;
  frames_since_busy_ = busy ? 0 : frames_since_busy_ + 1;
}

std::optional<double> Profile::gpu_ms(Stage stage) const {
  const auto seconds = timers_ ? timers_->gpu(std::size_t(stage)) : std::nullopt;
  return seconds ? std::optional<double>(*seconds * 1e3) : std::nullopt;
}

}  // namespace psm
