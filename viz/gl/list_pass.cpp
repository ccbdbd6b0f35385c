// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/list_pass.h"

#include "gl/gl_state.h"

namespace psm::gl {

ListPass::ListPass(const std::filesystem::path& shaders, const std::filesystem::path& font)
    : fill_program_(shaders, "fill", "fill"),
      line_program_(shaders, "line", "line"),
      shape_program_(shaders, "shape", "shape"),
      fills_(sizeof(FillVertex), {{0, 4, offsetof(FillVertex, position)}, {1, 4, offsetof(FillVertex, color)}}),
      lines_(sizeof(LineVertex), {{0, 3, offsetof(LineVertex, position)},
                                  {1, 4, offsetof(LineVertex, segment)},
                                  {2, 4, offsetof(LineVertex, color)},
                                  {3, 4, offsetof(LineVertex, shape)}}),
      shapes_(sizeof(ShapeVertex), {{0, 3, offsetof(ShapeVertex, position)},
                                    {1, 4, offsetof(ShapeVertex, box)},
                                    {2, 4, offsetof(ShapeVertex, fill)},
                                    {3, 4, offsetof(ShapeVertex, outline)},
                                    {4, 2, offsetof(ShapeVertex, shape)}}),
      text_(shaders, font) {}

void ListPass::draw_lines_and_labels(const ViewPicture& picture, const PictureFrame& frame) {
  const Annotations notes = annotate(picture, frame, [&](const std::string& text) { return text_.text_size(text, frame.scale); });

  glDepthMask(GL_FALSE);
  enable_blending();
  glEnable(GL_DEPTH_TEST);
  draw_list_lines(picture, frame, Seen::behind);
  draw_list_lines(picture, frame, Seen::in_front);
  glDisable(GL_DEPTH_TEST);
  draw_lines(mark_vertices(notes.leaders, frame));  // they end under the points that they lead to
  glEnable(GL_DEPTH_TEST);
  draw_list_points(picture, frame, Seen::behind);
  draw_list_points(picture, frame, Seen::in_front);
  glDisable(GL_DEPTH_TEST);
  draw_shapes(plate_vertices(notes.plates, frame));
  draw_lines(mark_vertices(notes.marks, frame));
  text_.draw(notes.texts, frame);
  glDepthMask(GL_TRUE);
}

/// Back faces first: right for one convex body.
void ListPass::draw_fills(const ViewPicture& picture, const PictureFrame& frame) {
  const std::vector<FillVertex> vertices = fill_vertices(picture.list, picture.clip_from_list, frame);
  if (vertices.empty()) return;
  glDepthMask(GL_FALSE);
  enable_blending();
  glEnable(GL_DEPTH_TEST);
  fill_program_.use();
  fills_.upload(std::span<const FillVertex>(vertices));
  glDepthFunc(GL_LEQUAL);
  glFrontFace(glm::determinant(picture.clip_from_list) > 0.0 ? GL_CW : GL_CCW);
  glEnable(GL_CULL_FACE);
  for (const GLenum culled : {GL_FRONT, GL_BACK}) {
    glCullFace(culled);
    fills_.draw_triangles();
  }
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
}

void ListPass::draw_list_lines(const ViewPicture& picture, const PictureFrame& frame, Seen seen) {
  glDepthFunc(seen == Seen::behind ? GL_GREATER : GL_LEQUAL);
  draw_lines(line_vertices(picture.list, picture.clip_from_list, frame, seen));
}

void ListPass::draw_list_points(const ViewPicture& picture, const PictureFrame& frame, Seen seen) {
  glDepthFunc(seen == Seen::behind ? GL_GREATER : GL_LEQUAL);
  draw_shapes(point_vertices(picture.list, picture.clip_from_list, frame, seen));
}

void ListPass::draw_lines(std::span<const LineVertex> vertices) {
  if (vertices.empty()) return;
  line_program_.use();
  lines_.upload(vertices);
  lines_.draw_triangles();
}

void ListPass::draw_shapes(std::span<const ShapeVertex> vertices) {
  if (vertices.empty()) return;
  shape_program_.use();
  shapes_.upload(vertices);
  shapes_.draw_triangles();
}

}  // namespace psm::gl
