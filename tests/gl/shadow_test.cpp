// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl_fixture.h"

namespace psm {
namespace {

class Shadows : public GlTest {
 protected:
  /// A near-white floor of 4 x 4 at y = 0, and a plate of 1 x 1 over its middle at y = 1; both from above counter-clockwise.
  static Scene floor_and_plate(glm::dvec3 at = glm::dvec3(0.0), double unit = 1.0) {
    Scene scene = empty_scene();
    scene.materials[0].base_color = {0.85f, 0.85f, 0.85f, 1.0f};
    add_quad(scene, at + unit * glm::dvec3(-2, 0, 2), unit * glm::dvec3(4, 0, 0), unit * glm::dvec3(0, 0, -4));
    add_quad(scene, at + unit * glm::dvec3(-0.5, 1, 0.5), unit * glm::dvec3(1, 0, 0), unit * glm::dvec3(0, 0, -1));
    return scene;
  }

  static Analysis lit_from_above(int resolution) {
    Analysis analysis;
    analysis.light = {0, 1, 0, 0};
    analysis.experiment.light.type = LightType::directional;
    analysis.experiment.shadow.resolution = resolution;
    analysis.map_from_world = map_from_above(2.0, 2.0, -1.0);
    analysis.depth_body = everything();
    return analysis;
  }

