// SPDX-License-Identifier: GPL-3.0-or-later
// The lit scene with shadows from the map.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "draw/view.h"
#include "gl/gl_objects.h"
#include "gl/renderer.h"
#include "gl/scene_buffers.h"
#include "gl/seen_rect.h"
#include "gl/shadow_pass.h"

namespace psm::gl {

struct SceneUniforms;
struct Side;

class ScenePass {
 public:
  explicit ScenePass(const std::filesystem::path& shaders) : shaders_(shaders) {}

  /// ScenePicture::shadowed and ::projective, into the bound framebuffer, with depth; a heat map instead of the lit scene where
  /// the picture asks for it. `ground`: what the scene fades to.
  void draw(const ViewPicture& picture, const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map, double scale,
            const glm::vec4& ground);
  /// The texel grid over what draw() drew, and over bodies around it, where the picture asks for it.
  void draw_texel_grid(const ViewPicture& picture, const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map,
                       double scale, Theme theme);

  /// Where draw() may change pixels.
  static PixelRect reach(const ViewPicture& picture, const SceneBuffers& scene, glm::ivec2 size, double scale);

  /// The eye's image, into the bound framebuffer: a MapVerdict in red and the lit fraction in green where there is a triangle.
  void draw_verdicts(const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map);

  /// The eye's image, into the bound framebuffer: places and normals as bits, see surface_point.frag.
  void draw_surface_points(const Analysis& analysis, const SceneBuffers& scene);

 private:
  /// How a scene is drawn: the fragment shader, #define lines for it, and what it needs besides SceneUniforms.
  struct Shading {
    std::string fragment = "scene", defines = {};
    std::function<void(Program&)> set = {};
  };
  static Shading lit(const Analysis& analysis, const ShadowPass& map, const std::string& defines = "");
  void draw_scene(const Shading& shading, const SceneUniforms& values, const SceneBuffers& scene, const std::vector<Side>& sides);
  /// Made when first asked for: a loop over maps, filters, a texture or a spot's cone that is not there cost software renderers
  /// as much as one that is.
  Program& program(const std::string& fragment, const std::string& defines);

  std::filesystem::path shaders_;
  std::map<std::string, Program> programs_;  // by their fragment shaders' names and defines
};

}  // namespace psm::gl
