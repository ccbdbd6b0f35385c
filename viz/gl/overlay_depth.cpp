// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/overlay_depth.h"

#include <bit>
#include <cstdint>

namespace psm::gl {

void OverlayDepth::reserve(glm::ivec2 size) {
  if (size.x <= reserved_.x && size.y <= reserved_.y) return;
  reserved_ = glm::max(size, reserved_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, depth_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, reserved_.x, reserved_.y, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.get());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.get(), 0);
}

void OverlayDepth::take(const MultisampleTarget& scene, glm::ivec2 size, const PixelRect& rect) {
  size_ = size;
  rect_ = rect;
  reserve(size);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, scene.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.get());
  blit(rect, GL_DEPTH_BUFFER_BIT);
}

void OverlayDepth::bind(Program& program) const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, depth_.get());
  program.set("u_depth", 0);
  program.set("u_first_pixel", glm::ivec2(rect_.left, rect_.bottom));
  program.set("u_last_pixel", glm::ivec2(rect_.right, rect_.top) - 1);
}

std::vector<float> OverlayDepth::read() const {
  if (!any()) return {};
  // ES 3.0 reads neither depth nor float textures back, but it reads unsigned integers: the bits of the floats.
  const Framebuffer framebuffer;
  const Renderbuffer bits;
  glBindRenderbuffer(GL_RENDERBUFFER, bits.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32UI, size_.x, size_.y);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, bits.get());
  glViewport(0, 0, size_.x, size_.y);
  bits_program_.use();
  bind(bits_program_);
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);

  std::vector<std::uint32_t> texels(std::size_t(size_.x) * std::size_t(size_.y) * 4);
  glReadPixels(0, 0, size_.x, size_.y, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.data());
  std::vector<float> rows(texels.size() / 4);
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x)
      rows[std::size_t(y) * size_.x + x] = std::bit_cast<float>(texels[(std::size_t(size_.y - 1 - y) * size_.x + x) * 4]);
  return rows;
}

}  // namespace psm::gl
