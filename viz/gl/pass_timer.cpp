// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/pass_timer.h"

#include <epoxy/gl.h>

#include <chrono>

namespace psm {
namespace {

bool has_timer_queries() {
  if (epoxy_is_desktop_gl()) return epoxy_gl_version() >= 33 || epoxy_has_gl_extension("GL_ARB_timer_query");
  return epoxy_has_gl_extension("GL_EXT_disjoint_timer_query");
}

/// Whether something (a change of clock, sleep) made the card's clock useless since the last call.
bool disturbed() {
  if (epoxy_is_desktop_gl()) return false;
  GLint disjoint = 0;
  glGetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint);
  return disjoint != 0;
}

double elapsed(GLuint query) {
  GLuint64 nanoseconds = 0;
  if (epoxy_is_desktop_gl())
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
  else
    glGetQueryObjectui64vEXT(query, GL_QUERY_RESULT_EXT, &nanoseconds);
  return double(nanoseconds) * 1e-9;
}

const char* text_of(GLenum name) {
  const auto text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "unknown";
}

}  // namespace

PassTimer::PassTimer() {
  if (has_timer_queries()) glGenQueries(1, &query_);
}

PassTimer::~PassTimer() {
  if (query_) glDeleteQueries(1, &query_);
}

PassTime PassTimer::time(const std::function<void()>& draw) const {
  using Clock = std::chrono::steady_clock;
  glFinish();
  if (query_) disturbed();  // forgets what was before
  const auto start = Clock::now();
  if (query_) glBeginQuery(GL_TIME_ELAPSED, query_);
  draw();
  if (query_) glEndQuery(GL_TIME_ELAPSED);
  glFinish();
  PassTime time{std::chrono::duration<double>(Clock::now() - start).count(), {}};
  if (!query_) return time;
  const double gpu = elapsed(query_);
  if (!disturbed()) time.gpu = gpu;
  return time;
}

std::string gl_renderer_name() { return std::string(text_of(GL_RENDERER)) + ", " + text_of(GL_VERSION); }

}  // namespace psm
