// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/shadow_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>

namespace psm::gl {
namespace {

constexpr float kBiasUnits = 2.0f;  // depth steps, for faces that see the light head on and have no slope

void set_sampler(const Sampler& sampler, GLint compare_mode, GLint filter) {
  glSamplerParameteri(sampler.get(), GL_TEXTURE_MIN_FILTER, filter);
  glSamplerParameteri(sampler.get(), GL_TEXTURE_MAG_FILTER, filter);
  glSamplerParameteri(sampler.get(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glSamplerParameteri(sampler.get(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glSamplerParameteri(sampler.get(), GL_TEXTURE_COMPARE_MODE, compare_mode);
  glSamplerParameteri(sampler.get(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

std::vector<glm::dmat4> maps_from_world(const Analysis& analysis) {
  if (analysis.cube_maps_from_world) return {analysis.cube_maps_from_world->begin(), analysis.cube_maps_from_world->end()};
  // A reversed depth test is the usual one on the negated depth.
  const double order = analysis.reversed_depth ? -1.0 : 1.0;
  std::vector<glm::dmat4> maps;
  if (analysis.map_from_world) maps.push_back(glm::scale(glm::dmat4(1.0), {1.0, 1.0, order}) * *analysis.map_from_world);
  if (analysis.map_beyond_from_world) maps.push_back(*analysis.map_beyond_from_world);
  return maps;
}

/// Halves the resolution until the card has room.
int allocate_depth(int resolution, int layers) {
  for (;; resolution /= 2) {
    while (glGetError() != GL_NO_ERROR) {
    }
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, resolution, resolution, layers, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    if (resolution == 1 || glGetError() == GL_NO_ERROR) return resolution;
  }
}

}  // namespace

ShadowPass::ShadowPass(const std::filesystem::path& shaders)
    : program_(shaders, "shadow", "shadow"), reduce_(shaders, "fullscreen", "depth_blocks") {
  set_sampler(comparison_, GL_COMPARE_REF_TO_TEXTURE, GL_NEAREST);
  set_sampler(weighted_comparison_, GL_COMPARE_REF_TO_TEXTURE, GL_LINEAR);
  set_sampler(reading_, GL_NONE, GL_NEAREST);
}

void ShadowPass::allocate(int resolution, int layers) {
  if (resolution == asked_resolution_ && layers == allocated_layers_) return;
  asked_resolution_ = resolution;
  allocated_layers_ = layers;
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  glBindTexture(GL_TEXTURE_2D_ARRAY, depth_.get());
  resolution_ = allocate_depth(std::clamp(resolution, 1, int(largest)), layers);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
}

ShadowPass::Content ShadowPass::content_of(const SceneBuffers& scene, const Analysis& analysis) {
  const ShadowSettings& shadow = analysis.experiment.shadow;
  return {maps_from_world(analysis),    shadow.resolution, shadow.slope_scaled_bias(), shadow.cull,
          analysis.depth_body.vertices, scene.revision()};
}

void ShadowPass::update(const SceneBuffers& scene, const Analysis& analysis) {
  if (content_of(scene, analysis) != drawn_) draw(scene, analysis);
}

void ShadowPass::draw(const SceneBuffers& scene, const Analysis& analysis) {
  drawn_ = content_of(scene, analysis);
  ++times_drawn_;
  used_range_.reset();
  maps_from_local_.clear();
  triangles_drawn_ = 0;
  if (drawn_->maps.empty() || !scene.any_inside(Primitive::triangles, analysis.depth_body)) return;

  allocate(drawn_->resolution, int(drawn_->maps.size()));
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glViewport(0, 0, resolution_, resolution_);
  const GLenum no_color = GL_NONE;
  glDrawBuffers(1, &no_color);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  // The factor multiplies the steeper of the two depth slopes per texel: exactly the setting's definition.
  glPolygonOffset(float(drawn_->slope_bias), kBiasUnits);
  glCullFace(drawn_->cull == Cull::front ? GL_FRONT : GL_BACK);
  for (int layer = 0; layer < allocated_layers_; ++layer) {
    // A matrix that cannot be drawn keeps its place with w = 0 everywhere: nothing lies inside it.
    const glm::mat4 map = narrow(drawn_->maps[std::size_t(layer)] * scene.world_from_local()).value_or(glm::mat4(0.0f));
    maps_from_local_.push_back(map);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth_.get(), 0, layer);
    const float far_end = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &far_end);
    draw_layer(scene, std::size_t(layer), analysis.depth_body);
  }
}

void ShadowPass::draw_layer(const SceneBuffers& scene, std::size_t layer, const ConvexBody& casters) {
  program_.use();
  program_.set("u_map_from_local", maps_from_local_[layer]);
  program_.set("u_texture", 0);
  scene.bind();
  glFrontFace(front_is_clockwise(drawn_->maps[layer]) ? GL_CW : GL_CCW);  // as the light sees it
  for (const Batch& batch : scene.batches()) {
    if (batch.primitive != Primitive::triangles) continue;
    const bool culls = drawn_->cull != Cull::none && !scene.material(batch).double_sided;
    (culls ? glEnable : glDisable)(GL_CULL_FACE);
    scene.bind_material(batch, program_);
    triangles_drawn_ += scene.draw_inside(batch, casters);
  }
}

void ShadowPass::bind_for_comparison(int unit, bool weighted) const {
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, depth_.get());
  glBindSampler(GLuint(unit), weighted ? weighted_comparison_.get() : comparison_.get());
}

void ShadowPass::bind_for_reading(int unit) const {
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, depth_.get());
  glBindSampler(GLuint(unit), reading_.get());
}

std::vector<glm::vec2> ShadowPass::read_blocks(int layer, int block) {
  // ES 3.0 reads neither depth nor float textures back, but it reads unsigned integers: the bits of the floats.
  const int side = (resolution_ + block - 1) / block;
  Framebuffer framebuffer;
  Renderbuffer bits;
  glBindRenderbuffer(GL_RENDERBUFFER, bits.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32UI, side, side);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, bits.get());
  glViewport(0, 0, side, side);
  reduce_.use();
  reduce_.set("u_map", 0);
  reduce_.set("u_layer", layer);
  reduce_.set("u_block", block);
  bind_for_reading(0);
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<std::uint32_t> texels(std::size_t(side) * std::size_t(side) * 4);
  glReadPixels(0, 0, side, side, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.data());
  std::vector<glm::vec2> blocks;
  for (std::size_t i = 0; i < texels.size(); i += 4)
    blocks.emplace_back(std::bit_cast<float>(texels[i]), std::bit_cast<float>(texels[i + 1]));
  return blocks;
}

glm::vec2 ShadowPass::used_range() {
  if (used_range_) return *used_range_;
  constexpr int kBlocks = 64;  // along a side: few enough to read back, enough to keep the card busy
  glm::vec2 range(1.0f, 0.0f);
  for (int layer = 0; layer < layers(); ++layer) {
    for (const glm::vec2& block : read_blocks(layer, std::max(2, resolution_ / kBlocks)))
      range = {std::min(range.x, block.x), std::max(range.y, block.y)};
  }
  used_range_ = range.x <= range.y ? range : glm::vec2(0.0f, 1.0f);
  return *used_range_;
}

std::vector<float> ShadowPass::read_depth() {
  std::vector<float> depth;
  if (layers() == 0) return depth;
  for (const glm::vec2& texel : read_blocks(0, 1)) depth.push_back(texel.x);
  return depth;
}

}  // namespace psm::gl
