// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow map: a depth texture array of one layer or six, drawn from the composed matrices.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/scene_buffers.h"
#include "scene/analysis.h"

namespace psm::gl {

class ShadowPass {
 public:
  explicit ShadowPass(const std::filesystem::path& shaders);

  /// Draws the casters that reach into H_R. Lines and points cast no shadow; all faces do, whichever way they look.
  void draw(const SceneBuffers& scene, const Analysis& analysis);

  /// What was drawn last: map from local space (see scene_buffers.h), one matrix for each layer; none before the first draw.
  const std::vector<glm::mat4>& maps_from_local() const { return maps_from_local_; }
  int layers() const { return layers_; }
  /// Texels along a side; less than asked for where the card has no room for more.
  int resolution() const { return resolution_; }
  /// Of all layers together; what lies outside H_R is left out.
  std::size_t triangles_drawn() const { return triangles_drawn_; }

  /// For shadow tests: hardware comparison. Binds texture and sampler.
  void bind_for_comparison(int unit) const;
  /// For showing: the depths themselves.
  void bind_for_reading(int unit) const;

  /// Smallest and largest depth that any caster wrote; (0, 1) if none did.
  glm::vec2 used_range();
  /// Depth of layer 0, rows bottom to top.
  std::vector<float> read_depth();

 private:
  void allocate(int resolution, int layers);
  void draw_layer(const SceneBuffers& scene, const glm::mat4& map_from_local, const ConvexBody& casters);
  /// The least and the largest depth that is not empty, of each block of block x block texels of a layer; of one texel, its
  /// depth.
  std::vector<glm::vec2> read_blocks(int layer, int block);

  Program program_, reduce_;
  GlTexture depth_;
  Sampler comparison_, reading_;
  Framebuffer framebuffer_;
  VertexArray no_vertices_;
  int resolution_ = 0, layers_ = 0, asked_resolution_ = 0;
  std::vector<glm::mat4> maps_from_local_;
  std::size_t triangles_drawn_ = 0;
  std::optional<glm::vec2> used_range_;
};

}  // namespace psm::gl
