// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/gl_state.h"

#include <cassert>
#include <cstdio>

namespace psm::gl {
namespace {

constexpr int kTextureUnits = 2;  // as many as any pass uses

const char* error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "invalid enum";
    case GL_INVALID_VALUE:
      return "invalid value";
    case GL_INVALID_OPERATION:
      return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "invalid framebuffer operation";
    case GL_OUT_OF_MEMORY:
      return "out of memory";
    default:
      return "unknown error";
  }
}

void unbind_all() {
  glUseProgram(0);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  for (int unit = kTextureUnits - 1; unit >= 0; --unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    glBindSampler(GLuint(unit), 0);
  }
}

void reset_pixel_transfer() {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

}  // namespace

void reset_state() {
  for (const GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_POLYGON_OFFSET_FILL, GL_RASTERIZER_DISCARD,
                                  GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE, GL_SCISSOR_TEST, GL_STENCIL_TEST}) {
    glDisable(capability);
  }
  if (epoxy_is_desktop_gl()) {
    glDisable(GL_FRAMEBUFFER_SRGB);   // the shaders encode
    glEnable(GL_PROGRAM_POINT_SIZE);  // as ES always has it
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glPolygonOffset(0.0f, 0.0f);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ZERO);
  unbind_all();
  reset_pixel_transfer();
}

void enable_blending() {
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

StateGuard::StateGuard() {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_framebuffer_);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer_);
  glGetIntegerv(GL_VIEWPORT, viewport_.data());
  reset_state();
}

StateGuard::~StateGuard() {
  reset_state();
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_framebuffer_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_framebuffer_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

std::string take_errors() {
  std::string names;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    names += (names.empty() ? "" : ", ") + std::string(error_name(error));
    if (names.size() > 200) break;  // a lost context reports errors for ever
  }
  return names;
}

void check_errors([[maybe_unused]] const char* where) {
#ifndef NDEBUG
  const std::string errors = take_errors();
  if (!errors.empty()) std::fprintf(stderr, "OpenGL in %s: %s\n", where, errors.c_str());
  assert(errors.empty());
#endif
}

}  // namespace psm::gl
