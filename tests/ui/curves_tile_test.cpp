// SPDX-License-Identifier: GPL-3.0-or-later
// The curves and the explorer on the screen: what the mouse does in them.
#include <imgui.h>

#include <cmath>

#include "draw/explorer_map.h"
#include "harness.h"
#include "scene/curve_csv.h"

namespace psm::test {
namespace {

constexpr Modifiers kControl{true, false, false};

/// The pixel of the curves at this angle, half way up.
glm::dvec2 at_theta(Bench& bench, double theta_deg) {
  const Rect place = bench.work_places().at("view.curves");
  const ChartFrame& frame = *bench.work().images().picture(ViewId::curves).chart;
  return glm::dvec2(place.min) + glm::dvec2(frame.x.at(theta_deg), 0.5 * (frame.y.from() + frame.y.to()));
}

double theta_of(Bench& bench) { return curve_setting(bench.analysis()).theta_deg; }

TEST(CurvesTile, DraggingTheCursorTurnsTheLight) {
  for (const char* type : {"light.type=directional", "light.type=point"}) {
    Bench bench("ground", {"view.tiles=curves,eye", type});
    const Experiment before = bench.experiment();
    bench.drag(at_theta(bench, 50.0), at_theta(bench, 71.0));
    EXPECT_NEAR(theta_of(bench), theta_of(bench) > 90.0 ? 109.0 : 71.0, 0.5) << type;
    EXPECT_EQ(bench.experiment().camera, before.camera);
    bench.key('Z', kControl);
    EXPECT_EQ(bench.experiment().light, before.light) << "one step of the history";
  }
}

TEST(CurvesTile, MarkedAnglesAttractTheCursor) {
  Bench bench("ground", {"view.tiles=curves", "view.curve=rho"});
  const CurveSetting setting = curve_setting(bench.analysis());
  const double phi = critical_angles(CurveKind::rho, setting).front().theta_deg;
  bench.click(at_theta(bench, phi) + glm::dvec2(3.0, 0.0));
  const double theta = theta_of(bench);
  EXPECT_NEAR(theta > 90.0 ? 180.0 - theta : theta, phi, 1e-6);
}

TEST(CurvesTile, TheMenuPicksTheQuantity) {
  Bench bench("ground", {"view.tiles=curves"});
  bench.click(bench.at("tile.curve"));
  bench.click(bench.at("tile.curve=" + std::to_string(int(CurveKind::F_max))));
  EXPECT_EQ(bench.experiment().view.curve, CurveKind::F_max);
  bench.click(bench.at("tile.curve_range"));
  bench.click(bench.at("tile.curve_range=1"));
  EXPECT_EQ(bench.experiment().view.curve_range, CurveFrustum::papers);
}

TEST(CurvesTile, CopiesWhatItShowsAsCsv) {
  Bench bench("ground", {"view.tiles=curves", "view.curve=E_max", "view.curve_range=papers"});
  bench.click(bench.at("tile.curve_csv"));
  EXPECT_EQ(std::string(ImGui::GetClipboardText()), curve_csv(CurveKind::E_max, curve_setting(bench.analysis())));
}

TEST(CurvesTile, HoveringIsNoEditAndDrawsNoViewAgain) {
  Bench bench("ground", {"view.tiles=curves"});
  const Image before = bench.screen();
  const auto drawn = bench.work().views_drawn();
  bench.move(at_theta(bench, 40.0));
  EXPECT_GT(differing_pixels(before, bench.screen()), 500u);
  EXPECT_EQ(bench.work().views_drawn(), drawn);
  EXPECT_EQ(bench.work().model().history().undo_count(), 0u);
}

glm::dvec2 explorer_pixel(Bench& bench, glm::dvec2 page) {
  return glm::dvec2(bench.work_places().at("view.explorer").min) + page;
}

ExplorerMap map_in(Bench& bench) {
  return explorer_map(bench.analysis(), glm::dvec2(bench.work_places().at("view.explorer").size()));
}

TEST(ExplorerTile, ItsHandleSetsTheLight) {
  for (const char* type : {"light.type=directional", "light.type=point"}) {
    Bench bench("ground", {"view.tiles=explorer", type});
    const Experiment before = bench.experiment();
    const ExplorerMap map = map_in(bench);
    const glm::dvec2 behind = map.directions ? map.page_of(2.4, 1.0) : map.middle - glm::dvec2(40.0, 30.0);
    bench.drag(explorer_pixel(bench, map.page_of(bench.analysis())), explorer_pixel(bench, behind));
    EXPECT_EQ(bench.analysis().light_case.post, PostLight::inverted_point) << type;
    bench.key('Z', kControl);
    EXPECT_EQ(bench.experiment().light, before.light);
    const glm::dvec2 boundary = map.directions ? map.page_of(std::acos(0.0), 1.0) : map.middle - glm::dvec2(0.0, 60.0);
    bench.click(explorer_pixel(bench, boundary) + glm::dvec2(3.0, 0.0));
    EXPECT_EQ(bench.analysis().light_case.post, PostLight::directional) << type << ": w = 0 attracts it";
  }
}

TEST(Quiz, AsksAnswersAndShows) {
  Bench bench("ground");
  bench.key('Q');
  ASSERT_TRUE(bench.work().quiz());
  EXPECT_EQ(bench.experiment().view.maximised, ViewId::explorer);
  const LightSettings before = bench.experiment().light;
  const int right = bench.work().quiz()->question().right;
  EXPECT_FALSE(bench.on_screen("quiz.next")) << "predict first";
  bench.click(bench.at("quiz.answer=" + std::to_string(right)));
  EXPECT_EQ(bench.work().quiz()->score().right, 1);
  EXPECT_EQ(bench.experiment().light, before);
  bench.click(bench.at("quiz.show"));
  EXPECT_EQ(bench.experiment().light, bench.work().quiz()->light());
  bench.click(bench.at("quiz.next"));
  EXPECT_EQ(bench.work().quiz()->number(), 2);
  EXPECT_FALSE(bench.work().quiz()->answered());
  bench.click(bench.at("quiz.close"));
  EXPECT_FALSE(bench.work().quiz());
}

TEST(Quiz, TheScoreOutlivesThePanelAndTheProgram) {
  Bench bench("ground");
  bench.key('Q');
  bench.click(bench.at("quiz.answer=" + std::to_string(bench.work().quiz()->question().right)));
  bench.key('Q');
  bench.key('Q');
  EXPECT_EQ(bench.work().quiz()->score(), (QuizScore{1, 1}));
  EXPECT_EQ(read_settings(bench.folder() / "config" / "settings.txt").quiz, (QuizScore{1, 1}));
  bench.click(bench.at("quiz.reset"));
  EXPECT_EQ(bench.work().quiz()->score(), QuizScore{});
  EXPECT_EQ(read_settings(bench.folder() / "config" / "settings.txt").quiz, QuizScore{});
}

TEST(Quiz, IsPlayedByKeys) {
  Bench bench("ground");
  bench.key('Q');
  bench.key(key::down);
  bench.key(' ');
  EXPECT_EQ(bench.work().quiz()->chosen(), 1) << "the first answer has the keys at first";
  bench.key(' ');
  EXPECT_EQ(bench.work().quiz()->number(), 2) << "then Next has them";
}

}  // namespace
}  // namespace psm::test
