// SPDX-License-Identifier: GPL-3.0-or-later
// In front of a class: what is shown, how large, and what a clicker does.
#include <imgui.h>

#include "draw/theme.h"
#include "harness.h"

namespace psm::test {
namespace {

/// A capital letter of the widgets' type, in pixels.
double capital_height() { return ImGui::GetFont()->FindGlyph('H')->Y1 - ImGui::GetFont()->FindGlyph('H')->Y0; }

TEST(Presentation, TypeReadsFromTheLastRowAtAnySizeOfTheScreen) {
  for (const glm::ivec2 size : {glm::ivec2(1024, 768), glm::ivec2(1920, 1080), glm::ivec2(3840, 2160)}) {
    Bench bench("ground", {}, size);
    bench.key(key::f11);
    bench.frame();
    EXPECT_GE(capital_height() * 1080.0 / size.y, 21.5) << size.x << " x " << size.y;
    EXPECT_GE(bench.work().look(size, 1.0).scale, 1.8);
  }
}

glm::vec3 style_color(ImGuiCol which) {
  const ImVec4 c = ImGui::GetStyle().Colors[which];
  return {c.x, c.y, c.z};
}

TEST(Presentation, TypeHasTheContrastThatAProjectorNeedsInBothThemes) {
  Bench bench;
  bench.key(key::f11);
  for (int i = 0; i < 2; ++i) {
    for (const ImGuiCol ground : {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg})
      EXPECT_GE(contrast(style_color(ImGuiCol_Text), style_color(ground)), 7.0f);
    EXPECT_GE(contrast(style_color(ImGuiCol_NavHighlight), style_color(ImGuiCol_WindowBg)), 3.0f);
    bench.key('D');
  }
}

TEST(Presentation, OnlyTheViewsAndTheLightCaseAreThere) {
  for (const glm::ivec2 size : {glm::ivec2(1024, 768), glm::ivec2(3840, 2160)}) {
    Bench bench("ground", {"light.type=point", "light.position=0,2,1"}, size);
    bench.key(key::f11);
    for (const auto& [name, rect] : bench.work_places()) {
      const bool expected = name.starts_with("view.") || name == "badge.light";
      EXPECT_TRUE(expected) << name;
      EXPECT_TRUE(rect.min.x >= 0 && rect.min.y >= 0 && rect.max.x <= size.x && rect.max.y <= size.y) << name << " is cut";
    }
    EXPECT_TRUE(bench.on_screen("badge.light"));
    EXPECT_TRUE(bench.on_screen("view.eye"));
  }
}

TEST(Presentation, AClickerStepsThroughTheViewsAndEscapeLeaves) {
  Bench bench;
  bench.key(key::page_down);
  EXPECT_EQ(bench.experiment().view.maximised, std::nullopt) << "only in front of a class";
  bench.key(key::f5);
  EXPECT_TRUE(bench.work().presenting());
  bench.key(key::page_down);
  EXPECT_EQ(bench.experiment().view.maximised, ViewId::world);
  bench.key(key::right);
  EXPECT_EQ(bench.experiment().view.maximised, ViewId::cube);
  bench.key(key::page_up);
  bench.key(key::left);
  EXPECT_EQ(bench.experiment().view.maximised, std::nullopt);
  bench.key(key::escape);
  EXPECT_FALSE(bench.work().presenting());
  EXPECT_TRUE(bench.on_screen("light.type"));
}

TEST(Presentation, AFullStopMakesTheScreenBlackUntilAnyKey) {
  Bench bench;
  bench.key(key::f11);
  const auto bright = [&] {
    const Image screen = bench.screen();
    std::size_t count = 0;
    for (std::size_t i = 0; i < screen.rgba.size(); ++i) count += i % 4 < 3 && screen.rgba[i] > 0;
    return count;
  };
  EXPECT_GT(bright(), 1000u);
  bench.key('.');
  EXPECT_EQ(bright(), 0u);
  bench.key(key::escape);
  EXPECT_GT(bright(), 1000u);
  EXPECT_TRUE(bench.work().presenting()) << "the key only brought the picture back";
}

}  // namespace
}  // namespace psm::test
