// SPDX-License-Identifier: GPL-3.0-or-later
// Pop-ups by the keyboard.
#include "harness.h"

namespace psm::test {
namespace {

constexpr Modifiers kControl{true, false, false};

TEST(Dialogs, EnterClosesTheErrorAndThePathIsStillThere) {
  Bench bench;
  const std::string file = (bench.folder() / "late.psm.json").string();
  bench.key('O', kControl);
  bench.type(file);
  bench.key(key::enter);
  ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::error);
  bench.key(key::enter);
  ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::open);
  // The very same path, once the file is there.
  ASSERT_TRUE(load_experiment("chessboard", {}));
  ASSERT_FALSE(save_experiment(*load_experiment("chessboard", {}), file));
  bench.key(key::enter);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
  EXPECT_EQ(bench.experiment().scene.source, "chessboard");
}

TEST(Dialogs, EscapeLeavesTheErrorAndTheOpenDialog) {
  Bench bench;
  bench.key('O', kControl);
  bench.type("/no/such/file.glb");
  bench.key(key::enter);
  bench.key(key::escape);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::open);
  bench.key(key::escape);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
}

TEST(Dialogs, AFailedSaveAsksAgain) {
  Bench bench;
  bench.key('S', kControl);
  bench.type("/no/such/folder/x.psm.json");
  bench.key(key::enter);
  ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::error);
  bench.key(key::keypad_enter);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::save);
}

TEST(Dialogs, AnErrorThatNobodyTypedJustCloses) {
  Bench bench;
  bench.work().open("/no/such/file.glb");
  bench.settle();
  ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::error);
  bench.key(key::enter);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
}

TEST(Dialogs, EnterClosesTheHelp) {
  Bench bench;
  bench.key(key::f1);
  bench.key(key::enter);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
}

}  // namespace
}  // namespace psm::test
