// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "picture.h"
#include "run_program.h"

namespace psm::testing {
namespace {

using ::testing::ElementsAre;

Image rendered(std::vector<std::string> arguments) {
  const Folder folder;
  arguments.insert(arguments.begin(), "render");
  arguments.insert(arguments.end(), {"--out", folder / "x.png"});
  const Outcome run = run_program(arguments);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(folder.names(), ElementsAre("x.png"));
  const auto image = read_png(folder / "x.png");
  EXPECT_TRUE(image);
  return image.value_or(Image{});
}

TEST(Render, EachViewHasItsSizeAndShowsSomething) {
  for (const char* view : {"world", "cube", "map", "eye"}) {
    const Image image = rendered({"chessboard", "--view", view, "--size", "320x180"});
    ASSERT_EQ(image.width, 320) << view;
    ASSERT_EQ(image.height, 180) << view;
    EXPECT_TRUE(shows_something(image, 0, 0, 320, 180)) << view;
  }
}

TEST(Render, SeveralViewsShareAPicture) {
  RenderRequest request;
  request.views.assign(std::begin(kMainViews), std::end(kMainViews));
  request.size = {640, 480};
  const auto layout = lay_out(request);
  ASSERT_TRUE(layout);
  const Image image = rendered({"ground", "--view", "world,cube,map,eye", "--size", "640x480"});
  ASSERT_EQ(image.width, 640);
  ASSERT_EQ(image.height, 480);
  for (const Rect& place : layout->places)
    EXPECT_TRUE(shows_something(image, place.min.x, place.min.y, place.size().x, place.size().y))
        << place.min.x << " " << place.min.y;
  ASSERT_GT(layout->status_height, 0);
  EXPECT_TRUE(shows_something(image, 0, 480 - layout->status_height, 640, layout->status_height));
}

TEST(Render, TheSizeIsTheExperimentsImageUnlessGiven) {
  const Image image = rendered({"ground", "--view", "eye", "--set", "image.width=200", "--set", "image.height=100"});
  EXPECT_EQ(image.width, 200);
  EXPECT_EQ(image.height, 100);
}

TEST(Render, ASinglePixelIsAPicture) {
  const Image image = rendered({"ground", "--view", "eye", "--size", "1x1"});
  EXPECT_EQ(image.rgba.size(), 4u);
}

TEST(Render, IsTheSameEveryTime) {
  const std::vector<std::string> arguments{"ground", "--view", "world", "--size", "160x120"};
  EXPECT_EQ(rendered(arguments).rgba, rendered(arguments).rgba);
}

TEST(Render, ThemesDiffer) {
  const Image light = rendered({"ground", "--view", "world", "--size", "160x120", "--theme", "light"});
  const Image dark = rendered({"ground", "--view", "world", "--size", "160x120", "--theme", "dark"});
  EXPECT_GT(difference(light, dark, 16).fraction, 0.2);
}

TEST(Render, TheEyesShadowsComeFromTheMap) {
  const std::vector<std::string> base{"chessboard", "--view", "eye", "--size", "320x180"};
  std::vector<std::string> turned = base;
  turned.insert(turned.end(), {"--set", "light.type=directional", "--set", "light.to_light=1,0.4,0"});
  std::vector<std::string> overhead = base;
  overhead.insert(overhead.end(), {"--set", "light.type=directional", "--set", "light.to_light=0,1,0"});
  EXPECT_GT(difference(rendered(turned), rendered(overhead), 16).fraction, 0.02);
}

TEST(Window, WithoutADisplayTheViewsBecomeAPicture) {
  const Folder folder;
  const Outcome run = run_program({"ground"}, folder.path());
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(is_one_line(run.err)) << run.err;
  EXPECT_THAT(run.err, ::testing::HasSubstr("no display"));
  EXPECT_EQ(run.out, std::filesystem::canonical(folder.path()).string() + "/psmlab-views.png\n");
  EXPECT_THAT(folder.names(), ElementsAre("psmlab-views.png"));
  EXPECT_TRUE(read_png(folder / "psmlab-views.png"));
}

TEST(Render, WithoutOpenGLItSaysSoInOneLine) {
  const Folder folder;
  setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1);
  const Outcome run = run_program({"render", "ground", "--view", "eye", "--out", folder / "x.png"});
  unsetenv("__EGL_VENDOR_LIBRARY_DIRS");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(is_one_line(run.err)) << run.err;
  EXPECT_THAT(folder.names(), ::testing::IsEmpty());
}

TEST(Layout, ViewsDoNotOverlapAndStayInside) {
  for (int count = 1; count <= 4; ++count) {
    RenderRequest request;
    request.views.assign(std::begin(kMainViews), std::begin(kMainViews) + count);
    request.size = {333, 257};
    const auto layout = lay_out(request);
    ASSERT_TRUE(layout);
    ASSERT_EQ(int(layout->places.size()), count);
    for (int i = 0; i < count; ++i) {
      const Rect& a = layout->places[i];
      EXPECT_GE(std::min(a.min.x, a.min.y), 0);
      EXPECT_FALSE(a.empty());
      EXPECT_LE(a.max.x, request.size.x);
      EXPECT_LE(a.max.y, request.size.y - layout->status_height);
      for (int j = 0; j < i; ++j) {
        const Rect& b = layout->places[j];
        EXPECT_TRUE(a.min.x >= b.max.x || b.min.x >= a.max.x || a.min.y >= b.max.y || b.min.y >= a.max.y);
      }
    }
  }
}

TEST(Layout, AnOddLastViewTakesTheWholeWidth) {
  RenderRequest request;
  request.views.assign(std::begin(kMainViews), std::begin(kMainViews) + 3);
  request.size = {320, 240};
  const auto layout = lay_out(request);
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->places[2].min.x, 0);
  EXPECT_EQ(layout->places[2].max.x, layout->places[1].max.x);
}

}  // namespace
}  // namespace psm::testing
