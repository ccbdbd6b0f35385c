// SPDX-License-Identifier: GPL-3.0-or-later
// What moves by itself for a moment: the camera shift (key A), the cube view on its way to the world and back (key W), and what a
// lesson reveals.
#include <imgui.h>

#include <algorithm>

#include "scene/experiment_between.h"
#include "ui/workbench.h"

namespace psm {
namespace {

constexpr double kRevealSeconds = 0.6;
constexpr const char* kRevealTag = "reveal";

/// 0 at the start, 1 at the end and after, gently at both.
double eased(double now, double start, double seconds) {
  const double t = std::clamp((now - start) / seconds, 0.0, 1.0);
  return t < 1.0 ? t * t * (3.0 - 2.0 * t) : 1.0;
}

}  // namespace

double Workbench::played(double now, double start, double seconds) const {
  return settings_.reduced_motion ? 1.0 : eased(now, start, seconds);
}

void Workbench::play_camera_shift() {
  Experiment ruled = model_.experiment();
  if (!shifts_camera(ruled.shadow.technique)) {
    message_ = "only PSM, PSM divided and PSM recipe shift the camera";
    return;
  }
  // A shift that has been played, or set by hand, is a number: the rule that was last seen is played again.
  if (const ShiftRule* rule = std::get_if<ShiftRule>(&ruled.shadow.camera_shift)) played_rule_ = *rule;
  ruled.shadow.camera_shift = played_rule_;
  const double shift = analyze(ruled, model_.scene()).camera_shift;
  if (shift == 0.0) {
    message_ = std::string("camera shift ") + name_of(played_rule_) + " is 0 here";
    return;
  }
  model_.end_gesture();
  shift_play_ = ShiftPlay{ImGui::GetTime(), shift, model_.experiment().shadow.camera_shift};
}

void Workbench::play_world_to_cube() {
  const double now_at = model_.experiment().view.world_to_cube;
  model_.end_gesture();
  cube_play_ = CubePlay{ImGui::GetTime(), now_at, now_at > 0.5 ? 0.0 : 1.0, now_at};
}

void Workbench::move_camera_shift(Experiment& edited, std::string& tag, double now) {
  if (!shift_play_) return;
  if (edited.shadow.camera_shift != shift_play_->last) return shift_play_.reset();
  const double way = played(now, shift_play_->start, 0.6);
  edited.shadow.camera_shift = shift_play_->last = way * shift_play_->end_shift;
  tag = "play camera shift";
  wake();
  if (way == 1.0) shift_play_.reset();
}

void Workbench::move_world_to_cube(Experiment& edited, std::string& tag, double now) {
  if (!cube_play_) return;
  if (edited.view.world_to_cube != cube_play_->last) return cube_play_.reset();
  const double way = played(now, cube_play_->start, 2.0);
  edited.view.world_to_cube = cube_play_->last =
      way < 1.0 ? cube_play_->from + way * (cube_play_->to - cube_play_->from) : cube_play_->to;
  tag = "play world to cube";
  wake();
  if (way == 1.0) cube_play_.reset();
}

/// Undone as one step. Another scene has nothing in common with this one: it is there at once.
void Workbench::play_reveal(const Experiment& to) {
  finish_reveal();
  drag_ = {};
  model_.end_gesture();
  if (settings_.reduced_motion || to.scene != model_.experiment().scene) return commit_now(to);
  reveal_ = Reveal{ImGui::GetTime(), model_.experiment(), to, model_.experiment()};
  wake();
}

/// At once at its end; whether there was one.
bool Workbench::finish_reveal() {
  if (!reveal_) return false;
  model_.commit(std::exchange(reveal_, std::nullopt)->to, kRevealTag, ImGui::GetTime());
  model_.end_gesture();
  return true;
}

void Workbench::move_reveal(Experiment& edited, std::string& tag, double now) {
  if (!reveal_) return;
  wake();
  if (edited != reveal_->last) return reveal_.reset();  // the user has taken over
  const double way = played(now, reveal_->start, kRevealSeconds);
  edited = reveal_->last = made_valid(model_.experiment(), way < 1.0 ? between(reveal_->from, reveal_->to, way) : reveal_->to);
  tag = kRevealTag;
  if (way == 1.0) reveal_.reset();
}

}  // namespace psm
