// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/depth_readback.h"

#include <chrono>

namespace psm {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

}  // namespace

void DepthReadback::take(Model& model, Renderer& renderer, Profile& profile) {
  if (model.points_source() != PointsSource::depth) asked_.reset();
  if (!asked_) return;
  ++frames_waited_;
  const auto start = Clock::now();
  auto points = renderer.take_visible_points();
  if (!points) return profile.skipped(Stage::points, "on their way from the card");
  delay_ = frames_waited_;
  const double ms = ask_ms_ + ms_since(start);
  profile.ran(Stage::points, ms);
  model.set_visible_points(std::move(*points), *asked_, ms);
  asked_.reset();
}

// What is on its way is let in first, even if the eye has moved on: while one drags, that is the freshest there is.
void DepthReadback::ask(const Model& model, Renderer& renderer, Profile& profile) {
  if (model.points_source() != PointsSource::depth || asked_ || model.points_sight() == model.sight()) return;
  const auto start = Clock::now();
  profile.run(Stage::points, [&] { renderer.ask_for_visible_points(model.analysis()); });
  ask_ms_ = ms_since(start);
  asked_ = model.sight();
  frames_waited_ = 0;
}

}  // namespace psm
