// SPDX-License-Identifier: GPL-3.0-or-later
// The lit scene with shadows from the map.
#pragma once

#include <array>
#include <filesystem>
#include <memory>

#include "draw/view.h"
#include "gl/gl_objects.h"
#include "gl/renderer.h"
#include "gl/scene_buffers.h"
#include "gl/shadow_pass.h"

namespace psm::gl {

class ScenePass {
 public:
  explicit ScenePass(const std::filesystem::path& shaders);

  /// ScenePicture::shadowed and ::projective, into the bound framebuffer, with depth; a heat map instead of the lit scene, and
  /// the texel grid over it, where the picture asks for them.
  void draw(const ViewPicture& picture, const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map, double scale,
            Theme theme, const glm::vec4& ground);

  /// The eye's image, into the bound framebuffer: a MapVerdict in red and the lit fraction in green where there is a triangle.
  void draw_verdicts(const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map);

  /// The eye's image, into the bound framebuffer: places and normals as bits, see surface_point.frag.
  void draw_surface_points(const Analysis& analysis, const SceneBuffers& scene);

 private:
  // Without and with fragments that may be discarded.
  using Pair = std::array<Program, 2>;
  /// The pair for these settings: `plain`, or where points are shifted or comparisons averaged, `lookup`, made when first asked
  /// for.
  Pair& pair_for(const ShadowSettings& shadow, Pair& plain, std::unique_ptr<Pair>& lookup, const char* defines);

  std::filesystem::path shaders_;
  Pair one_map_, many_maps_;  // a loop over maps costs software renderers much even where there is one
  Pair verdicts_, heat_, grid_, surface_points_;
  std::unique_ptr<Pair> lookup_shading_, lookup_verdicts_;
};

}  // namespace psm::gl
