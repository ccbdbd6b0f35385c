// SPDX-License-Identifier: GPL-3.0-or-later
// The depth of a view's picture, for lines that are drawn over it elsewhere.
#pragma once

#include <filesystem>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/view_target.h"

namespace psm::gl {

class ViewDepth {
 public:
  explicit ViewDepth(const std::filesystem::path& shaders) : program_(shaders, "fullscreen", "view_depth") {}

  /// In [0, 1], rows top to bottom: of the lower left `size` pixels of what was drawn last.
  std::vector<float> read(const MultisampleTarget& source, glm::ivec2 size);

 private:
  Program program_;
  VertexArray no_vertices_;
};

}  // namespace psm::gl
