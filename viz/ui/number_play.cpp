// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/number_play.h"

#include <cmath>

namespace psm {
namespace {

/// An angle that is read comes back with a rounding of its own wherever the camera has moved.
bool taken_over(const NumberPlay& play, const Experiment& experiment) {
  const double range = std::abs(play.animation.from) + std::abs(play.animation.to);
  return play.last && !(std::abs(play.control.value(experiment) - *play.last) <= 1e-6 * range);
}

}  // namespace

bool move_number(std::optional<NumberPlay>& play, Experiment& experiment, double now) {
  if (!play) return false;
  const double time = now - play->start;
  if (taken_over(*play, experiment) || play->control(experiment, play->animation.at(time))) return play.reset(), false;
  play->last = play->control.value(experiment);
  if (time >= play->animation.seconds) play.reset();
  return true;
}

}  // namespace psm
