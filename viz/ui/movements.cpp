// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/movements.h"

#include <utility>

#include "scene/experiment_between.h"

namespace psm {
namespace {

constexpr double kShiftSeconds = 0.6, kCubeSeconds = 2.0, kRevealSeconds = 0.6;
constexpr const char* kRevealTag = "reveal";

}  // namespace

std::optional<NumberPlay> Movements::start(const char* path, double from, double to, double seconds, double now, bool still) {
  model_.end_gesture();
  const auto control = find_control(path, model_.experiment());
  if (!control) return std::nullopt;
  return NumberPlay{{path, from, to, seconds}, *control, still ? now - seconds : now};
}

std::optional<std::string> Movements::play_camera_shift(double now, bool still) {
  Experiment ruled = model_.experiment();
  if (!shifts_camera(ruled.shadow.technique)) return "only PSM, PSM divided and PSM recipe shift the camera";
  // A shift that has been played, or set by hand, is a number: the rule that was last seen is played again.
  if (const ShiftRule* rule = std::get_if<ShiftRule>(&ruled.shadow.camera_shift)) played_rule_ = *rule;
  ruled.shadow.camera_shift = played_rule_;
  const double shift = analyze(ruled, model_.scene()).camera_shift;
  if (shift == 0.0) return std::string("camera shift ") + name_of(played_rule_) + " is 0 here";
  shift_ = start("shadow.camera_shift", 0.0, shift, kShiftSeconds, now, still);
  return std::nullopt;
}

void Movements::play_world_to_cube(double now, bool still) {
  const double now_at = model_.experiment().view.world_to_cube;
  cube_ = start("view.world_to_cube", now_at, now_at > 0.5 ? 0.0 : 1.0, kCubeSeconds, now, still);
}

void Movements::play_reveal(const Experiment& to, double now) {
  model_.end_gesture();
  reveal_ = Reveal{now, model_.experiment(), to, model_.experiment()};
}

bool Movements::finish_reveal(double now) {
  if (!reveal_) return false;
  model_.commit(std::exchange(reveal_, std::nullopt)->to, kRevealTag, now);
  model_.end_gesture();
  return true;
}

bool Movements::move_reveal(Experiment& edited, double now) {
  if (!reveal_) return false;
  if (edited != reveal_->last) return reveal_.reset(), false;
  const double part = (now - reveal_->start) / kRevealSeconds;
  edited = reveal_->last = made_valid(model_.experiment(), between(reveal_->from, reveal_->to, eased(part)));
  if (part >= 1.0) reveal_.reset();
  return true;
}

std::string Movements::move(Experiment& edited, double now) {
  std::string tag;
  if (move_number(shift_, edited, now)) tag = "play camera shift";
  if (move_number(cube_, edited, now)) tag = "play world to cube";
  if (move_reveal(edited, now)) tag = kRevealTag;
  return tag;
}

}  // namespace psm
