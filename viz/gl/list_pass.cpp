// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/list_pass.h"

#include "gl/gl_state.h"

namespace psm::gl {
namespace {

template <class Vertex>
void draw(VertexStream& stream, const std::vector<Vertex>& vertices) {
  if (vertices.empty()) return;
  stream.upload(std::span<const Vertex>(vertices));
  stream.draw_triangles();
}

}  // namespace

ListPass::ListPass(const std::filesystem::path& shaders, const std::filesystem::path& font)
    : fill_program_(shaders, "fill", "fill"),
      line_programs_{Program(shaders, "line", "line"), Program(shaders, "line", "line", "#define OVER_SCENE\n", "overlay_depth")},
      shape_programs_{Program(shaders, "shape", "shape"),
                      Program(shaders, "shape", "shape", "#define OVER_SCENE\n", "overlay_depth")},
      fills_(sizeof(FillVertex), {{0, 4, offsetof(FillVertex, position)}, {1, 4, offsetof(FillVertex, color)}}),
      lines_(sizeof(LineVertex), {{0, 3, offsetof(LineVertex, position)},
                                  {1, 4, offsetof(LineVertex, place)},
                                  {2, 4, offsetof(LineVertex, color)},
                                  {3, 4, offsetof(LineVertex, shape)}}),
      shapes_(sizeof(ShapeVertex), {{0, 3, offsetof(ShapeVertex, position)},
                                    {1, 4, offsetof(ShapeVertex, box)},
                                    {2, 4, offsetof(ShapeVertex, fill)},
                                    {3, 4, offsetof(ShapeVertex, outline)},
                                    {4, 2, offsetof(ShapeVertex, shape)}}),
      text_(shaders, font) {}

void ListPass::draw_lines_and_labels(const ViewPicture& picture, const PictureFrame& frame, const OverlayDepth& scene) {
  const Annotations notes = annotate(picture, frame, [&](const std::string& text) { return text_.text_size(text, frame.scale); });

  glDisable(GL_DEPTH_TEST);
  enable_blending();
  draw_list_lines(picture, frame, scene);
  draw_marks(notes.leaders, frame);  // they end under the points that they lead to
  draw_list_points(picture, frame, scene);
  shape_programs_[0].use();
  draw(shapes_, plate_vertices(notes.plates, frame));
  draw_marks(notes.marks, frame);
  text_.draw(notes.texts, frame);
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

Program& ListPass::use(Pair& programs, const OverlayDepth& scene) {
  Program& program = programs[scene.any() ? 1 : 0];
  program.use();
  if (scene.any()) scene.bind(program);
  return program;
}

void ListPass::draw_list_lines(const ViewPicture& picture, const PictureFrame& frame, const OverlayDepth& scene) {
  use(line_programs_, scene)
      .set("u_hidden", glm::vec3(kHiddenWidth, kHiddenOpacity, dash_of(Seen::behind).period() * frame.scale));
  draw(lines_, line_vertices(picture.list, picture.clip_from_list, frame));
}

void ListPass::draw_list_points(const ViewPicture& picture, const PictureFrame& frame, const OverlayDepth& scene) {
  use(shape_programs_, scene).set("u_hidden", float(kHiddenPointOpacity));
  draw(shapes_, point_vertices(picture.list, picture.clip_from_list, frame));
}

void ListPass::draw_marks(std::span<const Mark> marks, const PictureFrame& frame) {
  line_programs_[0].use();
  draw(lines_, mark_vertices(marks, frame));
}

}  // namespace psm::gl
