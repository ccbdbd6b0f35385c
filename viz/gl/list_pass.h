// SPDX-License-Identifier: GPL-3.0-or-later
// A DrawList over the scene.
#pragma once

#include <array>
#include <filesystem>

#include "draw/view.h"
#include "gl/gl_objects.h"
#include "gl/overlay_depth.h"
#include "gl/overlay_vertices.h"
#include "gl/text_pass.h"

namespace psm::gl {

class ListPass {
 public:
  ListPass(const std::filesystem::path& shaders, const std::filesystem::path& font);
  /// Have no soft edges: wants several samples a pixel, and the scene's depth, which it leaves alone.
  void draw_fills(const ViewPicture& picture, const PictureFrame& frame);
  /// Soften their own edges: one sample a pixel will do. `scene`: what may hide them.
  void draw_lines_and_labels(const ViewPicture& picture, const PictureFrame& frame, const OverlayDepth& scene);

 private:
  /// A program for what nothing hides, and one for what the scene may hide.
  using Pair = std::array<Program, 2>;
  static Program& use(Pair& programs, const OverlayDepth& scene);
  void draw_list_lines(const ViewPicture& picture, const PictureFrame& frame, const OverlayDepth& scene);
  void draw_list_points(const ViewPicture& picture, const PictureFrame& frame, const OverlayDepth& scene);
  void draw_marks(std::span<const Mark> marks, const PictureFrame& frame);

  Program fill_program_;
  Pair line_programs_, shape_programs_;
  VertexStream fills_, lines_, shapes_;
  TextPass text_;
};

}  // namespace psm::gl
