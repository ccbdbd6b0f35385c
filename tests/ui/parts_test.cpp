// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that need no window: history, settings, layout, sliders, validity, the light's angles.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <set>

#include "harness.h"
#include "scene/light_angles.h"
#include "ui/keys.h"
#include "ui/navigation.h"
#include "ui/slider.h"
#include "ui/tile_menu.h"

namespace psm::test {
namespace {

TEST(History, AGestureIsOneEntryAndTheListIsBounded) {
  History history(3);
  Experiment e;
  for (int i = 0; i < 5; ++i) {
    const Experiment before = e;
    e.camera.near = 1.0 + i;
    history.record(before, "", 0.0);
    history.record(e, "", 0.0);
    history.end_gesture(e);
  }
  EXPECT_EQ(history.undo_count(), 3u);
  Experiment back = e;
  while (auto step = history.undo(back)) back = *step;
  EXPECT_EQ(back.camera.near, 2.0);
  while (auto step = history.redo(back)) back = *step;
  EXPECT_EQ(back, e);
}

TEST(History, AGestureThatComesBackIsNoEntry) {
  History history;
  const Experiment e;
  history.record(e, "", 0.0);
  history.end_gesture(e);
  EXPECT_EQ(history.undo_count(), 0u);
}

TEST(Settings, SurviveAFileAndBadFiles) {
  const ScratchFolder folder;
  const auto file = folder.path() / "deep" / "settings.txt";
  EXPECT_EQ(read_settings(file), Settings{});
  Settings settings;
  settings.scale_percent = 150, settings.theme = Theme::dark, settings.layout.pane = 0.3125;
  ASSERT_TRUE(write_settings(settings, file));
  EXPECT_EQ(read_settings(file), settings);
  std::ofstream(file) << "scale_percent 1e99\nfont_px nan\ntheme purple\npane x\ncolumn -inf\nrow\n\xff\xfe\n";
  const Settings read = read_settings(file);
  EXPECT_EQ(read, clamped(read));
  EXPECT_EQ(read.font_px, Settings{}.font_px);
  EXPECT_EQ(read.layout.column, Settings{}.layout.column);
}

ViewSettings with_tiles(std::vector<ViewId> tiles) {
  ViewSettings view;
  view.tiles = std::move(tiles);
  return view;
}

TEST(Layout, TilesFillTheWindowWithoutOverlap) {
  const std::vector<ViewId> all(kAllViews.begin(), kAllViews.end());
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(320, 200), glm::ivec2(1024, 768), glm::ivec2(3840, 2160)})
    for (std::size_t count = 1; count <= kMostTiles; ++count) {
      const std::vector<ViewId> tiles(all.end() - std::ptrdiff_t(count), all.end());
      const Layout l = lay_out(size, LayoutSettings{}, with_tiles(tiles), 31, 6);
      std::int64_t area = 0;
      for (const ViewId id : kAllViews) {
        const bool is_tile = std::find(tiles.begin(), tiles.end(), id) != tiles.end();
        const Rect& a = l.view(id);
        if (!is_tile || a.empty()) {
          EXPECT_FALSE(l.visible(id));
          continue;
        }
        area += std::int64_t(a.size().x) * a.size().y;
        EXPECT_LE(a.max.x, size.x);
        for (const ViewId other : kAllViews) {
          const Rect& b = l.view(other);
          if (other == id || b.empty()) continue;
          EXPECT_TRUE(a.max.x <= b.min.x || b.max.x <= a.min.x || a.max.y <= b.min.y || b.max.y <= a.min.y);
        }
      }
      if (size.x < 320) continue;
      const glm::ivec2 whole(l.pane_splitter.min.x, l.badges.min.y);
      EXPECT_GT(area, std::int64_t(whole.x) * whole.y - 6 * (whole.x + whole.y) - 1) << count << " tiles leave holes";
    }
}

TEST(Layout, TwoTilesStandAsMakesThemLarger) {
  const ViewSettings two = with_tiles({ViewId::world, ViewId::eye});
  const Layout wide = lay_out({1920, 700}, LayoutSettings{}, two, 31, 6),
               square = lay_out({1024, 800}, LayoutSettings{}, two, 31, 6);
  EXPECT_EQ(wide.view(ViewId::world).min.y, wide.view(ViewId::eye).min.y);
  EXPECT_TRUE(wide.row_splitter.empty());
  EXPECT_EQ(square.view(ViewId::world).min.x, square.view(ViewId::eye).min.x);
  EXPECT_TRUE(square.column_splitter.empty());
}

TEST(Layout, AMaximisedViewHasThePlaceOfAllTiles) {
  ViewSettings view = with_tiles({ViewId::world, ViewId::eye});
  view.maximised = ViewId::body;
  const Layout alone = lay_out({1024, 768}, LayoutSettings{}, view, 31, 6);
  EXPECT_FALSE(alone.visible(ViewId::eye));
  EXPECT_EQ(alone.view(ViewId::body).min, glm::ivec2(0));
  EXPECT_TRUE(alone.column_splitter.empty());
}

