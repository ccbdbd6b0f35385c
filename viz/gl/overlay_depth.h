// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's depth with one sample a pixel, pushed back a little: what is drawn over a view is tested against it, in the
// fragment shaders (overlay_depth.glsl), since few pixels need it.
#pragma once

#include <filesystem>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/view_target.h"

namespace psm::gl {

class OverlayDepth {
 public:
  explicit OverlayDepth(const std::filesystem::path& shaders)
      : bits_program_(shaders, "fullscreen", "overlay_depth_bits", "", "overlay_depth") {}

  /// Of a picture of this size; the scene is in `rect`, not empty.
  void take(const MultisampleTarget& scene, glm::ivec2 size, const PixelRect& rect);
  /// The picture at hand has no scene that hides anything.
  void forget() { size_ = {0, 0}; }
  bool any() const { return size_.x > 0; }

  /// For a program in use that was made with overlay_depth.glsl; takes texture unit 0.
  void bind(Program& program) const;

  /// In [0, 1], rows top to bottom; empty where there is none.
  std::vector<float> read() const;

 private:
  void reserve(glm::ivec2 size);

  mutable Program bits_program_;
  VertexArray no_vertices_;
  Framebuffer framebuffer_;
  GlTexture depth_;
  glm::ivec2 reserved_{0}, size_{0};
  PixelRect rect_;
};

}  // namespace psm::gl
