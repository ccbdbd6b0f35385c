// SPDX-License-Identifier: GPL-3.0-or-later
// Where a frame of the window is composed: the window itself, or a texture where there is none.
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "gl/renderer.h"

namespace psm {

/// Needs a current context, which outlives it.
class Screen {
 public:
  enum class Target { window, texture };
  explicit Screen(Target target);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// Binds and clears the frame. `size` in pixels, at least 1x1; `srgb` is written as it is.
  void begin(glm::ivec2 size, const glm::vec3& srgb);

  /// What was drawn since begin(); of a window before its buffers are swapped.
  Image read() const;

  /// The #version line that shaders need in this context.
  static const char* glsl_version();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace psm
