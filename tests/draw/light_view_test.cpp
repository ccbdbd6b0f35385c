// SPDX-License-Identifier: GPL-3.0-or-later
// The scene as the light sees it stands exactly where the map has it.
#include <gtest/gtest.h>

#include "draw/view.h"
#include "scene/experiment_file.h"

namespace psm {
namespace {

ViewPicture light_view(const std::vector<std::string>& overrides, Analysis& analysis) {
  auto loaded = load_experiment("ground", overrides);
  EXPECT_TRUE(loaded);
  loaded->experiment.view.map_shows = MapShows::scene;
  analysis = analyze(loaded->experiment, loaded->scene);
  return describe_view(ViewId::map, analysis, {640, 480});
}

glm::dvec3 divided(const glm::dvec4& p) { return glm::dvec3(p) / p.w; }

TEST(LightView, PutsPointsWhereTheMapHasThem) {
  Analysis a;
  const ViewPicture picture = light_view({}, a);
  EXPECT_EQ(picture.scene, ScenePicture::shadowed);
  for (const glm::dvec3& p : a.receivers_body.vertices) {
    const glm::dvec3 on_map = divided(*a.map_from_world * glm::dvec4(p, 1.0)),
                     seen = divided(picture.clip_from_world * glm::dvec4(p, 1.0));
    const glm::dvec3 outline = divided(picture.clip_from_list * glm::dvec4(on_map.x, on_map.y, 0.0, 1.0));
    EXPECT_NEAR(seen.x, outline.x, 1e-9);
    EXPECT_NEAR(seen.y, outline.y, 1e-9);
    EXPECT_NEAR(seen.z, on_map.z, 1e-9);
    EXPECT_LT(outline.z, seen.z + 1e-9) << "outlines stand before the scene";
  }
}

TEST(LightView, SeesTheNearestFirstWhereTheMapKeepsTheFarthest) {
  Analysis a;
  const ViewPicture picture =
      light_view({"shadow.technique=psm_divided", "shadow.camera_shift=0", "light.to_light=0.2,0.5,1"}, a);
  ASSERT_TRUE(a.reversed_depth);
  const glm::dvec4 p(a.receivers_body.centroid(), 1.0);
  EXPECT_NEAR(divided(picture.clip_from_world * p).z, -divided(*a.map_from_world * p).z, 1e-9);
}

TEST(LightView, StaysAMapWhereThereAreSix) {
  Analysis a;
  const ViewPicture picture = light_view({"light.type=point", "light.position=0,1,-10"}, a);
  ASSERT_TRUE(a.cube_maps_from_world);
  EXPECT_EQ(picture.scene, ScenePicture::map_depth);
}

}  // namespace
}  // namespace psm
