// SPDX-License-Identifier: GPL-3.0-or-later
// A picture made of pixels over the scene, where the eye's image is.
#pragma once

#include <filesystem>

#include "draw/view.h"
#include "gl/gl_objects.h"

namespace psm::gl {

class CoverPass {
 public:
  explicit CoverPass(const std::filesystem::path& shaders);
  /// picture.cover, if there is one, blended into the bound framebuffer; pixels stay crisp when enlarged.
  void draw(const ViewPicture& picture);

 private:
  Program program_;
  VertexStream corners_;
};

}  // namespace psm::gl
