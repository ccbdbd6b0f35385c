// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "draw/explorer_map.h"
#include "draw/view.h"
#include "math/projective.h"
#include "scene/experiment_file.h"
#include "text_boxes.h"

namespace psm {
namespace {

constexpr glm::dvec2 kPage(900, 600);

struct Case {
  LoadedExperiment loaded;
  Analysis analysis;
};
Case with(const std::vector<std::string>& overrides) {
  LoadedExperiment loaded = *load_experiment("ground", overrides);
  Analysis analysis = analyze(loaded.experiment, loaded.scene);
  return {std::move(loaded), std::move(analysis)};
}

bool says(const DrawList& list, const std::string& text) {
  return std::any_of(list.texts.begin(), list.texts.end(),
                     [&](const DrawText& t) { return t.text.find(text) != std::string::npos; });
}

std::vector<glm::dvec2> random_pages(const ExplorerMap& map, unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(map.min.x, map.max.x), y(map.min.y, map.max.y);
  std::vector<glm::dvec2> pages;
  for (int i = 0; i < count; ++i) pages.push_back(map.clamped({x(random), y(random)}));
  return pages;
}

TEST(ExplorerMap, ALightIsWhereItWasPut) {
  for (const char* type : {"light.type=directional", "light.type=point"}) {
    const Case c = with({type});
    const ExplorerMap map = explorer_map(c.analysis, kPage);
    for (const glm::dvec2& page : random_pages(map, 5, 200)) {
      const Experiment moved = map.with_light_at(c.loaded.experiment, page, 0.0);
      const glm::dvec2 back =
          map.directions ? map.page_of_direction(moved.light.to_light) : map.page_of_position(moved.light.position);
      EXPECT_LT(glm::length(back - page), 1e-6) << type;
    }
  }
}

TEST(ExplorerMap, TheDiscPreservesAreas) {
  const Case c = with({});
  const ExplorerMap map = explorer_map(c.analysis, kPage);
  // Equal steps of cos(theta) are equal areas on the sphere, and of the squared radius.
  double last = 0.0;
  for (int i = 1; i <= 8; ++i) {
    const double radius = glm::length(map.page_of(std::acos(1.0 - 0.25 * i), 0.3) - map.middle);
    EXPECT_NEAR(radius * radius - last, map.scale * map.scale / 8.0, 1e-9 * map.scale * map.scale);
    last = radius * radius;
  }
}

TEST(ExplorerMap, NearItsBoundaryALightIsExactlyOnIt) {
  for (const char* type : {"light.type=directional", "light.type=point"}) {
    const Case c = with({type});
    const ExplorerMap map = explorer_map(c.analysis, kPage);
    for (int i = 0; i < 12; ++i) {
      const glm::dvec2 boundary = map.directions ? map.page_of(0.5 * std::numbers::pi, 0.5 * i)
                                                 : glm::dvec2(map.middle.x, map.min.y + (map.max.y - map.min.y) * i / 12.0);
      const Experiment moved = map.with_light_at(c.loaded.experiment, boundary + glm::dvec2(2.0, 1.0), 4.0);
      EXPECT_EQ(analyze(moved, c.loaded.scene).light_case.post, PostLight::directional) << type << " " << i;
    }
  }
}

TEST(ExplorerMap, RegionsAreTheAnalysissCases) {
  for (const char* type : {"light.type=directional", "light.type=point"}) {
    const Case c = with({type});
    const ExplorerMap map = explorer_map(c.analysis, kPage);
    for (const glm::dvec2& page : random_pages(map, 9, 60)) {
      const double inside = map.directions ? std::sqrt(0.5) * map.scale - glm::length(page - map.middle) : page.x - map.middle.x;
      if (std::abs(inside) < 1e-3) continue;
      const Experiment moved = map.with_light_at(c.loaded.experiment, page, 0.0);
      EXPECT_EQ(analyze(moved, c.loaded.scene).light_case.post, inside > 0 ? PostLight::point : PostLight::inverted_point);
    }
  }
}

TEST(ExplorerView, HasTheLightAsItsHandle) {
  for (const char* type : {"light.type=directional", "light.type=point", "light.type=spot"}) {
    const Case c = with({type});
    const ViewPicture picture = describe_view(ViewId::explorer, c.analysis, glm::ivec2(kPage));
    const ExplorerMap map = explorer_map(c.analysis, kPage);
    const glm::dvec2 at = map.clamped(map.page_of(c.analysis));
    EXPECT_TRUE(std::any_of(picture.list.points.begin(), picture.list.points.end(), [&](const DrawPoint& p) {
      return p.role == Role::light && glm::length(glm::dvec2(p.position) - at) < 1e-9;
    })) << type;
    EXPECT_TRUE(says(picture.list, "w = 0")) << type;
    EXPECT_TRUE(says(picture.list, "naive order")) << type;
    EXPECT_TRUE(says(picture.list, "reversed")) << "the region is named";
  }
}

TEST(ExplorerView, NoTextOfASliceIsCutOrStandsOverAnother) {
  for (const char* slice : {"view.explorer_slice=side", "view.explorer_slice=above"})
    for (const glm::ivec2 size : {glm::ivec2(320, 240), glm::ivec2(300, 500), glm::ivec2(480, 270), glm::ivec2(900, 260)}) {
      const Case c = with({"light.type=point", slice});
      const ViewPicture picture = describe_view(ViewId::explorer, c.analysis, size);
      const auto texts = testing::texts_on(picture, size);
      testing::expect_readable(texts, size, slice);
      EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [](const TextBox& t) { return t.text.starts_with("R: "); }));
    }
}

TEST(ExplorerView, IsFiniteWhateverTheExperiment) {
  for (const char* other : {"camera.far=inf", "camera.target=0,1000,0.01", "shadow.technique=psm", "shadow.technique=glpr",
                            "light.to_light=0,0,1", "camera.up=1,0,0", "view.explorer_slice=above"})
    for (const char* type : {"light.type=directional", "light.type=point"}) {
      const Case c = with(
          {type, std::string(type) == "light.type=point" && std::string(other).starts_with("light.") ? "view.curve=rho" : other});
      for (const glm::ivec2 size : {glm::ivec2(900, 600), glm::ivec2(320, 200), glm::ivec2(8, 8)}) {
        const ViewPicture picture = describe_view(ViewId::explorer, c.analysis, size);
        for (const DrawLine& line : picture.list.lines)
          for (const glm::dvec4& p : {line.a, line.b}) ASSERT_TRUE(std::isfinite(p.x + p.y)) << other;
        for (const DrawText& text : picture.list.texts) ASSERT_TRUE(std::isfinite(text.position.x + text.position.y)) << other;
      }
    }
}

}  // namespace
}  // namespace psm
