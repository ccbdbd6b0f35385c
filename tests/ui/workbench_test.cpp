// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>

#include <fstream>

#include "harness.h"
#include "measure/texel_analysis.h"

namespace psm::test {
namespace {

constexpr Modifiers kControl{true, false, false}, kControlShift{true, true, false};

TEST(Workbench, UndoGivesBackTheExactExperimentAndPixels) {
  Bench bench;
  bench.move({1.0, 1.0});
  const Experiment before = bench.experiment();
  const Image eye = bench.view(ViewId::eye), world = bench.view(ViewId::world);
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.7));
  bench.drag(bench.at("view.world"), bench.at("view.world", 0.7));
  const Experiment after = bench.experiment();
  EXPECT_NE(after.light, before.light);
  EXPECT_NE(after.view, before.view);
  EXPECT_GT(differing_pixels(eye, bench.view(ViewId::eye)), 0u);
  bench.key('Z', kControl);
  bench.key('Z', kControl);
  EXPECT_EQ(bench.experiment(), before);
  EXPECT_EQ(differing_pixels(eye, bench.view(ViewId::eye)), 0u);
  EXPECT_EQ(differing_pixels(world, bench.view(ViewId::world)), 0u);
  bench.key('Y', kControl);
  bench.key('Z', kControlShift);
  EXPECT_EQ(bench.experiment(), after);
}

TEST(Workbench, WheelStepsOfOneGoAreOneEntry) {
  Bench bench;
  for (int i = 0; i < 4; ++i) bench.wheel(bench.at("view.world"), 1.0);
  EXPECT_EQ(bench.work().model().history().undo_count(), 1u);
  bench.pass_time(5.0);
  bench.wheel(bench.at("view.world"), 1.0);
  EXPECT_EQ(bench.work().model().history().undo_count(), 2u);
}

TEST(Workbench, DoubleClickMaximisesAndBack) {
  Bench bench;
  const Rect four = bench.work_places().at("view.cube");
  bench.double_click(bench.at("view.cube"));
  EXPECT_EQ(bench.experiment().view.maximised, ViewId::cube);
  EXPECT_GT(bench.work_places().at("view.cube").size().x, four.size().x * 3 / 2);
  EXPECT_FALSE(bench.on_screen("view.world"));
  bench.double_click(bench.at("view.cube"));
  EXPECT_EQ(bench.experiment().view.maximised, std::nullopt);
  bench.key('4');
  EXPECT_EQ(bench.experiment().view.maximised, ViewId::eye);
  bench.key(key::escape);
  EXPECT_EQ(bench.experiment().view.maximised, std::nullopt);
}

TEST(Workbench, IdleDrawsNothing) {
  Bench bench;
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.5));
  EXPECT_FALSE(bench.work().needs_redraw());
  const auto frames = bench.work().frames(), views = bench.work().views_drawn(),
             analyses = bench.work().model().analysis_revision();
  bench.settle();
  EXPECT_EQ(bench.work().frames(), frames);
  // A mouse that only moves draws frames, but no view again.
  bench.move(bench.at("view.eye"));
  bench.move(bench.at("view.eye", 0.6));
  EXPECT_GT(bench.work().frames(), frames);
  EXPECT_EQ(bench.work().views_drawn(), views);
  EXPECT_EQ(bench.work().model().analysis_revision(), analyses);
}

TEST(Workbench, AtRestTheTexelsOfAllPixelsAreCounted) {
  Bench bench("ground", {"view.eye_overlay=texel_size"});
  bench.settle();
  const Model& model = bench.work().model();
  ASSERT_TRUE(model.texels_counted());
  const Analysis whole = analyze_with_texels(model.experiment(), model.scene());
  EXPECT_EQ(model.analysis().texels, whole.texels);
  const auto& legend = bench.work().images().analysis().texels;
  EXPECT_EQ(legend, whole.texels) << "the legend shows what the numbers show";
}

