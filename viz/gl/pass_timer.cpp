// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/pass_timer.h"

#include <epoxy/gl.h>

#include <algorithm>
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

bool arrived(GLuint query) {
  GLuint available = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
  return available != 0;
}

constexpr int kMostPolls = 60;

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

StageTimers::~StageTimers() {
  for (const Stage& stage : stages_)
    if (stage.query) glDeleteQueries(1, &stage.query);
}

void StageTimers::begin(std::size_t index) {
  Stage& stage = stages_[index];
  if (stage.pending || !has_timer_queries()) return;
  if (!stage.query) glGenQueries(1, &stage.query);
  glBeginQuery(GL_TIME_ELAPSED, stage.query);
  stage.running = true;
}

void StageTimers::end() {
  for (Stage& stage : stages_) {
    if (!stage.running) continue;
    glEndQuery(GL_TIME_ELAPSED);
    stage.running = false, stage.pending = true, stage.polls = 0;
  }
}

void StageTimers::poll() {
  const bool useless = waiting() && disturbed();
  for (Stage& stage : stages_) {
    if (!stage.pending) continue;
    ++stage.polls;
    if (!arrived(stage.query)) continue;
    const double seconds = elapsed(stage.query);
    stage.gpu = useless ? std::nullopt : std::optional<double>(seconds);
    stage.pending = false;
  }
}

bool StageTimers::waiting() const {
  return std::any_of(stages_.begin(), stages_.end(), [](const Stage& s) { return s.pending && s.polls < kMostPolls; });
}

std::string gl_renderer_name() { return std::string(text_of(GL_RENDERER)) + ", " + text_of(GL_VERSION); }

}  // namespace psm
