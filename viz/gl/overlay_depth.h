// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's depth with one sample a pixel, pushed back a little: what is drawn over a view is tested against it.
#pragma once

#include <filesystem>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/view_target.h"

namespace psm::gl {

class OverlayDepth {
 public:
  explicit OverlayDepth(const std::filesystem::path& shaders)
      : push_program_(shaders, "fullscreen", "overlay_depth"), bits_program_(shaders, "fullscreen", "overlay_depth_bits") {}

  /// Takes the lower left `size` pixels of `scene` and gives `target` its depth; `target` is bound afterwards.
  void attach(const MultisampleTarget& scene, const ViewTarget& target);

  /// Binds `target` for what needs no depth.
  void leave_out(const ViewTarget& target);

  /// In [0, 1], rows top to bottom: of what was attached last; empty where it was left out.
  std::vector<float> read() const;

 private:
  void reserve(glm::ivec2 size);

  Program push_program_;
  mutable Program bits_program_;
  VertexArray no_vertices_;
  Framebuffer resolved_framebuffer_;
  GlTexture resolved_, pushed_;
  glm::ivec2 reserved_{0}, size_{0};
};

}  // namespace psm::gl
