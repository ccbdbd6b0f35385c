// SPDX-License-Identifier: GPL-3.0-or-later
// What the map says at each pixel, read back; and the timer of passes.
#include "gl/pass_timer.h"
#include "gl_fixture.h"

namespace psm {
namespace {

class Verdicts : public GlTest {
 protected:
  /// Straight down from y = 0.5, between a floor of 4 x 4 and a plate of 1 x 1 over its middle, under a light from above.
  static Analysis seen_under_plate() {
    Analysis analysis;
    analysis.light = {0, 1, 0, 0};
    analysis.experiment.light.type = LightType::directional;
    analysis.experiment.shadow.resolution = 64;
    analysis.map_from_world = map_from_above(2.0, 2.0, -1.0);
    analysis.depth_body = everything();
    analysis.clip_from_view = map_from_above(4.0, 0.5, -0.5);
    return analysis;
  }

  static Scene floor_and_plate() {
    Scene scene = empty_scene();
    add_quad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    add_quad(scene, {-0.5, 1, 0.5}, {1, 0, 0}, {0, 0, -1});
    return scene;
  }

  std::vector<MapVerdict> read(const Scene& scene, const Analysis& analysis, int width, int height) {
    renderer_->set_scene(scene);
    renderer_->draw_shadow_map(analysis);
    return renderer_->read_map(analysis, width, height).verdicts;
  }

  static std::size_t count(const std::vector<MapVerdict>& verdicts, MapVerdict wanted) {
    return std::size_t(std::count(verdicts.begin(), verdicts.end(), wanted));
  }
};

TEST_P(Verdicts, are_dark_lit_and_unseen_where_they_must) {
  // 8 x 8 units in 80 x 80 pixels: the floor covers the middle 40 x 40, the shadow 10 x 10 of them.
  const auto verdicts = read(floor_and_plate(), seen_under_plate(), 80, 80);
  ASSERT_EQ(verdicts.size(), 6400u);
  EXPECT_EQ(count(verdicts, MapVerdict::unseen), 6400u - 1600u);
  EXPECT_EQ(count(verdicts, MapVerdict::outside), 0u);
  EXPECT_EQ(count(verdicts, MapVerdict::dark), 100u);
  EXPECT_EQ(count(verdicts, MapVerdict::lit), 1500u);
  EXPECT_EQ(verdicts[40 * 80 + 40], MapVerdict::dark);
}

TEST_P(Verdicts, say_where_the_map_ends) {
  Analysis analysis = seen_under_plate();
  analysis.map_from_world = map_from_above(1.0, 2.0, -1.0);
  const auto verdicts = read(floor_and_plate(), analysis, 80, 80);
  EXPECT_EQ(count(verdicts, MapVerdict::outside), 1600u - 400u);
  EXPECT_EQ(count(verdicts, MapVerdict::dark), 100u);
}

TEST_P(Verdicts, go_from_top_to_bottom) {
  Scene scene = empty_scene();
  add_quad(scene, {-2, 0, 0}, {4, 0, 0}, {0, 0, -2});  // z < 0: up in the image
  const auto verdicts = read(scene, seen_under_plate(), 16, 16);
  EXPECT_EQ(verdicts[6 * 16 + 8], MapVerdict::lit);
  EXPECT_EQ(verdicts[9 * 16 + 8], MapVerdict::unseen);
}

TEST_P(Verdicts, ignore_which_way_the_surface_faces) {
  Analysis analysis = seen_under_plate();
  const auto facing = read(floor_and_plate(), analysis, 80, 80);
  analysis.light = {0, -1, 0, 0};
  EXPECT_EQ(renderer_->read_map(analysis, 80, 80).verdicts, facing);
}

TEST_P(Verdicts, are_of_triangles_alone) {
  Scene scene = floor_and_plate();
  Mesh marks = scene.meshes[0];
  marks.triangles.clear();
  for (glm::dvec3& p : marks.positions) p.y += 0.1;
  marks.lines = {0, 2, 1, 3};
  marks.points = {0, 1, 2, 3};
  const auto without = read(scene, seen_under_plate(), 80, 80);
  scene.meshes.push_back(marks);
  EXPECT_EQ(read(scene, seen_under_plate(), 80, 80), without);
}

TEST_P(Verdicts, agree_with_the_picture_of_the_eye) {
  const Analysis analysis = seen_under_plate();
  Scene scene = floor_and_plate();
  scene.materials[0].base_color = {0.85f, 0.85f, 0.85f, 1.0f};
  const auto verdicts = read(scene, analysis, 80, 80);
  ViewPicture picture;
  picture.id = ViewId::eye;
  picture.clip_from_world = analysis.clip_from_world();
  const Image image = draw(scene, analysis, picture, {80, 80});
  for (int i = 0; i < 6400; ++i) {
    const int green = pixel(image, i % 80, i / 80).g;
    const MapVerdict verdict = verdicts[std::size_t(i)];
    if (verdict != MapVerdict::unseen) {
      EXPECT_NEAR(green, verdict == MapVerdict::lit ? 0xE8 : 0x80, 3) << i;
    }
  }
}

TEST_P(Verdicts, a_pass_is_drawn_once_and_its_time_is_a_number) {
  const PassTimer timer;
  int calls = 0;
  const Analysis analysis = seen_under_plate();
  renderer_->set_scene(floor_and_plate());
  const PassTime time = timer.time([&] {
    ++calls;
    renderer_->draw_shadow_map(analysis);
  });
  EXPECT_EQ(calls, 1);
  EXPECT_GT(time.wall, 0.0);
  EXPECT_GE(time.gpu.value_or(0.0), 0.0);
  EXPECT_NE(gl_renderer_name(), "");
}

INSTANTIATE_TEST_SUITE_P(profiles, Verdicts, testing::Values(GlProfile::core_or_es, GlProfile::es));

}  // namespace
}  // namespace psm
