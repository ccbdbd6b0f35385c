// SPDX-License-Identifier: GPL-3.0-or-later
// Any tile shows any view: by the menus on their titles, by files, by keys.
#include "harness.h"

namespace psm::test {
namespace {

using Tiles = std::vector<ViewId>;

TEST(TileMenu, PutsAnotherViewIntoTheTile) {
  Bench bench;
  bench.click(bench.at("tile.map"));
  bench.click(bench.at("tile.map=body"));
  EXPECT_EQ(bench.experiment().view.tiles, (Tiles{ViewId::world, ViewId::cube, ViewId::body, ViewId::eye}));
  EXPECT_FALSE(bench.on_screen("view.map"));
  const Rect body = bench.work_places().at("view.body"), eye = bench.work_places().at("view.eye");
  EXPECT_EQ(body.min.y, eye.min.y);
  bench.key('Z', {true, false, false});
  EXPECT_EQ(bench.experiment().view.tiles, ViewSettings{}.tiles) << "can be undone";
}

TEST(TileMenu, AViewOfAnotherTileChangesPlaces) {
  Bench bench;
  bench.click(bench.at("tile.world"));
  bench.click(bench.at("tile.world=eye"));
  EXPECT_EQ(bench.experiment().view.tiles, (Tiles{ViewId::eye, ViewId::cube, ViewId::map, ViewId::world}));
  EXPECT_EQ(bench.work_places().at("view.eye").min, glm::ivec2(0));
}

TEST(TileMenu, ClosesAndOpensTiles) {
  Bench bench;
  bench.click(bench.at("tile.cube"));
  bench.click(bench.at("tile.cube=close"));
  EXPECT_EQ(bench.experiment().view.tiles, (Tiles{ViewId::world, ViewId::map, ViewId::eye}));
  EXPECT_GT(bench.work_places().at("view.eye").size().x, bench.work_places().at("view.map").size().x) << "over the full width";
  bench.click(bench.at("tile.eye"));
  bench.click(bench.at("tile.eye=more"));
  EXPECT_EQ(bench.experiment().view.tiles.size(), 4u);
}

TEST(TileMenu, OfAViewAloneReplacesIt) {
  Bench bench;
  bench.key('5');
  ASSERT_EQ(bench.experiment().view.maximised, ViewId::body);
  bench.click(bench.at("tile.body"));
  bench.click(bench.at("tile.body=map"));
  EXPECT_EQ(bench.experiment().view.maximised, ViewId::map);
  bench.click(bench.at("tile.map"));
  bench.click(bench.at("tile.map=alone"));
  EXPECT_EQ(bench.experiment().view.maximised, std::nullopt);
  EXPECT_EQ(bench.experiment().view.tiles, ViewSettings{}.tiles);
}

TEST(TileMenu, TheFileSaysWhichViewsShow) {
  Bench bench("ground", {"view.tiles=body,eye"});
  EXPECT_TRUE(bench.on_screen("view.body"));
  EXPECT_FALSE(bench.on_screen("view.world"));
  const OrbitSettings before = bench.experiment().view.body;
  bench.drag(bench.at("view.body"), bench.at("view.body") + glm::dvec2(60, 20));
  EXPECT_NE(bench.experiment().view.body.yaw_deg, before.yaw_deg);
}

TEST(TileMenu, ADrawingNeedsNoShadowMap) {
  Bench bench("ground", {"view.tiles=body"});
  EXPECT_EQ(bench.work().renderer().maps_drawn(), 0);
  bench.key('4');
  EXPECT_EQ(bench.work().renderer().maps_drawn(), 1);
}

}  // namespace
}  // namespace psm::test
