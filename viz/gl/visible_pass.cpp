// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/visible_pass.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "scene/eye_and_light.h"

namespace psm::gl {
namespace {

constexpr std::size_t kCells = std::size_t(kVisibleColumns) * std::size_t(kVisibleRows);
constexpr std::size_t kPlaneBytes = kCells * 4 * sizeof(std::uint32_t);
constexpr std::array<GLenum, 2> kAttachments{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

void attach(const Renderbuffer& buffer, GLenum format, GLenum attachment) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.get());
  glRenderbufferStorage(GL_RENDERBUFFER, format, kVisibleColumns, kVisibleRows);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.get());
}

glm::dvec3 floats_at(const std::uint32_t* bits) {
  return {std::bit_cast<float>(bits[0]), std::bit_cast<float>(bits[1]), std::bit_cast<float>(bits[2])};
}

}  // namespace

VisiblePass::VisiblePass() {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  attach(position_, GL_RGBA32UI, kAttachments[0]);
  attach(normal_, GL_RGBA32UI, kAttachments[1]);
  attach(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glDrawBuffers(GLsizei(kAttachments.size()), kAttachments.data());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, copy_.get());
  glBufferData(GL_PIXEL_PACK_BUFFER, GLsizeiptr(2 * kPlaneBytes), nullptr, GL_STREAM_READ);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

VisiblePass::~VisiblePass() { forget(); }

void VisiblePass::forget() {
  if (arrived_) glDeleteSync(arrived_);
  arrived_ = nullptr;
}

void VisiblePass::ask(const Analysis& analysis, const SceneBuffers& scene, ScenePass& pass) {
  forget();
  world_from_local_ = scene.world_from_local();
  eye_ = analysis.experiment.camera.position;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glViewport(0, 0, kVisibleColumns, kVisibleRows);
  const std::array<GLuint, 4> nothing{};
  const float far_end = 1.0f;
  glClearBufferuiv(GL_COLOR, 0, nothing.data());
  glClearBufferuiv(GL_COLOR, 1, nothing.data());
  glClearBufferfv(GL_DEPTH, 0, &far_end);
  pass.draw_surface_points(analysis, scene);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, copy_.get());
  for (std::size_t i = 0; i < kAttachments.size(); ++i) {
    glReadBuffer(kAttachments[i]);
    glReadPixels(0, 0, kVisibleColumns, kVisibleRows, GL_RGBA_INTEGER, GL_UNSIGNED_INT, reinterpret_cast<void*>(i * kPlaneBytes));
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  arrived_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

std::optional<std::vector<SurfacePoint>> VisiblePass::take() {
  if (!arrived_) return std::nullopt;
  const GLenum state = glClientWaitSync(arrived_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
  if (state == GL_TIMEOUT_EXPIRED) return std::nullopt;
  forget();
  std::vector<SurfacePoint> points;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, copy_.get());
  const void* mapped = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, GLsizeiptr(2 * kPlaneBytes), GL_MAP_READ_BIT);
  const auto* places = static_cast<const std::uint32_t*>(mapped);
  for (std::size_t i = 0; mapped && i < kCells; ++i) {
    const std::uint32_t *place = places + 4 * i, *normals = place + 4 * kCells;
    if (place[3] == 0) continue;
    const glm::dvec3 at = glm::dvec3(world_from_local_ * glm::dvec4(floats_at(place), 1.0)), normal = floats_at(normals);
    const double length = glm::length(normal);
    if (!(length > 0.0) || !std::isfinite(length)) continue;  // a triangle seen from its edge has no side
    points.push_back({at, normal / (glm::dot(normal, at - eye_) > 0.0 ? -length : length)});
  }
  if (mapped) glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  return points;
}

}  // namespace psm::gl
