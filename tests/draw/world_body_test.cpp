// SPDX-License-Identifier: GPL-3.0-or-later
// M in the world view: the frustum extended towards the light, before S and L cut it.
#include <gtest/gtest.h>

#include <algorithm>

#include "draw/view.h"
#include "scene/experiment_file.h"

namespace psm {
namespace {

DrawList world(const std::vector<std::string>& overrides) {
  const auto loaded = load_experiment("chessboard", overrides);
  EXPECT_TRUE(loaded) << loaded.error().text;
  return describe_view(ViewId::world, analyze(loaded->experiment, loaded->scene), {800, 600}).list;
}

bool reaches(const DrawList& list, const glm::dvec3& p) {
  return std::any_of(list.lines.begin(), list.lines.end(), [&](const DrawLine& line) {
    const auto near = [&](const glm::dvec4& end) { return glm::distance(glm::dvec3(end) / end.w, p) < 1e-6; };
    return line.role == Role::caster_body && (near(line.a) || near(line.b));
  });
}

bool has_label(const DrawList& list, const std::string& text) {
  return std::any_of(list.labels.begin(), list.labels.end(), [&](const DrawLabel& label) { return label.text == text; });
}

TEST(WorldBody, MReachesThePointLightAndHDoesNot) {
  // The light is above the scene's bounds.
  const std::vector<std::string> lamp{"light.type=point", "light.position=0,9,-4", "camera.far=20"};
  EXPECT_FALSE(reaches(world(lamp), {0, 9, -4}));
  EXPECT_TRUE(has_label(world(lamp), "H"));
  std::vector<std::string> extended = lamp;
  extended.push_back("view.world_body=M");
  EXPECT_TRUE(reaches(world(extended), {0, 9, -4}));
  EXPECT_TRUE(has_label(world(extended), "M"));
  EXPECT_FALSE(has_label(world(extended), "H"));
}

TEST(WorldBody, MOfADirectionalLightEndsWhereTheViewDoes) {
  for (const char* far : {"20", "inf"}) {
    const DrawList list =
        world({"light.type=directional", "light.to_light=0.3,1,0.2", std::string("camera.far=") + far, "view.world_body=M"});
    EXPECT_TRUE(has_label(list, "M")) << far;
    for (const DrawLine& line : list.lines)
      if (line.role == Role::caster_body) {
        EXPECT_LT(glm::length(glm::dvec3(line.a)), 1e3) << far;
      }
  }
}

}  // namespace
}  // namespace psm
