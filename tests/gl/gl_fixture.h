// SPDX-License-Identifier: GPL-3.0-or-later
// A context of each profile, a renderer, and small scenes with hand-made matrices.
#pragma once

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "app/assets.h"
#include "app/headless_context.h"
#include "gl/gl_state.h"
#include "gl/renderer.h"

namespace psm {

/// A body that holds every caster of these small scenes.
inline ConvexBody everything() { return box_body(glm::dvec3(-1e30), glm::dvec3(1e30)); }

class GlTest : public testing::TestWithParam<GlProfile> {
 protected:
  void SetUp() override {
    auto made = HeadlessContext::create(GetParam());
    ASSERT_TRUE(made) << made.error().text;
    context_ = std::move(*made);
    renderer_ = std::make_unique<Renderer>(assets_folder(), font_file());
  }
  void TearDown() override {
    EXPECT_EQ(gl::take_errors(), "");
    renderer_.reset();
    context_.reset();
  }

  /// Scene, map and view; the picture as read back.
  Image draw(const Scene& scene, const Analysis& analysis, const ViewPicture& picture, glm::ivec2 size, double scale = 1.0,
             Theme theme = Theme::light) {
    renderer_->set_scene(scene);
    renderer_->draw_shadow_map(analysis);
    renderer_->draw_view(picture, analysis, size, scale, theme);
    return renderer_->read_view(picture.id);
  }

  /// Lines and the like on an empty ground, in clip space.
  Image draw_list(const DrawList& list, glm::ivec2 size, double scale = 1.0, Theme theme = Theme::light) {
    ViewPicture picture;
    picture.list = list;
    return draw(empty_scene(), Analysis{}, picture, size, scale, theme);
  }

  static Scene empty_scene() {
    Scene scene;
    scene.materials.emplace_back();
    return scene;
  }

  std::unique_ptr<HeadlessContext> context_;
  std::unique_ptr<Renderer> renderer_;
};

inline glm::ivec3 pixel(const Image& image, int x, int y_from_top) {
  const std::uint8_t* p = &image.rgba[(std::size_t(y_from_top) * std::size_t(image.width) + std::size_t(x)) * 4];
  return {p[0], p[1], p[2]};
}

/// The parallelogram corner, corner + u, corner + u + v, corner + v, without normals.
inline void add_quad(Scene& scene, glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v, int material = 0) {
  Mesh mesh;
  mesh.material = material;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.triangles = {0, 1, 2, 0, 2, 3};
  for (const glm::dvec3& p : mesh.positions) scene.bounds.add(p);
  scene.meshes.push_back(mesh);
}

/// Straight down from y = top to y = bottom, over x and z in [-half, half]; depth grows downwards.
inline glm::dmat4 map_from_above(double half, double top, double bottom) {
  const glm::dmat4 view = glm::lookAtRH(glm::dvec3(0, top, 0), glm::dvec3(0, bottom, 0), glm::dvec3(0, 0, -1));
  return glm::orthoRH_NO(-half, half, -half, half, 0.0, top - bottom) * view;
}

}  // namespace psm
