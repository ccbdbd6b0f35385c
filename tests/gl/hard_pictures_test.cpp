// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases in pictures: two experiments on either side of what is hard show the same shadows, pixel by pixel. What the
// numbers say of the same cases stands in tests/measure/hard_cases.csv.
#include <algorithm>
#include <cmath>
#include <functional>

#include "gl_fixture.h"
#include "scene/analysis.h"

namespace psm {
namespace {

constexpr int kSide = 96;

void add_box(Scene& scene, const glm::dvec3& lo, const glm::dvec3& hi) {
  const glm::dvec3 x(hi.x - lo.x, 0, 0), y(0, hi.y - lo.y, 0), z(0, 0, hi.z - lo.z);
  for (const glm::dvec3& corner : {lo, lo + z}) add_quad(scene, corner, x, y);
  for (const glm::dvec3& corner : {lo, lo + x}) add_quad(scene, corner, y, z);
  for (const glm::dvec3& corner : {lo, lo + y}) add_quad(scene, corner, z, x);
}

/// A floor under three blocks, moved by `offset`.
Scene blocks_at(const glm::dvec3& offset = glm::dvec3(0), double thickness = 0.1) {
  Scene scene;
  scene.materials.emplace_back();
  add_box(scene, offset + glm::dvec3(-6, -thickness, -14), offset + glm::dvec3(6, 0, 2));
  for (const glm::dvec2 place : {glm::dvec2(-2.5, -5), glm::dvec2(0, -8), glm::dvec2(2.2, -4)}) {
    const glm::dvec3 corner = offset + glm::dvec3(place.x, 0, place.y);
    add_box(scene, corner, corner + glm::dvec3(1.1, 1.6, 0.9));
  }
  return scene;
}

/// A floor under plates: nothing is parallel to a light from above, where a wall would be lit and dark by turns, and rightly so.
Scene plates() {
  Scene scene;
  scene.materials.emplace_back();
  add_quad(scene, {-6, 0, 2}, {12, 0, 0}, {0, 0, -16});
  for (const glm::dvec3& corner : {glm::dvec3(-2.5, 0.8, -5), glm::dvec3(0, 1.2, -8), glm::dvec3(2.2, 0.6, -4)})
    add_quad(scene, corner, {1.4, 0, 0}, {0, 0, -1.3});
  return scene;
}

Experiment seen_from(const glm::dvec3& eye, Technique technique = Technique::psm) {
  Experiment x;
  x.camera = {eye, eye + glm::dvec3(0, 0, -1), {0, 1, 0}, 60, 0.5, 60};
  x.image = {kSide, kSide};
  x.shadow.technique = technique;
  x.shadow.resolution = 1024;
  x.light.to_light = {0.5, 1, 0.3};
  return x;
}

const glm::dvec3 kEye(0.3, 1.7, 1);

Experiment sun(const glm::dvec3& to_light, Technique technique = Technique::psm) {
  Experiment x = seen_from(kEye, technique);
  x.light.to_light = to_light;
  return x;
}

Experiment lamp(const glm::dvec3& position) {
  Experiment x = seen_from(kEye);
  x.light.type = LightType::point;
  x.light.position = position;
  return x;
}

class HardPictures : public GlTest {
 protected:
  std::vector<MapVerdict> verdicts(const Experiment& x, const Scene& scene) {
    const Analysis analysis = analyze(x, scene);
    renderer_->set_scene(scene);
    renderer_->draw_shadow_map(analysis);
    return renderer_->read_map(analysis, kSide, kSide).verdicts;
  }

  /// Both have light and shadow, nothing falls off the map, and only a texel's breadth of a shadow's edge may differ.
  void same(const Experiment& a, const Scene& in_a, const Experiment& b, const Scene& in_b, double part = 0.002) {
    const auto one = verdicts(a, in_a), other = verdicts(b, in_b);
    int differ = 0;
    for (std::size_t i = 0; i < one.size(); ++i) differ += one[i] != other[i];
    EXPECT_LE(differ, part * kSide * kSide);
    for (const auto* v : {&one, &other}) {
      EXPECT_GT(std::count(v->begin(), v->end(), MapVerdict::dark), kSide);
      EXPECT_GT(std::count(v->begin(), v->end(), MapVerdict::lit), kSide * kSide / 10);
      EXPECT_EQ(std::count(v->begin(), v->end(), MapVerdict::outside), 0);
    }
  }
  void same(const Experiment& a, const Experiment& b, double part = 0.002) { same(a, blocks_at(), b, blocks_at(), part); }
};

TEST_P(HardPictures, a_sun_passes_the_camera_plane) {  // case 13
  same(sun({0.4, 1, -1e-7}), sun({0.4, 1, 1e-7}));
  same(sun({0.4, 1, 0}), sun({0.4, 1, 1e-7}));
}

TEST_P(HardPictures, a_lamp_passes_the_camera_plane) {  // cases 19 and 20
  same(lamp({3, 9, kEye.z - 1e-6}), lamp({3, 9, kEye.z + 1e-6}));
  same(lamp({3, 9, kEye.z}), lamp({3, 9, kEye.z + 1e-6}));
}

// The map's grid turns there (the known limit of case 36), and the edges of shadows with it, by a texel.
TEST_P(HardPictures, a_sun_passes_the_view_direction) {
  same(sun({1e-7, 0, 1}), sun({0, 1e-7, 1}), 0.02);
  same(sun({1e-7, 0, 1}), sun({0, 0, 1}), 0.02);
}

TEST_P(HardPictures, a_sun_passes_the_zenith) {  // case 36
  same(sun({1e-7, 1, 0}), plates(), sun({-1e-7, 1, 0}), plates());
  same(sun({0, 1, 1e-7}), plates(), sun({0, 1, -1e-7}), plates());
}

TEST_P(HardPictures, gmnpr_passes_its_critical_angle) {  // case 3
  const double phi = std::atan(std::tan(30 / 57.29577951308232));
  const auto at = [](double theta) { return sun({0, std::sin(theta), std::cos(theta)}, Technique::gmnpr); };
  same(at(phi - 1e-12), at(phi + 1e-12));
  same(at(phi - 1e-7), at(phi + 1e-7));
}

TEST_P(HardPictures, a_scene_is_far_from_the_origin) {  // case 40; positions of double are 1e-9 apart at 6.4e6
  for (const double distance : {2000.0, 6.4e6}) {
    const glm::dvec3 offset(distance, 0, distance);
    same(seen_from(kEye), blocks_at(), seen_from(kEye + offset), blocks_at(offset));
  }
}

TEST_P(HardPictures, a_scene_is_almost_flat) {  // cases 28 and 35
  same(seen_from(kEye), blocks_at(glm::dvec3(0), 1e-9), seen_from(kEye), blocks_at(glm::dvec3(0), 1e-3));
}

TEST_P(HardPictures, an_eye_passes_zero) {  // case 41
  Experiment left = seen_from({-1e-6, 1.7, 1}), right = seen_from({1e-6, 1.7, 1});
  same(left, right);
}

INSTANTIATE_TEST_SUITE_P(profiles, HardPictures, testing::Values(GlProfile::core_or_es, GlProfile::es));

}  // namespace
}  // namespace psm
