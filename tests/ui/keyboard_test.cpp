// SPDX-License-Identifier: GPL-3.0-or-later
// What the mouse can do, keys can do.
#include <imgui.h>
#include <imgui_internal.h>

#include "harness.h"

namespace psm::test {
namespace {

constexpr Modifiers kControl{true, false, false};

TEST(Keyboard, MovesTheLineBetweenAAndB) {
  Bench bench("ground");
  bench.key(key::right, kControl);
  EXPECT_EQ(bench.experiment().view.split, 0.5) << "nothing is compared";
  bench.key('B');
  bench.key(key::left, kControl);
  bench.key(key::left, kControl);
  EXPECT_DOUBLE_EQ(bench.experiment().view.split, 0.46);
  for (int i = 0; i < 40; ++i) bench.key(key::right, kControl);
  EXPECT_EQ(bench.experiment().view.split, 1.0);
}

TEST(Keyboard, F6GoesFromPaneToPane) {
  Bench bench("ground");
  const auto pane = [] { return std::string(ImGui::GetCurrentContext()->NavWindow->Name); };
  bench.key(key::f6);
  EXPECT_NE(pane().find("fields"), std::string::npos) << pane();
  bench.key(key::f6);
  EXPECT_NE(pane().find("header"), std::string::npos) << pane();
  const double before = bench.experiment().camera.vertical_fov_deg;
  const ImGuiID first = ImGui::GetCurrentContext()->NavId;
  EXPECT_NE(first, 0u) << "a widget has the keys at once";
  bench.key(key::down);
  EXPECT_NE(ImGui::GetCurrentContext()->NavId, first);
  EXPECT_EQ(bench.experiment().camera.vertical_fov_deg, before);
  bench.key('L');
  bench.key(key::f6);
  EXPECT_NE(pane().find("lesson"), std::string::npos) << pane() << ": round";
}

TEST(Keyboard, SettingsHaveTheDividers) {
  Bench bench("ground");
  const double before = bench.work().settings().layout.pane;
  bench.key(',', kControl);
  bench.drag(bench.at("settings.controls", 0.3), bench.at("settings.controls", 0.9));
  EXPECT_GT(bench.work().settings().layout.pane, before);
}

}  // namespace
}  // namespace psm::test