TEST(Workbench, OnlyTheViewThatTurnsIsDrawnAgain) {
  Bench bench;
  const auto views = bench.work().views_drawn(), analyses = bench.work().model().analysis_revision();
  bench.drag(bench.at("view.cube"), bench.at("view.cube", 0.7), 0, 1);
  EXPECT_EQ(bench.work().views_drawn(), views + 1);
  EXPECT_EQ(bench.work().model().analysis_revision(), analyses);
  bench.key('4');
  const auto alone = bench.work().views_drawn();
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.6), 0, 1);
  const auto analysed = bench.work().model().analysis_revision() - analyses;
  EXPECT_GT(analysed, 0u);
  EXPECT_EQ(bench.work().views_drawn(), alone + analysed) << "hidden views cost nothing";
}

TEST(Workbench, TheWorldViewStaysWhileTheExperimentChanges) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8"});
  const glm::dmat4 before = bench.work().images().picture(ViewId::world).clip_from_list;
  bench.drag(bench.at("depth", 0.7), bench.at("depth", 1.0));
  EXPECT_EQ(bench.work().images().picture(ViewId::world).clip_from_list, before);
}

TEST(Workbench, SavesAndOpensTheState) {
  Bench bench;
  const std::string file = (bench.folder() / "state.psm.json").string();
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.62));
  const Experiment saved = bench.experiment();
  bench.key('S', kControl);
  ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::save);
  bench.type(file);
  bench.key(key::enter);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
  ASSERT_TRUE(std::filesystem::exists(file));
  bench.key('R');
  EXPECT_NE(bench.experiment(), saved);
  bench.key('O', kControl);
  ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::open);
  bench.type(file);
  bench.click(bench.at("dialog.confirm"));
  EXPECT_EQ(bench.experiment(), saved);
  bench.key('Z', kControl);
  EXPECT_NE(bench.experiment(), saved) << "opening can be undone";
}

TEST(Workbench, ABadFileLeavesTheExperiment) {
  Bench bench;
  const Experiment before = bench.experiment();
  const std::filesystem::path bad = bench.folder() / "bad.psm.json";
  std::ofstream(bad) << "{\"camera\": {\"near\": -1}}";
  bench.work().open(bad.string());
  bench.settle();
  EXPECT_EQ(bench.experiment(), before);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::error);
  bench.key(key::escape);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
  bench.work().open((bench.folder() / "absent.glb").string());
  bench.settle();
  EXPECT_EQ(bench.experiment(), before);
  bench.click(bench.at("dialog.confirm"));
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.6));
  EXPECT_NE(bench.experiment(), before) << "the window is usable again";
}

TEST(Workbench, ChoosesScenesAndUndoesAcrossThem) {
  Bench bench("ground");
  bench.click(bench.at("scene.source"));
  bench.click(bench.at("scene.source=chessboard"));
  EXPECT_EQ(bench.experiment().scene.source, "chessboard");
  EXPECT_EQ(bench.work().model().scene().id, "chessboard");
  bench.key('Z', kControl);
  EXPECT_EQ(bench.experiment().scene.source, "ground");
  EXPECT_EQ(bench.work().model().scene().id, "ground");
}

TEST(Workbench, AnyWindowSizeIsDrawn) {
  Bench bench;
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(320, 200), glm::ivec2(3840, 2160), glm::ivec2(1024, 768)}) {
    bench.resize(size);
    const Image screen = bench.screen();
    EXPECT_EQ(glm::ivec2(screen.width, screen.height), size);
  }
}

TEST(Workbench, NoPaneTextIsCutAt1024) {
  for (const char* source : {"ground", "chessboard"}) {
    Bench bench(source);
    const Rect pane = bench.work_places().at("pane.fields");
    for (const auto& [name, rect] : bench.work_places()) {
      if (rect.min.x < pane.min.x || rect.min.y < 0 || rect.max.y > pane.max.y) continue;
      EXPECT_LE(rect.max.x, pane.max.x) << name;
      EXPECT_LT(rect.min.x, rect.max.x) << name;
    }
  }
}

