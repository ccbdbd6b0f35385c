// SPDX-License-Identifier: GPL-3.0-or-later
// What the eye sees in the middle of each cell of the coarse grid, read back from the card without waiting for it.
#pragma once

#include <optional>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/scene_buffers.h"
#include "gl/scene_pass.h"
#include "scene/analysis.h"

namespace psm::gl {

class VisiblePass {
 public:
  VisiblePass();
  ~VisiblePass();
  VisiblePass(const VisiblePass&) = delete;
  VisiblePass& operator=(const VisiblePass&) = delete;

  /// Draws the scene at kVisibleColumns x kVisibleRows and orders the copy; an earlier question is forgotten.
  void ask(const Analysis& analysis, const SceneBuffers& scene, ScenePass& pass);
  /// The answer, in world space, once: nothing while it has not arrived.
  std::optional<std::vector<SurfacePoint>> take();

 private:
  void forget();

  Framebuffer framebuffer_;
  Renderbuffer position_, normal_, depth_;
  Buffer copy_;
  GLsync arrived_ = nullptr;
  glm::dmat4 world_from_local_{1.0};
  glm::dvec3 eye_{0.0};
};

}  // namespace psm::gl
