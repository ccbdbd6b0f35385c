// SPDX-License-Identifier: GPL-3.0-or-later
// The OpenGL state around a draw call: whoever drew before or draws after (Dear ImGui, a test) shares the context.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <string>

namespace psm::gl {

/// Starts from a known state; puts framebuffers and viewport back, and leaves everything else at OpenGL's defaults.
class StateGuard {
 public:
  StateGuard();
  ~StateGuard();
  StateGuard(const StateGuard&) = delete;
  StateGuard& operator=(const StateGuard&) = delete;

 private:
  GLint draw_framebuffer_ = 0, read_framebuffer_ = 0;
  std::array<GLint, 4> viewport_{};
};

/// Everything back to OpenGL's defaults, but for framebuffers and viewport.
void reset_state();

/// Opaque results stay opaque: alpha accumulates, colour blends.
void enable_blending();

/// The names of all pending errors, empty if there are none; for tests and debug builds.
std::string take_errors();

/// Prints pending errors and stops, in debug builds.
void check_errors(const char* where);

}  // namespace psm::gl
