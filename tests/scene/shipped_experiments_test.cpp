// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments that come with the program open, and show what their names promise.
#include <gtest/gtest.h>

#include "scene/analysis.h"
#include "scene/experiment_file.h"

namespace psm {
namespace {

Analysis analysis_of(const std::string& name) {
  const auto loaded = load_experiment(PSMLAB_TEST_DATA "/../assets/experiments/" + name + ".psm.json", {});
  EXPECT_TRUE(loaded) << loaded.error().text;
  return analyze(loaded->experiment, loaded->scene);
}

double nearest_depth(const Analysis& a) {
  double nearest = 1e300;
  for (const glm::dvec3& p : a.caster_body.vertices) nearest = std::min(nearest, -(a.view_from_world * glm::dvec4(p, 1)).z);
  return nearest;
}

TEST(ShippedExperiments, EachOneOpens) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PSMLAB_TEST_DATA "/../assets/experiments")) {
    const auto loaded = load_experiment(entry.path().string(), {});
    EXPECT_TRUE(loaded) << loaded.error().text;
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST(ShippedExperiments, Figure6HasASpotWhoseCasterBodyIsLargerThanItsReceivers) {
  const Analysis a = analysis_of("psm2002_figure6");
  EXPECT_EQ(a.light_case.world, LightType::spot);
  EXPECT_GT(a.caster_body.volume(), a.receivers_body.volume() * 1.05);
}

TEST(ShippedExperiments, Figure7HasCastersBehindTheEyeAndTheShiftBringsThemInFront) {
  const Analysis lost = analysis_of("psm2002_figure7"), shifted = analysis_of("psm2002_figure7_shifted");
  EXPECT_EQ(lost.light_case.post, PostLight::inverted_point);
  EXPECT_LT(nearest_depth(lost), 0.0);
  EXPECT_EQ(lost.camera_shift, 0.0);
  EXPECT_NEAR(nearest_depth(shifted) + shifted.camera_shift, *shifted.near, 1e-9);
  const Analysis two = analysis_of("psm2002_figure7_two_maps");
  EXPECT_EQ(two.camera_shift, 0.0);
  EXPECT_TRUE(two.map_beyond_from_world);
}

}  // namespace
}  // namespace psm
