// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow map: a depth texture array of one layer, two or six, drawn from the composed matrices; of none where nothing can
// cast a shadow.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/scene_buffers.h"
#include "scene/analysis.h"

namespace psm::gl {

class ShadowPass {
 public:
  explicit ShadowPass(const std::filesystem::path& shaders);

  /// Draws the casters that reach into H_R. Lines and points cast no shadow; all faces do that shadow.cull leaves. Where nothing
  /// reaches into H_R nothing is drawn, not even cleared: there are no layers, and all is lit.
  void draw(const SceneBuffers& scene, const Analysis& analysis);
  /// The same, unless that is what was drawn last.
  void update(const SceneBuffers& scene, const Analysis& analysis);

  /// What was drawn last: map from local space (see scene_buffers.h), one matrix for each layer. A point is lit if all maps
  /// that hold it say so.
  const std::vector<glm::mat4>& maps_from_local() const { return maps_from_local_; }
  int layers() const { return int(maps_from_local_.size()); }
  /// Texels along a side; less than asked for where the card has no room for more.
  int resolution() const { return resolution_; }
  /// Of all layers together; what lies outside H_R is left out.
  std::size_t triangles_drawn() const { return triangles_drawn_; }
  /// How often draw() was called, by whomever.
  int times_drawn() const { return times_drawn_; }

  /// For shadow tests: hardware comparison, with one texel or (`weighted`) with four, weighted by distance. Binds texture and
  /// sampler.
  void bind_for_comparison(int unit, bool weighted) const;
  /// For showing: the depths themselves.
  void bind_for_reading(int unit) const;

  /// Finds which depths casters wrote, with a framebuffer of its own: for map_depth.vert, without reading anything back.
  void find_range();
  void bind_range(int unit) const;
  /// Depth of layer 0, rows bottom to top.
  std::vector<float> read_depth();

 private:
  /// All that the map depends on.
  struct Content {
    std::vector<glm::dmat4> maps;
    int resolution = 0;
    double slope_bias = 0.0;  // texels
    Cull cull = Cull::none;
    std::vector<glm::dvec3> casters;  // of the body that they reach into
    int scene = 0;
    double normal_bias = 0.0;  // texels
    bool operator==(const Content&) const = default;
  };
  static Content content_of(const SceneBuffers& scene, const Analysis& analysis);
  void allocate(int resolution, int layers);
  void draw_layer(const SceneBuffers& scene, std::size_t layer, const ConvexBody& casters);

  Program solid_program_, cutoff_program_, textured_cutoff_program_, blocks_program_, bits_program_;
  GlTexture depth_, blocks_;
  Sampler comparison_, weighted_comparison_, reading_;
  Framebuffer framebuffer_, blocks_framebuffer_;
  VertexArray no_vertices_;
  int resolution_ = 0, allocated_layers_ = 0, asked_resolution_ = 0, times_drawn_ = 0;
  std::optional<Content> drawn_;
  std::vector<glm::mat4> maps_from_local_;
  std::size_t triangles_drawn_ = 0;
  bool range_known_ = false;
};

}  // namespace psm::gl
