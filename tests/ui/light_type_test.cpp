// SPDX-License-Identifier: GPL-3.0-or-later
// Another type of light starts where the light is.
#include "harness.h"
#include "scene/light_angles.h"
#include "ui/field_widgets.h"

namespace psm::test {
namespace {

void choose(Bench& bench, const std::string& type) {
  bench.click(bench.at("light.type"));
  bench.click(bench.at("light.type=" + type));
  EXPECT_EQ(name_of(bench.experiment().light.type), type);
}

glm::dvec3 middle_of(const Bench& bench) { return bench.analysis().receivers_body.centroid(); }

void expect_same(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_NEAR(glm::length(a - b), 0.0, 1e-9 * (1.0 + glm::length(b)));
}

TEST(LightType, ASpotGivesItsDirection) {
  Bench bench("ground", {"light.type=spot", "light.position=-6,9,-8", "light.target=0,0,-12"});
  choose(bench, "directional");
  expect_same(bench.experiment().light.to_light, glm::normalize(glm::dvec3(-6, 9, 4)));
}

TEST(LightType, APointGivesTheDirectionFromWhatIsSeen) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8"});
  const glm::dvec3 wanted = glm::normalize(glm::dvec3(-6, 9, -8) - middle_of(bench));
  choose(bench, "directional");
  expect_same(bench.experiment().light.to_light, wanted);
}

TEST(LightType, ADirectionGivesAPositionAndBack) {
  for (const char* type : {"point", "spot"}) {
    Bench bench("ground");
    const glm::dvec3 to_light = glm::normalize(bench.experiment().light.to_light), middle = middle_of(bench);
    choose(bench, type);
    const LightSettings& light = bench.experiment().light;
    expect_same(light.position, middle + scene_size(bench.work().model().scene()) * to_light);
    if (light.type == LightType::spot) expect_same(light.target, middle);
    bench.key('Z', {true, false, false});
    EXPECT_EQ(bench.experiment().light.type, LightType::directional) << "one entry in the history";
  }
}

TEST(LightType, PointAndSpotShareThePosition) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8"});
  const glm::dvec3 middle = middle_of(bench);
  choose(bench, "spot");
  EXPECT_EQ(bench.experiment().light.position, glm::dvec3(-6, 9, -8));
  expect_same(bench.experiment().light.target, middle);
  choose(bench, "point");
  EXPECT_EQ(bench.experiment().light.position, glm::dvec3(-6, 9, -8));
}

TEST(LightType, ALightInTheMiddleKeepsWhatItHad) {
  LightSettings light;
  light.type = LightType::point;
  const LightSettings sun = with_type(light, LightType::directional, light.position, 10.0);
  EXPECT_EQ(sun.to_light, light.to_light);
}

}  // namespace
}  // namespace psm::test
