// SPDX-License-Identifier: GPL-3.0-or-later
// Where views are drawn: a multisampled framebuffer that all views share, resolved into each view's own texture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/seen_rect.h"

namespace psm::gl {

/// RGBA8 and 24-bit depth, four samples where there are that many; grows to the largest view.
class MultisampleTarget {
 public:
  MultisampleTarget();
  void reserve(glm::ivec2 size);
  /// Bound afterwards. To this colour and the far end, in `rect` at least: clearing all is the fastest where most is asked for.
  void clear(const PixelRect& rect, const glm::vec4& rgba) const;
  GLuint framebuffer() const { return framebuffer_.get(); }

 private:
  Framebuffer framebuffer_;
  Renderbuffer color_, depth_;
  glm::ivec2 size_{0};
  GLint samples_ = 0;
};

/// One view's picture: an RGBA8 texture, first row at the bottom, reallocated only when the size changes.
class ViewTarget {
 public:
  void resize(glm::ivec2 size);
  /// The rest of it stays.
  void resolve_from(const MultisampleTarget& source, const PixelRect& rect);
  GLuint framebuffer() const { return framebuffer_.get(); }
  GLuint texture() const { return texture_.get(); }
  glm::ivec2 size() const { return size_; }
  std::vector<std::uint8_t> read_top_to_bottom() const;

 private:
  Framebuffer framebuffer_;
  GlTexture texture_;
  glm::ivec2 size_{0};
};

/// RGBA8 and depth with one sample a pixel, bound and cleared to zeros and the far end; for pictures whose pixels are numbers.
class PlainTarget {
 public:
  explicit PlainTarget(glm::ivec2 size);
  std::vector<std::uint8_t> read_top_to_bottom() const;

 private:
  Framebuffer framebuffer_;
  Renderbuffer color_, depth_;
  glm::ivec2 size_;
};

/// Of the framebuffer in use, to this colour and the far end.
void clear(const PixelRect& rect, const glm::vec4& rgba);

/// The same pixels of the framebuffer that is bound for reading to the one bound for drawing: resolves samples.
void blit(const PixelRect& rect, GLbitfield buffers);

/// At least 1x1, at most what this context can draw to.
glm::ivec2 allowed_size(glm::ivec2 size);

}  // namespace psm::gl