TEST(Workbench, SplittersMoveAndAreRemembered) {
  Bench bench;
  const Rect before = bench.work_places().at("view.world");
  const glm::dvec2 divider = bench.at("splitter.column");
  bench.drag(divider + glm::dvec2(0, 40), divider + glm::dvec2(-80, 40));
  EXPECT_NEAR(bench.work_places().at("view.world").size().x, before.size().x - 80, 4);
  EXPECT_EQ(read_settings(bench.folder() / "config" / "settings.txt"), bench.work().settings());
  bench.double_click(bench.at("splitter.column") + glm::dvec2(0, 40));
  EXPECT_EQ(bench.work_places().at("view.world").size(), before.size());
}

TEST(Workbench, ScaleAndThemeTakeEffectAndReturn) {
  Bench bench;
  bench.move({1.0, 1.0});
  const Image before = bench.screen();
  for (int i = 0; i < 8; ++i) bench.key('=', kControl);
  EXPECT_EQ(bench.work().settings().scale_percent, 300);
  for (int i = 0; i < 8; ++i) bench.key('-', kControl);
  bench.key('-', kControl);
  EXPECT_EQ(bench.work().settings().scale_percent, 75);
  bench.key('=', kControl);
  bench.key('D');
  EXPECT_GT(differing_pixels(before, bench.screen()), 100000u);
  bench.key('D');
  bench.key('H');
  EXPECT_FALSE(bench.on_screen("theta"));
  bench.key('H');
  EXPECT_TRUE(bench.on_screen("theta"));
}

TEST(Workbench, HelpOpensAndEscapeClosesIt) {
  Bench bench;
  bench.key(key::f1);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::help);
  bench.key('R');
  bench.key(key::escape);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
}

TEST(Workbench, TheNotesBadgeShowsTheNotes) {
  Bench bench("chessboard");
  ASSERT_FALSE(bench.analysis().notes.empty());
  const Rect pane = bench.work_places().at("pane.fields");
  EXPECT_GT(bench.work_places().at("notes").min.y, pane.max.y);
  bench.click(bench.at("badge.notes"));
  const Rect notes = bench.work_places().at("notes");
  EXPECT_TRUE(notes.min.y >= pane.min.y && notes.max.y <= pane.max.y);
}

TEST(Workbench, TheFontHasEveryGlyphInUse) {
  Bench bench;
  for (const ImWchar c : {0xB0, 0x3B8, 0x3C6, 0x3C1, 0x3BB, 0x3BA, 0xB7, 0x2212, 0x2014, 0x2026, 0x221E, 0x21BA, 0x25B6})
    EXPECT_NE(ImGui::GetIO().Fonts->Fonts[0]->FindGlyphNoFallback(c), nullptr) << std::hex << c;
}

TEST(Workbench, NavigationTurnsMovesAndZooms) {
  Bench bench;
  const Experiment before = bench.experiment();
  bench.drag(bench.at("view.eye"), bench.at("view.eye", 0.7));
  EXPECT_NE(bench.experiment().camera.position, before.camera.position);
  EXPECT_EQ(bench.experiment().camera.target, before.camera.target);
  bench.drag(bench.at("view.map"), bench.at("view.map", 0.7));
  EXPECT_NE(bench.experiment().view.map_center, before.view.map_center);
  bench.wheel(bench.at("view.map"), 2.0);
  EXPECT_GT(bench.experiment().view.map_zoom, 1.0);
  bench.drag(bench.at("view.cube"), bench.at("view.cube", 0.7), 2);
  EXPECT_GT(bench.experiment().view.cube.distance, 0.0);
  bench.key('F');
  EXPECT_EQ(bench.experiment().view, ViewSettings{});
}

}  // namespace
}  // namespace psm::test