  /// From below the plate and above the floor, so that the floor is seen with its shadow: straight down from y = 0.5.
  static ViewPicture seen_under_plate() {
    ViewPicture picture;
    picture.id = ViewId::eye;
    picture.clip_from_world = map_from_above(2.0, 0.5, -0.5);
    return picture;
  }
};

TEST_P(Shadows, depth_is_the_analytic_one) {
  renderer_->set_scene(floor_and_plate());
  Analysis analysis = lit_from_above(64);
  analysis.experiment.shadow.depth_bias = 0.0;
  renderer_->draw_shadow_map(analysis);
  const std::vector<float> depth = renderer_->read_map_depth();
  ASSERT_EQ(depth.size(), 64u * 64u);
  // 3 units of depth range: the floor lies 2 below the top, the plate 1. The plate covers texels 24 to 39.
  EXPECT_NEAR(depth[0], 2.0 / 3.0, 1e-6);
  EXPECT_NEAR(depth[32 * 64 + 32], 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(depth[32 * 64 + 24], 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(depth[32 * 64 + 23], 2.0 / 3.0, 1e-6);
}

TEST_P(Shadows, casters_outside_the_depth_body_are_left_out) {
  renderer_->set_scene(floor_and_plate());
  Analysis analysis = lit_from_above(8);
  analysis.experiment.shadow.depth_bias = 0.0;                  // for which a map is drawn even of a floor alone
  analysis.depth_body = box_body({-2, -0.1, -2}, {2, 0.9, 2});  // the floor, but not the plate
  renderer_->draw_shadow_map(analysis);
  const std::vector<float> without_plate = renderer_->read_map_depth();
  ASSERT_EQ(without_plate.size(), 64u);
  EXPECT_NEAR(without_plate[4 * 8 + 4], without_plate[0], 1e-6);
  analysis.depth_body = {};  // nothing is visible
  renderer_->draw_shadow_map(analysis);
  EXPECT_TRUE(renderer_->read_map_depth().empty());
}

TEST_P(Shadows, no_map_is_drawn_where_nothing_reaches_into_the_depth_body) {
  Analysis analysis = lit_from_above(64);
  EXPECT_NEAR(pixel(draw(floor_and_plate(), analysis, seen_under_plate(), {40, 40}), 20, 20).g, 0x80, 3);
  EXPECT_EQ(renderer_->map_triangles(), 4u);
  analysis.depth_body = box_body({-2, 1.5, -2}, {2, 3, 2});
  EXPECT_NEAR(pixel(draw(floor_and_plate(), analysis, seen_under_plate(), {40, 40}), 20, 20).g, 0xE8, 3) << "all is lit";
  EXPECT_EQ(renderer_->map_triangles(), 0u);
  ViewPicture map;
  map.id = ViewId::map;
  map.scene = ScenePicture::map_depth;
  const Image hatched = draw(floor_and_plate(), analysis, map, {60, 60});
  draw(floor_and_plate(), lit_from_above(64), map, {60, 60});
  EXPECT_NE(hatched.rgba, renderer_->read_view(ViewId::map).rgba);
  analysis.depth_body = everything();
  EXPECT_NEAR(pixel(draw(floor_and_plate(), analysis, seen_under_plate(), {40, 40}), 20, 20).g, 0x80, 3) << "and it comes back";
}

TEST_P(Shadows, no_map_is_drawn_of_one_plane_unless_its_acne_is_to_be_seen) {
  renderer_->set_scene(floor_and_plate());
  Analysis analysis = lit_from_above(64);
  analysis.depth_body = box_body({-2, -0.1, -2}, {2, 0.9, 2});  // the floor alone
  const auto triangles = [&] {
    renderer_->update_shadow_map(analysis);
    return renderer_->map_triangles();
  };
  EXPECT_EQ(triangles(), 0u);
  analysis.experiment.shadow.depth_bias = 0.0;
  EXPECT_EQ(triangles(), 2u);
  analysis.experiment.shadow.normal_bias = 0.5;
  EXPECT_EQ(triangles(), 0u);
  analysis.depth_body = everything();
  EXPECT_EQ(triangles(), 4u);
}

TEST_P(Shadows, a_map_that_would_come_out_the_same_is_not_drawn_again) {
  renderer_->set_scene(floor_and_plate());
  Analysis analysis = lit_from_above(64);
  const auto drawn_for = [&](const Analysis& a) {
    const int before = renderer_->maps_drawn();
    renderer_->update_shadow_map(a);
    return renderer_->maps_drawn() - before;
  };
  EXPECT_EQ(drawn_for(analysis), 1);
  analysis.experiment.view.map_zoom = 2.0;
  analysis.experiment.image.width = 100;
  EXPECT_EQ(drawn_for(analysis), 0);
  EXPECT_EQ(renderer_->map_triangles(), 4u);
  analysis.experiment.shadow.depth_bias = 3.0;
  EXPECT_EQ(drawn_for(analysis), 1);
  analysis.experiment.shadow.resolution = 32;
  EXPECT_EQ(drawn_for(analysis), 1);
  analysis.map_from_world = map_from_above(2.0, 2.5, -1.0);
  EXPECT_EQ(drawn_for(analysis), 1);
  analysis.depth_body = box_body({-3, -1, -3}, {3, 3, 3});
  EXPECT_EQ(drawn_for(analysis), 1);
  EXPECT_EQ(drawn_for(analysis), 0);
  renderer_->set_scene(floor_and_plate());
  EXPECT_EQ(drawn_for(analysis), 1);
}

TEST_P(Shadows, rows_of_depth_go_upwards) {
  Scene scene = empty_scene();
  add_quad(scene, {-2, 0, 0}, {4, 0, 0}, {0, 0, -2});  // z < 0: up in the map
  renderer_->set_scene(scene);
  Analysis analysis = lit_from_above(8);
  analysis.experiment.shadow.depth_bias = 0.0;  // for which a map is drawn even of one plane
  renderer_->draw_shadow_map(analysis);
  const std::vector<float> depth = renderer_->read_map_depth();
  ASSERT_EQ(depth.size(), 64u);
  EXPECT_EQ(depth[1 * 8 + 4], 1.0f);
  EXPECT_LT(depth[6 * 8 + 4], 1.0f);
}

TEST_P(Shadows, bias_is_in_texels_of_slope) {
  Scene scene = empty_scene();
  add_quad(scene, {-2, -0.5, 2}, {4, 1, 0}, {0, 0, -4});  // rises with x: 1 in 4
  renderer_->set_scene(scene);
  Analysis analysis = lit_from_above(64);
  analysis.experiment.shadow.depth_bias = 0.0;
  renderer_->draw_shadow_map(analysis);
  const float without = renderer_->read_map_depth()[32 * 64 + 32];
  analysis.experiment.shadow.depth_bias = 3.0;
  renderer_->draw_shadow_map(analysis);
  const float with = renderer_->read_map_depth()[32 * 64 + 32];
  const double slope = 1.0 / 64 / 3.0;  // depth per texel
  EXPECT_NEAR(with - without, 3.0 * slope, 1e-5);
}

TEST_P(Shadows, survive_a_washed_out_projector) {
  const Image image = draw(floor_and_plate(), lit_from_above(64), seen_under_plate(), {80, 80});
  EXPECT_NEAR(pixel(image, 10, 10).g, 0xE8, 3);  // lit
  EXPECT_NEAR(pixel(image, 40, 40).g, 0x80, 3);  // shadow
  EXPECT_NEAR(pixel(image, 31, 40).g, 0x80, 3);  // the plate's edge is at pixel 30
  EXPECT_NEAR(pixel(image, 28, 40).g, 0xE8, 3);
}

TEST_P(Shadows, are_the_same_far_away_and_at_any_scale) {
  const Image near = draw(floor_and_plate(), lit_from_above(64), seen_under_plate(), {40, 40});
  for (const double unit : {1.0, 1e-6, 1e6}) {
    const glm::dvec3 at = unit * glm::dvec3(3e6, -2e6, 1e6);
    const glm::dmat4 back = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / unit)) * glm::translate(glm::dmat4(1.0), -at);
    Analysis analysis = lit_from_above(64);
    analysis.map_from_world = *analysis.map_from_world * back;
    ViewPicture picture = seen_under_plate();
    picture.clip_from_world = picture.clip_from_world * back;
    const Image far = draw(floor_and_plate(at, unit), analysis, picture, {40, 40});
    EXPECT_EQ(near.rgba, far.rgba) << unit;
  }
}

TEST_P(Shadows, surfaces_that_face_away_are_dark) {
  Analysis analysis = lit_from_above(64);
  analysis.light = {0, -1, 0, 0};
  const Image image = draw(floor_and_plate(), analysis, seen_under_plate(), {40, 40});
  EXPECT_NEAR(pixel(image, 5, 5).g, 0x80, 3);
}

TEST_P(Shadows, outside_the_map_everything_is_lit) {
  Analysis analysis = lit_from_above(64);
  analysis.map_from_world = map_from_above(0.25, 2.0, -1.0);  // within the plate's shadow
  const Image image = draw(floor_and_plate(), analysis, seen_under_plate(), {80, 80});
  EXPECT_NEAR(pixel(image, 40, 40).g, 0x80, 3);
  EXPECT_NEAR(pixel(image, 33, 40).g, 0xE8, 3);  // x = -0.35: under the plate, outside the map
}

TEST_P(Shadows, behind_a_perspective_map_everything_is_lit) {
  Analysis analysis = lit_from_above(64);
  analysis.light = {0, 0.5, 0, 1};  // between floor and plate
  const glm::dmat4 upwards = glm::lookAtRH(glm::dvec3(0, 0.5, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));
  analysis.map_from_world = glm::perspectiveRH_NO(2.0, 1.0, 0.1, 4.0) * upwards;
  const Image image = draw(floor_and_plate(), analysis, seen_under_plate(), {80, 80});
  EXPECT_GT(pixel(image, 40, 40).g, 0xE0);
}

TEST_P(Shadows, six_maps_are_one) {
  Analysis analysis = lit_from_above(32);
  analysis.light = {0, 1.5, 0, 1};
  analysis.map_from_world.reset();
  const glm::dvec3 eye(0, 1.5, 0);
  const glm::dvec3 axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  analysis.cube_maps_from_world.emplace();
  for (int i = 0; i < 6; ++i) {
    const glm::dvec3 up = i / 2 == 1 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    (*analysis.cube_maps_from_world)[std::size_t(i)] =
        glm::perspectiveRH_NO(glm::radians(90.0), 1.0, 0.01, 10.0) * glm::lookAtRH(eye, eye + axes[i], up);
  }
  const Image image = draw(floor_and_plate(), analysis, seen_under_plate(), {160, 160});
  // The plate at half a unit below the light shadows the floor over three times its size: x in [-1.5, 1.5].
  EXPECT_LT(pixel(image, 80, 80).g, 0x90);
  EXPECT_LT(pixel(image, 24, 80).g, 0x90);
  EXPECT_GT(pixel(image, 12, 80).g, 0xA0);
  EXPECT_GT(pixel(image, 80, 155).g, 0xA0);
  ViewPicture sheet;
  sheet.scene = ScenePicture::map_depth;
  draw(floor_and_plate(), analysis, sheet, {60, 60});
}

TEST_P(Shadows, spot_lights_end_at_their_cone) {
  Analysis analysis = lit_from_above(64);
  analysis.light = {0, 1, 0, 1};
  analysis.experiment.light = {LightType::spot, {0, 1, 0}, {0, 1, 0}, {0, 0, 0}, 90.0};
  Scene scene = empty_scene();
  scene.materials[0].base_color = {0.85f, 0.85f, 0.85f, 1.0f};
  add_quad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
  const Image image = draw(scene, analysis, seen_under_plate(), {80, 80});
  EXPECT_NEAR(pixel(image, 40, 40).g, 0xE8, 3);
  EXPECT_GT(pixel(image, 40 + 18, 40).g, 0xC0);       // x = 0.93: inside 45 degrees
  EXPECT_NEAR(pixel(image, 40 + 21, 40).g, 0x80, 3);  // x = 1.08: outside
}

TEST_P(Shadows, transparent_texels_cast_none) {
  Scene scene = floor_and_plate();
  Material cut;
  cut.texture = 0;
  cut.alpha_cutoff = 0.5f;
  scene.materials.push_back(cut);
  scene.textures.push_back({1, 1, {255, 255, 255, 10}, Wrap::repeat, Wrap::repeat, true});
  scene.meshes[1].material = 1;
  const Image image = draw(scene, lit_from_above(64), seen_under_plate(), {40, 40});
  EXPECT_NEAR(pixel(image, 20, 20).g, 0xE8, 3);
}

TEST_P(Shadows, lines_and_points_cast_none) {
  Scene scene = floor_and_plate();
  scene.meshes[1].triangles.clear();
  scene.meshes[1].lines = {0, 2};
  scene.meshes[1].points = {0, 1, 2, 3};
  const Image image = draw(scene, lit_from_above(64), seen_under_plate(), {40, 40});
  EXPECT_NEAR(pixel(image, 20, 20).g, 0xE8, 3);
}

TEST_P(Shadows, need_neither_triangles_nor_a_sound_matrix) {
  Analysis analysis = lit_from_above(16);
  ViewPicture picture = seen_under_plate();
  for (const double bad : {0.0, std::nan(""), 1e308 * 10}) {
    analysis.map_from_world = glm::dmat4(bad);
    picture.clip_from_world = glm::dmat4(bad);
    picture.clip_from_list = glm::dmat4(bad);
    picture.list.lines.push_back({{0, 0, 0, 1}, {1, 1, 1, 1}});
    picture.list.fills.push_back({{{0, 0, 0, 1}, {1, 1, 1, 1}, {0, 1, 1, 1}}});
    picture.list.points.push_back({{0, 0, 0, 1}});
    picture.list.labels.push_back({{0, 0, 0, 1}, "here"});
    for (const ScenePicture kind : {ScenePicture::shadowed, ScenePicture::projective, ScenePicture::map_depth}) {
      picture.scene = kind;
      EXPECT_EQ(draw(floor_and_plate(), analysis, picture, {1, 1}).rgba.size(), 4u);
      EXPECT_EQ(draw(empty_scene(), analysis, picture, {0, -3}).rgba.size(), 4u);
    }
  }
}

TEST_P(Shadows, tell_the_resolution_they_got) {
  renderer_->set_scene(floor_and_plate());
  renderer_->draw_shadow_map(lit_from_above(48));
  EXPECT_EQ(renderer_->map_resolution(), 48);
  renderer_->draw_shadow_map(lit_from_above(1 << 20));
  EXPECT_GE(renderer_->map_resolution(), 2048);
  EXPECT_LT(renderer_->map_resolution(), 1 << 20);
}

INSTANTIATE_TEST_SUITE_P(profiles, Shadows, testing::Values(GlProfile::core_or_es, GlProfile::es));

}  // namespace
}  // namespace psm
