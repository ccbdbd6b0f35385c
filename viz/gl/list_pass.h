// SPDX-License-Identifier: GPL-3.0-or-later
// A DrawList over the scene, tested against the depth of the framebuffer in use, which it leaves alone.
#pragma once

#include <filesystem>

#include "draw/view.h"
#include "gl/gl_objects.h"
#include "gl/overlay_vertices.h"
#include "gl/text_pass.h"

namespace psm::gl {

class ListPass {
 public:
  ListPass(const std::filesystem::path& shaders, const std::filesystem::path& font);
  /// Have no soft edges: wants several samples a pixel.
  void draw_fills(const ViewPicture& picture, const PictureFrame& frame);
  /// Soften their own edges: one sample a pixel will do.
  void draw_lines_and_labels(const ViewPicture& picture, const PictureFrame& frame);

 private:
  void draw_list_lines(const ViewPicture& picture, const PictureFrame& frame, Seen seen);
  void draw_list_points(const ViewPicture& picture, const PictureFrame& frame, Seen seen);
  void draw_lines(std::span<const LineVertex> vertices);
  void draw_shapes(std::span<const ShapeVertex> vertices);

  Program fill_program_, line_program_, shape_program_;
  VertexStream fills_, lines_, shapes_;
  TextPass text_;
};

}  // namespace psm::gl
