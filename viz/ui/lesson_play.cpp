// SPDX-License-Identifier: GPL-3.0-or-later
// A step's animation: its button, and the number on its way.
#include <cmath>

#include "scene/light_angles.h"
#include "ui/lesson_context.h"

namespace psm {
namespace {

/// The animated number, read and set.
double animated(const Animation& animation, const Experiment& e) {
  if (animation.path == kThetaControl) return glm::degrees(light_theta(e));
  Experiment copy = e;
  return std::get<NumberRef>(find_field(animation.path)->member)(copy);
}
void set_animated(const Animation& animation, double value, const glm::dvec3& side, Experiment& e) {
  if (animation.path == kThetaControl)
    e.light.to_light = to_light_at(e, glm::radians(value), side);
  else
    std::get<NumberRef>(find_field(animation.path)->member)(e) = value;
}

}  // namespace

void LessonPanel::animation_button(Context& c) {
  if (c.button(play_ ? "■ Stop" : "▶ Play", "lesson.play")) {
    if (play_) return play_.reset();
    play_ = LessonPlay{ImGui::GetTime(), NAN, std::nullopt};
  }
  rest_tooltip("Plays " + c.run().step().animation->path + ".");
}

bool LessonPanel::play(const LessonSession& session, double now, Experiment& e) {
  if (!play_ || !session.run() || !session.run()->step().animation) return play_.reset(), false;
  const Animation& animation = *session.run()->step().animation;
  if (!play_->theta_side) play_->theta_side = theta_side(e);
  const bool taken_over =
      !std::isnan(play_->last) && std::abs(animated(animation, e) - play_->last) > 1e-6 * (1.0 + std::abs(play_->last));
  if (taken_over) return play_.reset(), false;
  const double time = now - play_->start;
  set_animated(animation, animation.at(time), *play_->theta_side, e);
  play_->last = animated(animation, e);
  if (time >= animation.seconds) play_.reset();
  return true;
}

}  // namespace psm
