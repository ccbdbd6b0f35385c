// SPDX-License-Identifier: GPL-3.0-or-later
// Visible points from the card's depth: asked for when the eye or the scene has changed, handed to the model when they arrive.
#pragma once

#include <cstdint>
#include <optional>

#include "gl/renderer.h"
#include "ui/model.h"
#include "ui/profile.h"

namespace psm {

class DepthReadback {
 public:
  /// At the start of a frame: hands over what has arrived, and never waits for it.
  void take(Model& model, Renderer& renderer, Profile& profile);
  /// At the end of a frame; the renderer has the model's scene.
  void ask(const Model& model, Renderer& renderer, Profile& profile);

  /// A question is open: another frame is needed.
  bool waiting() const { return asked_.has_value(); }
  /// Frames between the last answer and its question.
  std::optional<int> delay() const { return delay_; }

 private:
  std::optional<Sight> asked_;
  double ask_ms_ = 0.0;
  int frames_waited_ = 0;
  std::optional<int> delay_;
};

}  // namespace psm
