// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/shadow_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>

namespace psm::gl {
namespace {

constexpr GLsizei kBlocks = 16;  // along a side, as in the shaders
constexpr int kProbesAlongSide = 256;
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

/// Whether what reaches the receivers could darken any of them. Triangles that all lie in one plane across an axis shadow only
/// themselves, and that only where the bias is too small for them: as acne, which is there to be seen.
bool can_shadow(const Bounds& casters, const Analysis& analysis) {
  if (casters.empty()) return false;
  const ShadowSettings& shadow = analysis.experiment.shadow;
  const bool in_one_plane = glm::any(glm::equal(casters.min, casters.max));
  const bool free_of_acne = shadow.slope_scaled_bias() >= 1.0 || shadow.normal_bias >= 0.5;
  return !(in_one_plane && free_of_acne);
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
    : solid_program_(shaders, "shadow", "shadow"),
      cutoff_program_(shaders, "shadow", "shadow", "#define MAY_DISCARD\n"),
      textured_cutoff_program_(shaders, "shadow", "shadow", "#define MAY_DISCARD\n#define TEXTURED\n"),
      blocks_program_(shaders, "fullscreen", "depth_blocks"),
      bits_program_(shaders, "fullscreen", "depth_bits") {
  set_sampler(comparison_, GL_COMPARE_REF_TO_TEXTURE, GL_NEAREST);
  set_sampler(weighted_comparison_, GL_COMPARE_REF_TO_TEXTURE, GL_LINEAR);
  set_sampler(reading_, GL_NONE, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, blocks_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32UI, kBlocks, kBlocks, 0, GL_RG_INTEGER, GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, blocks_framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, blocks_.get(), 0);
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
          analysis.depth_body.vertices, scene.revision(),  shadow.normal_bias};
}

void ShadowPass::update(const SceneBuffers& scene, const Analysis& analysis) {
  if (content_of(scene, analysis) != drawn_) draw(scene, analysis);
}

void ShadowPass::draw(const SceneBuffers& scene, const Analysis& analysis) {
  drawn_ = content_of(scene, analysis);
  ++times_drawn_;
  range_known_ = false;
  maps_from_local_.clear();
  triangles_drawn_ = 0;
  if (drawn_->maps.empty() || !can_shadow(scene.bounds_inside(Primitive::triangles, analysis.depth_body), analysis)) return;

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
  scene.bind();
  glFrontFace(front_is_clockwise(drawn_->maps[layer]) ? GL_CW : GL_CCW);  // as the light sees it
  for (const Batch& batch : scene.batches()) {
    if (batch.primitive != Primitive::triangles) continue;
    const bool culls = drawn_->cull != Cull::none && !scene.material(batch).double_sided;
    (culls ? glEnable : glDisable)(GL_CULL_FACE);
    Program& program = !(scene.material(batch).alpha_cutoff > 0.0f) ? solid_program_
                       : scene.textured(batch)                      ? textured_cutoff_program_
                                                                    : cutoff_program_;
    program.use();
    program.set("u_map_from_local", maps_from_local_[layer]);
    program.set("u_texture", 0);
    scene.bind_material(batch, program);
    triangles_drawn_ += scene.draw_inside(batch, casters) / 3;
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

void ShadowPass::find_range() {
  if (range_known_ || layers() == 0) return;
  range_known_ = true;
  glBindFramebuffer(GL_FRAMEBUFFER, blocks_framebuffer_.get());
  glViewport(0, 0, kBlocks, kBlocks);
  blocks_program_.use();
  blocks_program_.set("u_map", 0);
  // For a stretch of greys: a caster that all these miss is thinner than any that one sees.
  blocks_program_.set("u_step", std::max(1, resolution_ / kProbesAlongSide));
  bind_for_reading(0);
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ShadowPass::bind_range(int unit) const {
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, blocks_.get());
  glBindSampler(GLuint(unit), 0);
}

std::vector<float> ShadowPass::read_depth() {
  if (layers() == 0) return {};
  Framebuffer framebuffer;
  Renderbuffer bits;
  glBindRenderbuffer(GL_RENDERBUFFER, bits.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32UI, resolution_, resolution_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, bits.get());
  glViewport(0, 0, resolution_, resolution_);
  bits_program_.use();
  bits_program_.set("u_map", 0);
  bind_for_reading(0);
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const std::size_t count = std::size_t(resolution_) * std::size_t(resolution_);
  std::vector<std::uint32_t> texels(4 * count);
  glReadPixels(0, 0, resolution_, resolution_, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.data());
  std::vector<float> depth;
  for (std::size_t i = 0; i < count; ++i) depth.push_back(std::bit_cast<float>(texels[4 * i]));
  return depth;
}

}  // namespace psm::gl
