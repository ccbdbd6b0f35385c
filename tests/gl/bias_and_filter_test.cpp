// SPDX-License-Identifier: GPL-3.0-or-later
// Biases, culling and filters on scenes whose answers are known.
#include <cmath>
#include <set>

#include "gl_fixture.h"

namespace psm {
namespace {

constexpr int kSide = 80;  // pixels of the image

class BiasAndFilter : public GlTest {
 protected:
  /// A map of 64 x 64 texels straight from above over 4 x 4 units, from y = 2 down to y = -1; the eye looks down from y = 0.5.
  BiasAndFilter() {
    analysis_.light = {0, 1, 0, 0};
    analysis_.experiment.shadow.resolution = 64;
    analysis_.map_from_world = map_from_above(2.0, 2.0, -1.0);
    analysis_.depth_body = everything();
    analysis_.clip_from_view = map_from_above(2.0, 0.99, -1.0);
  }
  ShadowSettings& shadow() { return analysis_.experiment.shadow; }

  /// A plane that rises with x by `slope`.
  static Scene ramp(double slope) {
    Scene scene = empty_scene();
    add_quad(scene, {-2, -2 * slope, 2}, {4, 4 * slope, 0}, {0, 0, -4});
    return scene;
  }

  /// A floor, and a plate at y = 1 over what is left of x = edge.
  static Scene half_covered(double edge) {
    Scene scene = empty_scene();
    add_quad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    add_quad(scene, {-2, 1, 2}, {edge + 2, 0, 0}, {0, 0, -4});
    return scene;
  }

  MapReading read(const Scene& scene) {
    renderer_->set_scene(scene);
    renderer_->draw_shadow_map(analysis_);
    return renderer_->read_map(analysis_, kSide, kSide);
  }
  double dark_share(const Scene& scene) {
    const MapReading map = read(scene);
    return double(std::count(map.verdicts.begin(), map.verdicts.end(), MapVerdict::dark)) / double(map.verdicts.size());
  }
  /// Of the middle row, by column.
  std::vector<float> middle_row(const Scene& scene) {
    const MapReading map = read(scene);
    const auto first = map.lit.begin() + kSide * (kSide / 2);
    return {first, first + kSide};
  }

  Analysis analysis_;
};

TEST_P(BiasAndFilter, without_bias_there_is_acne_and_half_a_texel_along_the_normal_cures_it_at_any_slope) {
  for (const double slope : {0.1, 0.3, 0.45}) {
    SCOPED_TRACE(slope);
    shadow().depth_bias = 0.0, shadow().normal_bias = 0.0;
    EXPECT_GT(dark_share(ramp(slope)), 0.2);
    shadow().normal_bias = 0.3;
    EXPECT_GT(dark_share(ramp(slope)), 0.0);
    shadow().normal_bias = 0.51;
    EXPECT_EQ(dark_share(ramp(slope)), 0.0);
    shadow().normal_bias = 0.0, shadow().depth_bias = 1.5;
    EXPECT_EQ(dark_share(ramp(slope)), 0.0);
  }
}

TEST_P(BiasAndFilter, half_a_texel_along_the_normal_cures_acne_in_a_warped_map_too) {
  // w from 0.2 to 1.8 across the map: texels on one side are nine times as large as on the other.
  glm::dmat4 warp(1.0);
  warp[0][3] = 0.8;
  analysis_.map_from_world = warp * *analysis_.map_from_world;
  shadow().depth_bias = 0.0;
  for (const double slope : {-0.45, 0.2, 0.45}) {
    shadow().normal_bias = 0.0;
    EXPECT_GT(dark_share(ramp(slope)), 0.2) << slope;
    shadow().normal_bias = 0.51;
    EXPECT_EQ(dark_share(ramp(slope)), 0.0) << slope;
  }
}

TEST_P(BiasAndFilter, a_constant_bias_suits_gentle_slopes_alone) {
  shadow().depth_bias = 0.2, shadow().slope_bias = 0.0;
  EXPECT_EQ(dark_share(ramp(0.3)), 0.0);  // half a texel of it is 0.15 of a texel's size
  EXPECT_GT(dark_share(ramp(0.49)), 0.0);
  shadow().depth_bias = 0.5;
  EXPECT_EQ(dark_share(ramp(0.49)), 0.0);
}

TEST_P(BiasAndFilter, shadows_of_what_is_closer_than_the_bias_are_lost) {
  Scene scene = empty_scene();
  add_quad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
  add_quad(scene, {-2, 0.25, 2}, {2, 0, 0}, {0, 0, -4});  // a quarter of a unit over the left half: four texels
  analysis_.clip_from_view = map_from_above(2.0, 0.2, -1.0);
  EXPECT_NEAR(dark_share(scene), 0.5, 0.02);
  shadow().depth_bias = 3.9, shadow().slope_bias = 0.0;
  EXPECT_NEAR(dark_share(scene), 0.5, 0.02);
  shadow().depth_bias = 4.1;
  EXPECT_EQ(dark_share(scene), 0.0);
}

TEST_P(BiasAndFilter, culling_leaves_out_the_faces_that_it_names) {
  Scene scene = empty_scene();
  add_quad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});  // faces up
  add_quad(scene, {-2, 1, -2}, {4, 0, 0}, {0, 0, 4});  // above it, faces down
  const auto depth_with = [&](Cull cull) {
    shadow().cull = cull;
    renderer_->set_scene(scene);
    renderer_->draw_shadow_map(analysis_);
    return renderer_->read_map_depth()[32 * 64 + 32];
  };
  EXPECT_NEAR(depth_with(Cull::none), 1.0 / 3, 1e-6);
  EXPECT_NEAR(depth_with(Cull::front), 1.0 / 3, 1e-6) << "the one below is left out";
  EXPECT_NEAR(depth_with(Cull::back), 2.0 / 3, 1e-6) << "the one above is left out";
  // A mirrored map sees the same faces.
  analysis_.map_from_world = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)) * *analysis_.map_from_world;
  EXPECT_NEAR(depth_with(Cull::back), 2.0 / 3, 1e-6);
  scene.materials[0].double_sided = true;
  EXPECT_NEAR(depth_with(Cull::back), 1.0 / 3, 1e-6);
}

