// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <imgui.h>

#include "harness.h"

namespace psm::test {
namespace {

constexpr Modifiers kControl{true, false, false}, kControlShift{true, true, false};

TEST(Share, WhatWasCopiedAsALinePastesAsTheSameExperiment) {
  Bench bench("ground", {"shadow.resolution=256", "light.to_light=0.4,1,-0.3"});
  const Experiment copied = bench.experiment();
  bench.key('C', kControlShift);
  EXPECT_EQ(std::string(ImGui::GetClipboardText()), "psmlab:ground?light.to_light=0.4,1,-0.3&shadow.resolution=256");
  bench.work().open("chessboard");
  bench.settle();
  const Experiment chessboard = bench.experiment();
  bench.key('V', kControl);
  EXPECT_EQ(bench.experiment(), copied);
  bench.key('Z', kControl);
  EXPECT_EQ(bench.experiment(), chessboard);
}

TEST(Share, JsonPastesToo) {
  Bench bench("ground", {"shadow.resolution=256"});
  const Experiment copied = bench.experiment();
  bench.key('C', kControl);
  bench.key('T');
  EXPECT_NE(bench.experiment(), copied);
  bench.key('V', kControl);
  EXPECT_EQ(bench.experiment(), copied);
}

TEST(Share, AnythingElseIsRefusedAndNothingChanges) {
  Bench bench;
  const Experiment before = bench.experiment();
  ImGui::SetClipboardText("psmlab:ground?shadow.resolution=1");
  bench.key('V', kControl);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::error);
  EXPECT_EQ(bench.experiment(), before);
  bench.key(key::enter);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
}

}  // namespace
}  // namespace psm::test
