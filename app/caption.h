// SPDX-License-Identifier: GPL-3.0-or-later
// Text in pictures that are put together without OpenGL.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "gl/renderer.h"

namespace psm {

/// One typeface at one size in pixels, ready to draw.
class Caption {
 public:
  Caption(const std::filesystem::path& font, double size);
  ~Caption();

  double width(const std::string& text) const;

  /// Blends the text (UTF-8) over the picture, cut off at its edges; (x, y) is its top left.
  void draw(Image& image, int x, int y, const std::string& text, const glm::vec3& color) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace psm
