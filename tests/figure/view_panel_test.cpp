// SPDX-License-Identifier: GPL-3.0-or-later
// A view as a panel: what the scene hides, and everything as what it is.
#include "figure/view_panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace psm {
namespace {

constexpr int kSide = 100;
const PictureFrame kFrame{{kSide, kSide}, 1.0, Theme::light};

/// A wall at depth 0.5 over the picture's right half; nothing over the left one.
ViewRaster wall() {
  ViewRaster raster;
  raster.image = {kSide, kSide, std::vector<std::uint8_t>(kSide * kSide * 4, 255)};
  for (int i = 0; i < kSide * kSide; ++i) raster.depth.push_back(i % kSide < kSide / 2 ? 1.0f : 0.5f);
  return raster;
}

/// From the left border to the right one, at this depth in normalised device coordinates.
DrawLine across(double depth, double y = 0.0) { return {{-1.0, y, depth, 1.0}, {1.0, y, depth, 1.0}}; }

DrawFill square(double depth, double left, double right) {
  return {{{left, -0.5, depth, 1}, {right, -0.5, depth, 1}, {right, 0.5, depth, 1}, {left, 0.5, depth, 1}}};
}

const FontFace& font() {
  static const auto loaded = FontFace::load("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf");
  EXPECT_TRUE(loaded);
  return *loaded;
}

template <class Item>
std::vector<Item> items_of(const PagePanel& panel) {
  std::vector<Item> items;
  for (const PageItem& item : panel.items)
    if (const Item* found = std::get_if<Item>(&item)) items.push_back(*found);
  return items;
}

PagePanel panel_of(const DrawList& list, glm::dvec2 top_left = {0.0, 0.0}) {
  ViewPicture picture;
  picture.list = list;
  return view_panel(picture, kFrame, wall(), top_left, font());
}

TEST(ViewPanel, SplitsALineWhereTheSceneHidesIt) {
  const auto lines = items_of<PageLine>(panel_of({.lines = {across(0.5)}}));
  ASSERT_EQ(lines.size(), 2u);
  const PageLine &hidden = lines[0], &seen = lines[1];
  EXPECT_EQ(seen.dash_on, 0.0);
  EXPECT_NEAR(seen.b.x, 50.0, 1.0);
  EXPECT_GT(hidden.dash_on, 0.0);
  EXPECT_NEAR(hidden.a.x, 50.0, 1.0);
  EXPECT_LT(hidden.width, seen.width);
  EXPECT_LT(hidden.opacity_a, seen.opacity_a);
}

TEST(ViewPanel, LeavesWhatIsBeforeTheSceneWhole) {
  for (const double depth : {-0.5, 0.0}) {  // the wall's own depth counts as before it
    const auto lines = items_of<PageLine>(panel_of({.lines = {across(depth)}}));
    ASSERT_EQ(lines.size(), 1u) << depth;
    EXPECT_EQ(lines[0].dash_on, 0.0);
  }
}

TEST(ViewPanel, FadesALineThroughItsPieces) {
  DrawLine line = across(0.5);
  line.fade_b = 0.0;
  const auto lines = items_of<PageLine>(panel_of({.lines = {line}}));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].opacity_a, 1.0);
  EXPECT_NEAR(lines[1].opacity_b, 0.5, 0.02);
  EXPECT_NEAR(lines[0].opacity_a, 0.6 * 0.5, 0.02);
}

TEST(ViewPanel, EndsAnArrowAtItsHead) {
  DrawLine line{{-0.5, 0.0, 0.0, 1.0}, {-0.1, 0.0, 0.0, 1.0}};
  line.arrow = true;
  const PagePanel panel = panel_of({.lines = {line}});
  const auto lines = items_of<PageLine>(panel);
  const auto heads = items_of<PagePolygon>(panel);
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(heads.size(), 1u);
  EXPECT_NEAR(heads[0].corners[0].x, 45.0, 1e-9);
  EXPECT_LT(lines[0].b.x, 36.0);
}

TEST(ViewPanel, FillsThatTheSceneHidesGoIntoThePixels) {
  ViewPicture picture;
  picture.list.fills = {square(0.5, -0.9, -0.1), square(0.5, -0.5, 0.5), square(-0.5, 0.1, 0.9)};
  const auto hidden = hidden_fills(picture, kFrame, wall());
  ASSERT_EQ(hidden.size(), 1u);
  EXPECT_EQ(hidden[0].corners[1].x, 0.5);
  EXPECT_EQ(items_of<PagePolygon>(view_panel(picture, kFrame, wall(), {0, 0}, font())).size(), 2u);
}

TEST(ViewPanel, DrawsFarFillsFirst) {
  const auto fills = items_of<PagePolygon>(panel_of({.fills = {square(-0.8, -0.9, -0.5), square(0.8, -0.8, -0.4)}}));
  ASSERT_EQ(fills.size(), 2u);
  EXPECT_NEAR(fills[0].corners[0].x, 10.0, 1e-9);
}

TEST(ViewPanel, EveryLabelIsText) {
  DrawList list;
  list.labels = {{{0, 0, 0, 1}, "H"}, {{-0.5, 0.5, 0, 1}, "light"}};
  const auto texts = items_of<PageText>(panel_of(list));
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_EQ(items_of<PageBox>(panel_of(list)).size(), 2u) << "a plate each";
  EXPECT_EQ(texts[0].size.y, kTextHeight);
}

TEST(ViewPanel, ADrawingHasNoPixels) {
  ViewPicture picture;
  picture.list.lines = {across(0.5)};
  picture.list.fills = {square(0.5, -0.5, 0.5)};
  const PagePanel panel = view_panel(picture, kFrame, {}, {0, 0}, font());
  EXPECT_TRUE(items_of<PageImage>(panel).empty());
  EXPECT_EQ(items_of<PageLine>(panel).size(), 1u);
  EXPECT_EQ(items_of<PagePolygon>(panel).size(), 1u);
}

TEST(ViewPanel, StandsWhereItIsPut) {
  const auto lines = items_of<PageLine>(panel_of({.lines = {across(0.0)}}, {300.0, 40.0}));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].a.y, 40.0 + 0.5 * kSide, 1e-9);
  EXPECT_NEAR(lines[0].a.x, 300.0, 1e-9);
}

}  // namespace
}  // namespace psm
