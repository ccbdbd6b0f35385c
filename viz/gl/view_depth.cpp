// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/view_depth.h"

#include <bit>
#include <cstdint>

namespace psm::gl {
namespace {

/// One sample a pixel of the depth of `source`.
void resolve_depth(const MultisampleTarget& source, glm::ivec2 size, const GlTexture& depth) {
  glBindTexture(GL_TEXTURE_2D, depth.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size.x, size.y, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const Framebuffer framebuffer;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.get());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.get(), 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, source.framebuffer());
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

}  // namespace

std::vector<float> ViewDepth::read(const MultisampleTarget& source, glm::ivec2 size) {
  const GlTexture depth;
  glActiveTexture(GL_TEXTURE0);
  resolve_depth(source, size, depth);
  // ES 3.0 reads neither depth nor float textures back, but it reads unsigned integers: the bits of the floats.
  const Framebuffer framebuffer;
  const Renderbuffer bits;
  glBindRenderbuffer(GL_RENDERBUFFER, bits.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32UI, size.x, size.y);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, bits.get());
  glViewport(0, 0, size.x, size.y);
  program_.use();
  program_.set("u_depth", 0);
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);

  std::vector<std::uint32_t> texels(std::size_t(size.x) * std::size_t(size.y) * 4);
  glReadPixels(0, 0, size.x, size.y, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.data());
  std::vector<float> rows(texels.size() / 4);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      rows[std::size_t(y) * size.x + x] = std::bit_cast<float>(texels[(std::size_t(size.y - 1 - y) * size.x + x) * 4]);
  return rows;
}

}  // namespace psm::gl
