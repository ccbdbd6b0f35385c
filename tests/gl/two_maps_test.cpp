// SPDX-License-Identifier: GPL-3.0-or-later
// Technique psm_two_maps on the card: casters behind the eye have a map of their own, and their shadows are right.
#include "gl_fixture.h"

namespace psm {
namespace {

class TwoMaps : public GlTest {
 protected:
  /// A floor, a plate in front of the eye, one behind it, and one that reaches from the one side to the other.
  static Scene floor_and_plates() {
    Scene scene = empty_scene();
    scene.materials[0].base_color = {0.85f, 0.85f, 0.85f, 1.0f};
    add_quad(scene, {-30, 0, 30}, {60, 0, 0}, {0, 0, -60});
    add_quad(scene, {-3, 2, -6}, {2, 0, 0}, {0, 0, -2});
    add_quad(scene, {1, 14, 13}, {3, 0, 0}, {0, 0, -3});
    add_quad(scene, {-5, 4, 5}, {1, 0, 0}, {0, 0, -9});
    return scene;
  }

  static Experiment seen_with(const glm::dvec3& to_light, Technique technique) {
    Experiment x;
    x.camera = {{0, 3, 0}, {0, 1, -8}, {0, 1, 0}, 70, 0.5, 40};
    x.image = {160, 120};
    x.light.to_light = to_light;
    x.shadow.technique = technique;
    x.shadow.resolution = 2048;
    return x;
  }

  Image eye_of(const Analysis& analysis) {
    return draw(floor_and_plates(), analysis, describe_view(ViewId::eye, analysis, {160, 120}), {160, 120});
  }

  static double differing(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x) count += std::abs(pixel(a, x, y).g - pixel(b, x, y).g) > 24;
    return double(count) / (a.width * a.height);
  }
};

constexpr double kEdges = 0.01;  // of all pixels: those that shadows' edges run through

TEST_P(TwoMaps, show_what_a_uniform_map_shows) {
  for (const glm::dvec3 to_light : {glm::dvec3(0.2, 1, 1.2), glm::dvec3(0.1, 1, -0.7)}) {
    const Analysis two = analyze(seen_with(to_light, Technique::psm_two_maps), floor_and_plates());
    const Analysis one = analyze(seen_with(to_light, Technique::uniform), floor_and_plates());
    EXPECT_EQ(two.map_beyond_from_world.has_value(), to_light.z > 0.0);
    EXPECT_LT(differing(eye_of(two), eye_of(one)), kEdges);
  }
}

TEST_P(TwoMaps, the_second_holds_the_casters_behind_the_eye) {
  Analysis analysis = analyze(seen_with({0.2, 1, 1.2}, Technique::psm_two_maps), floor_and_plates());
  const Image both = eye_of(analysis);
  analysis.map_beyond_from_world.reset();
  const Image first_only = eye_of(analysis);
  EXPECT_GT(differing(both, first_only), 2 * kEdges);
  for (int y = 0; y < both.height; ++y)
    for (int x = 0; x < both.width; ++x) ASSERT_LE(pixel(both, x, y).g, pixel(first_only, x, y).g + 2) << "it only adds shadows";
}

INSTANTIATE_TEST_SUITE_P(profiles, TwoMaps, testing::Values(GlProfile::core_or_es, GlProfile::es));

}  // namespace
}  // namespace psm
