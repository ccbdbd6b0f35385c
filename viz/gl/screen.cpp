// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/screen.h"

#include <algorithm>
#include <array>

#include "gl/gl_objects.h"
#include "gl/gl_state.h"
#include "gl/view_target.h"

namespace psm {

struct Screen::State {
  glm::ivec2 size{1};
  // Only for a texture; a window has its own framebuffer.
  struct Offscreen {
    gl::Framebuffer framebuffer;
    gl::GlTexture color;
    glm::ivec2 size{0};
    void resize(glm::ivec2 wanted);
  };
  std::unique_ptr<Offscreen> offscreen;
  GLuint framebuffer() const { return offscreen ? offscreen->framebuffer.get() : 0; }
};

void Screen::State::Offscreen::resize(glm::ivec2 wanted) {
  if (wanted == size) return;
  size = wanted;
  glBindTexture(GL_TEXTURE_2D, color.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color.get(), 0);
}

Screen::Screen(Target target) : state_(std::make_unique<State>()) {
  if (target == Target::texture) state_->offscreen = std::make_unique<State::Offscreen>();
}

Screen::~Screen() = default;

void Screen::begin(glm::ivec2 size, const glm::vec3& srgb) {
  size = gl::allowed_size(size);
  state_->size = size;
  if (state_->offscreen) state_->offscreen->resize(size);
  gl::reset_state();
  glBindFramebuffer(GL_FRAMEBUFFER, state_->framebuffer());
  glViewport(0, 0, size.x, size.y);
  const std::array<float, 4> rgba{srgb.r, srgb.g, srgb.b, 1.0f};
  glClearBufferfv(GL_COLOR, 0, rgba.data());
}

Image Screen::read() const {
  const glm::ivec2 size = state_->size;
  const std::size_t row = std::size_t(size.x) * 4;
  std::vector<std::uint8_t> bottom_up(row * std::size_t(size.y));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, state_->framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, bottom_up.data());
  Image image{size.x, size.y, std::vector<std::uint8_t>(bottom_up.size())};
  for (int y = 0; y < size.y; ++y)
    std::copy_n(bottom_up.begin() + std::ptrdiff_t(row) * y, row, image.rgba.begin() + std::ptrdiff_t(row) * (size.y - 1 - y));
  // A window may have no alpha of its own, and blending leaves any: what one sees is opaque.
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

const char* Screen::glsl_version() { return epoxy_is_desktop_gl() ? "#version 150" : "#version 300 es"; }

}  // namespace psm
