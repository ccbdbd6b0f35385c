// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h>
#include <stdlib.h>

#include <fstream>

#include "figure/png.h"
#include "gl_fixture.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace psm {
namespace {

class Views : public GlTest {
 protected:
  static Scene quad_scene(glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v) {
    Scene scene = empty_scene();
    add_quad(scene, corner, u, v);
    return scene;
  }
};

bool is_ground(const glm::ivec3& color) { return color == glm::ivec3(255); }

TEST_P(Views, are_read_from_top_to_bottom) {
  const Image image = draw(quad_scene({-1, 0, 0}, {1, 0, 0}, {0, 1, 0}), Analysis{}, ViewPicture{}, {20, 10});
  EXPECT_EQ(image.width, 20);
  EXPECT_EQ(image.height, 10);
  EXPECT_FALSE(is_ground(pixel(image, 5, 2)));  // top left
  EXPECT_TRUE(is_ground(pixel(image, 15, 2)));
  EXPECT_TRUE(is_ground(pixel(image, 5, 7)));
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
}

TEST_P(Views, letterbox_beside_the_image) {
  ViewPicture picture;
  picture.image_rect = {-0.5, -1.0, 0.5, 1.0};
  const Image image = draw(quad_scene({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), Analysis{}, picture, {40, 20});
  EXPECT_EQ(pixel(image, 9, 10), pixel(image, 30, 10));
  EXPECT_NE(pixel(image, 9, 10), pixel(image, 10, 10));
  EXPECT_EQ(pixel(image, 10, 10), pixel(image, 29, 10));
}

TEST_P(Views, keep_one_texture_each_until_the_size_changes) {
  renderer_->set_scene(empty_scene());
  ViewPicture world, eye;
  eye.id = ViewId::eye;
  const auto first = renderer_->draw_view(world, Analysis{}, {30, 20}, 1.0, Theme::light);
  const auto other = renderer_->draw_view(eye, Analysis{}, {50, 40}, 1.0, Theme::dark);
  EXPECT_NE(first, other);
  EXPECT_EQ(renderer_->draw_view(world, Analysis{}, {30, 20}, 1.0, Theme::light), first);
  EXPECT_EQ(renderer_->read_view(ViewId::eye).width, 50);
  EXPECT_EQ(renderer_->read_view(ViewId::world).width, 30);
  EXPECT_LT(pixel(renderer_->read_view(ViewId::eye), 10, 30).r, 60);
  EXPECT_TRUE(renderer_->read_view(ViewId::cube).rgba.empty());
}

TEST_P(Views, both_sides_of_infinity_are_drawn) {
  // x' = x / (x - 1): the plane x = 1 goes to infinity. The quad over x in [3, 5], y in [-1, 1] lands on x' in [1.25, 1.5] with
  // w > 0; over x in [-3, -1], on x' in [0.5, 0.75] with w < 0.
  glm::dmat4 cube(1.0);
  cube[0] = {1, 0, 0, 1};
  cube[3] = {0, 0, 0, -1};
  ViewPicture picture;
  picture.scene = ScenePicture::projective;
  picture.cube_from_world = cube;
  picture.cube_limit = 3.0;
  picture.clip_from_world = glm::scale(glm::dmat4(1.0), glm::dvec3(0.5, 0.5, 0.5)) * cube;
  const auto seen = [&](double x_min) {
    const Image image = draw(quad_scene({x_min, -1, 0}, {2, 0, 0}, {0, 2, 0}), Analysis{}, picture, {80, 80});
    std::pair<int, int> range(80, -1);
    for (int x = 0; x < 80; ++x) {
      if (!is_ground(pixel(image, x, 40))) range = {std::min(range.first, x), std::max(range.second, x)};
    }
    return range;
  };
  EXPECT_EQ(seen(-3), std::make_pair(50, 54));  // 40 + 20 x'
  EXPECT_EQ(seen(3), std::make_pair(65, 69));
}

TEST_P(Views, the_cube_ends_at_its_limit) {
  ViewPicture picture;
  picture.scene = ScenePicture::projective;
  picture.cube_limit = 0.5;
  const Image image = draw(quad_scene({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), Analysis{}, picture, {80, 80});
  EXPECT_FALSE(is_ground(pixel(image, 40, 40)));
  EXPECT_FALSE(is_ground(pixel(image, 57, 40)));
  EXPECT_TRUE(is_ground(pixel(image, 61, 40)));
  EXPECT_GT(pixel(image, 57, 40).g, pixel(image, 40, 40).g);  // on its way out
}

TEST_P(Views, the_map_shows_near_light_far_dark_and_what_is_empty) {
  Scene scene = empty_scene();
  add_quad(scene, {-2, 1, 2}, {2, 0, 0}, {0, 0, -4});  // left: near
  add_quad(scene, {0, 0, 2}, {1, 0, 0}, {0, 0, -4});   // right of the middle: far
  Analysis analysis;
  analysis.experiment.shadow.resolution = 64;
  analysis.map_from_world = map_from_above(2.0, 2.0, -1.0);
  analysis.depth_body = everything();
  ViewPicture picture;
  picture.id = ViewId::map;
  picture.scene = ScenePicture::map_depth;
  const Image image = draw(scene, analysis, picture, {80, 80});
  const glm::ivec3 near = pixel(image, 20, 40), far = pixel(image, 50, 40), empty = pixel(image, 70, 40);
  EXPECT_GT(near.g, 200);
  EXPECT_EQ(near.r, near.b);
  EXPECT_LT(far.g, 80);
  EXPECT_GT(empty.b, empty.r);  // tinted
}

TEST_P(Views, leave_the_callers_state_alone) {
  glViewport(3, 4, 5, 6);
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  // As a careless caller may leave it.
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT_AND_BACK);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 0, 0);
  glDepthMask(GL_FALSE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_BLEND);
  const Image image = draw(quad_scene({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), Analysis{}, ViewPicture{}, {20, 10});
  EXPECT_FALSE(is_ground(pixel(image, 5, 2)));
  GLint bound = 0, viewport[4], program = -1;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  EXPECT_EQ(GLuint(bound), framebuffer);
  EXPECT_EQ(viewport[0] * 1000 + viewport[3], 3006);
  EXPECT_EQ(program, 0);
  EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteFramebuffers(1, &framebuffer);
}

INSTANTIATE_TEST_SUITE_P(profiles, Views, testing::Values(GlProfile::core_or_es, GlProfile::es));

TEST(Png, comes_back_as_it_was) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "psm_png_test.png";
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 3 * 2 * 4; ++i) rgba.push_back(std::uint8_t(i * 11));
  EXPECT_FALSE(write_png(file, 3, 2, rgba));
  int width = 0, height = 0, channels = 0;
  stbi_uc* back = stbi_load(file.c_str(), &width, &height, &channels, 4);
  ASSERT_NE(back, nullptr);
  EXPECT_EQ(width, 3);
  EXPECT_EQ(height, 2);
  EXPECT_EQ(std::vector<std::uint8_t>(back, back + rgba.size()), rgba);
  stbi_image_free(back);
  std::filesystem::remove(file);
}

TEST(Png, says_what_is_wrong) {
  const std::vector<std::uint8_t> rgba(4);
  const auto size = write_png("/tmp/x.png", 0, 1, rgba);
  ASSERT_TRUE(size);
  EXPECT_NE(size->text.find("0x1"), std::string::npos);
  const auto folder = write_png("/nowhere/at/all.png", 1, 1, rgba);
  ASSERT_TRUE(folder);
  EXPECT_NE(folder->text.find("/nowhere/at/all.png"), std::string::npos);
}

}  // namespace
}  // namespace psm
