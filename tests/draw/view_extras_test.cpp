// SPDX-License-Identifier: GPL-3.0-or-later
// What a view shows besides its experiment: the window's pictures and those of files are put together from the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "draw/probe.h"

namespace psm {
namespace {

constexpr glm::ivec2 kSize(640, 360);

const Scene kRoom = box_scene({-5, 0, -5}, {5, 2, 5});

Analysis analysis_with(EyeOverlay overlay) {
  Experiment e;
  e.camera.position = {0, 3, 9};
  e.view.eye_overlay = overlay;
  return analyze(e, kRoom);
}

ViewPicture world(const Analysis& analysis, const ViewExtras& extras) {
  return describe_view(ViewId::world, analysis, kSize, 1.0, extras);
}

std::size_t lines_of(const ViewPicture& picture, Role role) {
  const auto& lines = picture.list.lines;
  return std::size_t(std::count_if(lines.begin(), lines.end(), [&](const DrawLine& line) { return line.role == role; }));
}

double faintest(const ViewPicture& picture, Role role) {
  double least = 1.0;
  for (const DrawLine& line : picture.list.lines)
    if (line.role == role) least = std::min(least, line.fade_a);
  return least;
}

TEST(ViewExtras, HideRolesInTheProbeToo) {
  const Analysis analysis = analysis_with(EyeOverlay::none);
  const auto probe = make_probe(analysis, {{1, 0, 2}, {0, 1, 0}}, std::nullopt, true);
  ASSERT_TRUE(probe);
  const std::size_t bare = lines_of(world(analysis, {}), Role::light);
  EXPECT_GT(lines_of(world(analysis, {{}, &*probe}), Role::light), bare);
  EXPECT_EQ(lines_of(world(analysis, {{{}, {Role::light}}, &*probe}), Role::light), 0u);
}

TEST(ViewExtras, LeaveTheProbeAsStrongAsItIs) {
  const Analysis analysis = analysis_with(EyeOverlay::none);
  const auto probe = make_probe(analysis, {{1, 0, 2}, {0, 1, 0}}, std::nullopt, true);
  ASSERT_TRUE(probe);
  const Emphasis light{{Role::light}, {}};
  const auto whole = [&](const ViewExtras& extras) {
    const auto picture = world(analysis, extras);
    const auto& lines = picture.list.lines;
    return std::count_if(lines.begin(), lines.end(),
                         [](const DrawLine& line) { return line.role == Role::frustum && line.fade_a == 1.0; });
  };
  EXPECT_LT(faintest(world(analysis, {light}), Role::frustum), 0.5);
  EXPECT_EQ(whole({light}), 0);
  EXPECT_GT(whole({light, &*probe}), 0) << "the ray to the eye";
}

TEST(ViewExtras, SayInTheEyeViewAloneThatRaysAreToCome) {
  const Analysis analysis = analysis_with(EyeOverlay::errors);
  const TracedOverlay traced{{1, 1, {1, 2, 3, 255}}, {"errors", {}, {"12 of 100"}}};
  const auto eye = [&](const ViewExtras& extras) { return describe_view(ViewId::eye, analysis, kSize, 1.0, extras); };
  EXPECT_THAT(eye({}).legend.lines, testing::ElementsAre("traced when nothing moves"));
  EXPECT_FALSE(eye({}).cover);
  EXPECT_TRUE(world(analysis, {}).legend.empty());
  const ViewPicture shown = eye({{}, nullptr, &traced});
  ASSERT_TRUE(shown.cover);
  EXPECT_EQ(shown.cover->rgba, traced.image.rgba);
  EXPECT_EQ(shown.legend.title, "errors");
  EXPECT_FALSE(world(analysis, {{}, nullptr, &traced}).cover);
}

TEST(ViewExtras, LeaveNoNumbersToALineThatWouldDivideThem) {
  const Analysis analysis = analysis_with(EyeOverlay::errors);
  const TracedOverlay traced{{1, 1, {1, 2, 3, 255}}, {"errors", {}, {"12 of 100"}}};
  const ViewPicture shown = describe_view(ViewId::eye, analysis, kSize, 1.0, {{}, nullptr, &traced, {{0.0, 0.5}, {}}});
  EXPECT_TRUE(shown.legend.lines.empty());
  EXPECT_EQ(shown.legend.title, "errors");
}

}  // namespace
}  // namespace psm
