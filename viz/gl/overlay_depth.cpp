// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/overlay_depth.h"

#include <bit>
#include <cstdint>

namespace psm::gl {
namespace {

void allocate(const GlTexture& depth, glm::ivec2 size) {
  glBindTexture(GL_TEXTURE_2D, depth.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size.x, size.y, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

void OverlayDepth::reserve(glm::ivec2 size) {
  if (size.x <= reserved_.x && size.y <= reserved_.y) return;
  reserved_ = glm::max(size, reserved_);
  glActiveTexture(GL_TEXTURE0);
  allocate(resolved_, reserved_);
  allocate(pushed_, reserved_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_framebuffer_.get());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, resolved_.get(), 0);
}

void OverlayDepth::attach(const MultisampleTarget& scene, const ViewTarget& target) {
  size_ = target.size();
  reserve(size_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, scene.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_framebuffer_.get());
  glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);

  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, pushed_.get(), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, resolved_.get());
  push_program_.use();
  push_program_.set("u_depth", 0);
  push_program_.set("u_last_pixel", size_ - 1);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthFunc(GL_LESS);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void OverlayDepth::leave_out(const ViewTarget& target) {
  size_ = {0, 0};
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
}

std::vector<float> OverlayDepth::read() const {
  if (size_.x == 0) return {};
  // ES 3.0 reads neither depth nor float textures back, but it reads unsigned integers: the bits of the floats.
  const Framebuffer framebuffer;
  const Renderbuffer bits;
  glBindRenderbuffer(GL_RENDERBUFFER, bits.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32UI, size_.x, size_.y);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, bits.get());
  glViewport(0, 0, size_.x, size_.y);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, pushed_.get());
  bits_program_.use();
  bits_program_.set("u_depth", 0);
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