TEST_P(BiasAndFilter, a_map_of_front_faces_or_back_faces_is_drawn_anew) {
  renderer_->set_scene(ramp(0.1));
  for (const Cull cull : {Cull::none, Cull::front, Cull::back}) {
    shadow().cull = cull;
    const int before = renderer_->maps_drawn();
    renderer_->update_shadow_map(analysis_);
    EXPECT_EQ(renderer_->maps_drawn(), before + 1);
  }
}

TEST_P(BiasAndFilter, without_a_filter_a_pixel_is_lit_or_dark) {
  for (const float lit : read(half_covered(0.1)).lit) EXPECT_TRUE(lit == 0.0f || lit == 1.0f) << lit;
}

TEST_P(BiasAndFilter, a_kernel_counts_its_texels) {
  // The edge lies between texels 31 and 32; a kernel of n x n at texel t has so many columns in the light.
  const Scene scene = half_covered(0.0);
  for (const int size : {1, 3, 5, 15}) {
    shadow().filter = Filter::pcf, shadow().filter_size = size;
    const std::vector<float> row = middle_row(scene);
    for (int column = 0; column < kSide; ++column) {
      const int texel = int((column + 0.5) / kSide * 64), lit = std::clamp(texel + size / 2 - 31, 0, size);
      EXPECT_NEAR(row[std::size_t(column)], double(lit) / size, 0.003) << size << ": " << column;
    }
  }
}

TEST_P(BiasAndFilter, the_hardware_weighs_four_texels) {
  shadow().filter = Filter::hardware;
  const std::vector<float> row = middle_row(half_covered(0.0));
  std::set<float> shades(row.begin(), row.end());
  EXPECT_GE(shades.size(), 3u);
  for (int column = 0; column < kSide; ++column) {
    const double from_edge = (column + 0.5) / kSide * 64 - 32;  // texels
    EXPECT_NEAR(row[std::size_t(column)], std::clamp(from_edge + 0.5, 0.0, 1.0), 0.02) << column;
  }
}

TEST_P(BiasAndFilter, a_slope_has_no_acne_whatever_the_filter) {
  shadow().filter = Filter::hardware;
  EXPECT_EQ(dark_share(ramp(0.45)), 0.0);
  shadow().filter = Filter::pcf;
  for (const int size : {3, 15}) {
    shadow().filter_size = size;
    const MapReading map = read(ramp(0.45));
    EXPECT_EQ(std::count(map.lit.begin(), map.lit.end(), 1.0f), std::ptrdiff_t(map.lit.size())) << size;
  }
}

TEST_P(BiasAndFilter, no_setting_makes_anything_but_fractions) {
  for (const double far : {0.0, 0.5, 1000.0})
    for (const Filter filter : {Filter::none, Filter::hardware, Filter::pcf}) {
      shadow().depth_bias = shadow().normal_bias = far;
      shadow().slope_bias = 0.5;
      shadow().filter = filter;
      for (const float lit : read(half_covered(0.3)).lit) ASSERT_TRUE(lit >= 0.0f && lit <= 1.0f);
    }
}

INSTANTIATE_TEST_SUITE_P(profiles, BiasAndFilter, testing::Values(GlProfile::core_or_es, GlProfile::es));

}  // namespace
}  // namespace psm