TEST(Tiles, AViewThatIsElsewhereChangesPlaces) {
  std::vector<ViewId> tiles{ViewId::world, ViewId::cube, ViewId::map};
  put_in_tile(tiles, 0, ViewId::map);
  EXPECT_EQ(tiles, (std::vector<ViewId>{ViewId::map, ViewId::cube, ViewId::world}));
  put_in_tile(tiles, 1, ViewId::body);
  EXPECT_EQ(tiles, (std::vector<ViewId>{ViewId::map, ViewId::body, ViewId::world}));
  put_in_tile(tiles, 3, ViewId::eye);
  EXPECT_EQ(tiles.size(), 4u);
  put_in_tile(tiles, 3, std::nullopt);
  put_in_tile(tiles, 0, std::nullopt);
  EXPECT_EQ(tiles, (std::vector<ViewId>{ViewId::body, ViewId::world}));
  put_in_tile(tiles, 0, std::nullopt);
  put_in_tile(tiles, 0, std::nullopt);
  EXPECT_EQ(tiles, std::vector<ViewId>{ViewId::world}) << "the last tile stays";
}

TEST(Slider, PlaceAndValueAreInverse) {
  for (const SliderRange& range : {SliderRange{-5, 12}, SliderRange{1e-3, 1e4, true}}) {
    for (double place = 0.0; place <= 1.0; place += 0.125)
      EXPECT_NEAR(slider_place(range, slider_value(range, place)), place, 1e-12);
    EXPECT_EQ(slider_value(range, 0.0), range.min);
    EXPECT_EQ(slider_value(range, 1.0), range.max);
    EXPECT_EQ(slider_place(range, 1e300), 1.0);
  }
}

TEST(Slider, SnapsOnlyWithinReach) {
  const std::vector<Tick> ticks = {{90.0, "", Role::infinity}};
  const SliderRange range{0, 180};
  EXPECT_EQ(snapped(range, 91.0, ticks, 0.01), 90.0);
  EXPECT_EQ(snapped(range, 93.0, ticks, 0.01), 93.0);
}

TEST(Keys, NoTwoActionsShareAKey) {
  std::set<std::string> names;
  for (const KeyBinding& binding : key_bindings()) {
    EXPECT_TRUE(names.insert(binding.name).second) << binding.name;
    EXPECT_EQ(action_of({binding.key, binding.modifiers}), binding.action) << binding.name;
  }
}

TEST(Validity, AnyEditLeadsToAValidExperiment) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> wild(-320.0, 300.0);
  const auto number = [&] { return (random() & 1 ? 1.0 : -1.0) * std::pow(10.0, wild(random)); };
  const Experiment before;
  for (int i = 0; i < 2000; ++i) {
    Experiment e = before;
    e.light.type = LightType(random() % 3);
    e.camera.near = number(), e.camera.far = random() % 4 == 0 ? HUGE_VAL : number();
    e.camera.vertical_fov_deg = number();
    e.light.to_light = {number(), 0.0, number()};
    if (random() % 4 == 0) e.camera.target = e.camera.position;
    if (random() % 4 == 0) e.camera.up = e.camera.target - e.camera.position;
    if (random() % 4 == 0) e.light.target = e.light.position;
    if (random() % 4 == 0) e.light.to_light = glm::dvec3(NAN);
    const auto error = check_experiment(made_valid(before, e));
    ASSERT_FALSE(error) << error->text;
  }
}

TEST(LightAngles, ThetaAndDepthAreSetExactly) {
  Experiment e;
  e.camera.position = {0.3, 1.7, 6.1}, e.camera.target = {0.1, 0.9, -0.2};
  const glm::dvec3 side = theta_side(e), v = view_forward(e.camera);
  for (double degrees : {0.0, 20.0, 90.0, 137.0, 180.0}) {
    Experiment turned = e;
    turned.light.to_light = to_light_at(e, degrees == 90.0 ? std::acos(-1.0) / 2 : glm::radians(degrees), side);
    EXPECT_NEAR(glm::degrees(light_theta(turned)), degrees, 1e-12);
    EXPECT_NEAR(glm::length(turned.light.to_light), glm::length(e.light.to_light), 1e-14);
    if (degrees == 90.0) {
      EXPECT_LE(std::abs(glm::dot(v, turned.light.to_light)), 4e-16 * glm::length(turned.light.to_light));
    }
  }
  for (double depth : {-3.0, 0.0, 5.0}) {
    Experiment moved = e;
    moved.light.position = position_at_depth(e, depth);
    EXPECT_NEAR(light_depth(moved), depth, 1e-14);
  }
}

TEST(LightAngles, BearingAndDirectionAreInverse) {
  const glm::dvec3 d = glm::normalize(glm::dvec3(0.3, -0.6, 0.2));
  EXPECT_NEAR(glm::length(direction_of(bearing_of(d)) - d), 0.0, 1e-15);
}

TEST(Navigation, TurningTheCameraKeepsItsDistanceAndStaysOffThePole) {
  CameraSettings camera;
  const double distance = glm::length(camera.position - camera.target);
  for (int i = 0; i < 50; ++i) turn(camera, {0.07, -0.11});
  EXPECT_NEAR(glm::length(camera.position - camera.target), distance, 1e-12 * 50);
  Experiment e;
  e.camera = camera;
  EXPECT_FALSE(check_experiment(e));
}

}  // namespace
}  // namespace psm::test
