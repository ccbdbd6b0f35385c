// SPDX-License-Identifier: GPL-3.0-or-later
// A DrawList over the scene, tested against its depth, which it leaves alone.
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
  void draw(const ViewPicture& picture, const PictureFrame& frame);

 private:
  void draw_fills(const ViewPicture& picture, const PictureFrame& frame);
  void draw_list_lines(const ViewPicture& picture, const PictureFrame& frame, Seen seen);
  void draw_list_points(const ViewPicture& picture, const PictureFrame& frame, Seen seen);
  void draw_lines(std::span<const LineVertex> vertices);
  void draw_shapes(std::span<const ShapeVertex> vertices);

  Program fill_program_, line_program_, shape_program_;
  VertexStream fills_, lines_, shapes_;
  TextPass text_;
};

}  // namespace psm::gl
