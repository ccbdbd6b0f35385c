// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/view_target.h"

#include <algorithm>

namespace psm::gl {
namespace {

constexpr GLint kSamples = 4;

GLint limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

std::vector<std::uint8_t> read_rows(const Framebuffer& from, glm::ivec2 size) {
  const std::size_t row = std::size_t(size.x) * 4;
  std::vector<std::uint8_t> rgba(row * std::size_t(size.y));
  if (rgba.empty()) return rgba;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.get());
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  for (int top = 0, bottom = size.y - 1; top < bottom; ++top, --bottom) {
    std::swap_ranges(rgba.begin() + std::ptrdiff_t(row) * top, rgba.begin() + std::ptrdiff_t(row) * (top + 1),
                     rgba.begin() + std::ptrdiff_t(row) * bottom);
  }
  return rgba;
}

}  // namespace

glm::ivec2 allowed_size(glm::ivec2 size) {
  const int largest = std::min(limit(GL_MAX_TEXTURE_SIZE), limit(GL_MAX_RENDERBUFFER_SIZE));
  return glm::clamp(size, glm::ivec2(1), glm::ivec2(largest));
}

void clear(const PixelRect& rect, const glm::vec4& rgba) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(rect.left, rect.bottom, std::max(0, rect.right - rect.left), std::max(0, rect.top - rect.bottom));
  const float far_end = 1.0f;
  glClearBufferfv(GL_COLOR, 0, &rgba.r);
  glClearBufferfv(GL_DEPTH, 0, &far_end);
  glDisable(GL_SCISSOR_TEST);
}

void blit(const PixelRect& rect, GLbitfield buffers) {
  glBlitFramebuffer(rect.left, rect.bottom, rect.right, rect.top, rect.left, rect.bottom, rect.right, rect.top, buffers,
                    GL_NEAREST);
}

MultisampleTarget::MultisampleTarget() : samples_(std::min(kSamples, limit(GL_MAX_SAMPLES))) {}

void MultisampleTarget::reserve(glm::ivec2 size) {
  if (size.x <= size_.x && size.y <= size_.y) return;
  size_ = glm::max(size, size_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glBindRenderbuffer(GL_RENDERBUFFER, color_.get());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, size_.x, size_.y);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.get());
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.get());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, size_.x, size_.y);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE || samples_ == 0) return;
  samples_ = 0;  // a driver that promises samples and does not keep it
  size_ = glm::ivec2(0);
  reserve(size);
}

void MultisampleTarget::clear(const PixelRect& rect, const glm::vec4& rgba) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  const std::int64_t asked = std::int64_t(rect.right - rect.left) * (rect.top - rect.bottom);
  gl::clear(2 * asked > std::int64_t(size_.x) * size_.y ? PixelRect{0, 0, size_.x, size_.y} : rect, rgba);
}

void ViewTarget::resize(glm::ivec2 size) {
  if (size == size_) return;
  size_ = size;
  glBindTexture(GL_TEXTURE_2D, texture_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.get(), 0);
}

void ViewTarget::resolve_from(const MultisampleTarget& source, const PixelRect& rect) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, source.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.get());
  blit(rect, GL_COLOR_BUFFER_BIT);
}

std::vector<std::uint8_t> ViewTarget::read_top_to_bottom() const { return read_rows(framebuffer_, size_); }

PlainTarget::PlainTarget(glm::ivec2 size) : size_(size) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glBindRenderbuffer(GL_RENDERBUFFER, color_.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.x, size.y);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.get());
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.x, size.y);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glViewport(0, 0, size.x, size.y);
  const float zeros[4] = {}, far_end = 1.0f;
  glClearBufferfv(GL_COLOR, 0, zeros);
  glClearBufferfv(GL_DEPTH, 0, &far_end);
}

std::vector<std::uint8_t> PlainTarget::read_top_to_bottom() const { return read_rows(framebuffer_, size_); }

}  // namespace psm::gl
