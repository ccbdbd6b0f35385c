// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow map as a picture.
#pragma once

#include <array>
#include <filesystem>

#include "draw/view.h"
#include "gl/gl_objects.h"
#include "gl/renderer.h"
#include "gl/shadow_pass.h"

namespace psm::gl {

class MapPass {
 public:
  explicit MapPass(const std::filesystem::path& shaders);

  /// ScenePicture::map_depth: layer 0 in the square [-1, 1]^2 of the list's space, or a sheet as wide as the square: two side by
  /// side, or six in 3 x 2, +x -x +y above -y +z -z. Near is light, far is dark, hatched where no caster is.
  void draw(const ViewPicture& picture, const ShadowPass& map, double scale, Theme theme);

 private:
  std::array<Program, 3> programs_;  // for no map, one, and several
  VertexStream corners_;
};

}  // namespace psm::gl
