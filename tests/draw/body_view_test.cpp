// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw/view.h"
#include "scene/experiment_file.h"

namespace psm {
namespace {

using ::testing::HasSubstr;

Analysis analysis_of(const std::vector<std::string>& overrides) {
  const auto loaded = load_experiment("chessboard", overrides);
  EXPECT_TRUE(loaded) << loaded.error().text;
  return analyze(loaded->experiment, loaded->scene);
}

ViewPicture body_picture(const Analysis& analysis) { return describe_view(ViewId::body, analysis, {800, 600}); }

bool shows(const ViewPicture& picture, Role role) {
  return std::any_of(picture.list.lines.begin(), picture.list.lines.end(), [&](const DrawLine& l) { return l.role == role; });
}

bool names(const ViewPicture& picture, const std::string& text) {
  const auto& labels = picture.list.labels;
  return std::any_of(labels.begin(), labels.end(), [&](const DrawLabel& l) { return l.text == text; });
}

TEST(BodyView, ShowsEveryBodyOfItsFormula) {
  for (const char* light : {"light.type=directional", "light.type=point", "light.type=spot"}) {
    const ViewPicture picture = body_picture(analysis_of({light}));
    EXPECT_EQ(picture.scene, ScenePicture::none);
    for (const Role role : {Role::caster_body, Role::receivers_body, Role::frustum, Role::scene_bounds})
      EXPECT_TRUE(shows(picture, role)) << light;
    for (const char* name : {"H", "R", "V", "S"}) EXPECT_TRUE(names(picture, name)) << light << " " << name;
    EXPECT_EQ(names(picture, "L"), std::string(light) == "light.type=spot");
  }
}

TEST(BodyView, CountsWhatTheAnalysisHas) {
  const Analysis analysis = analysis_of({});
  const ConvexBody& h = analysis.caster_body;
  const ViewPicture picture = body_picture(analysis);
  ASSERT_EQ(picture.legend.lines.size(), 2u);
  EXPECT_THAT(picture.legend.lines[0],
              HasSubstr(std::to_string(h.vertices.size()) + " corners, " + std::to_string(h.facets.size()) + " facets"));
  EXPECT_EQ(std::count_if(picture.list.points.begin(), picture.list.points.end(),
                          [](const DrawPoint& p) { return p.role == Role::caster_body; }),
            std::ptrdiff_t(h.vertices.size()));
}

TEST(BodyView, HoldsAllCornersOfH) {
  const Analysis analysis = analysis_of({});
  const ViewPicture picture = body_picture(analysis);
  for (const glm::dvec3& v : analysis.caster_body.vertices) {
    const glm::dvec4 q = picture.clip_from_list * glm::dvec4(v, 1.0);
    EXPECT_GT(q.w, 0.0);
    EXPECT_LE(std::max(std::abs(q.x), std::abs(q.y)), q.w);
  }
}

TEST(BodyView, NothingToSeeIsSaid) {
  const Analysis analysis = analysis_of({"camera.target=0,1000,0.01"});
  ASSERT_TRUE(analysis.caster_body.empty());
  const ViewPicture picture = body_picture(analysis);
  EXPECT_THAT(picture.title, HasSubstr("nothing can cast a shadow"));
  EXPECT_THAT(picture.legend.lines[0], HasSubstr("empty"));
}

}  // namespace
}  // namespace psm
