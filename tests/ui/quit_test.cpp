// SPDX-License-Identifier: GPL-3.0-or-later
// Nobody's work is lost by closing the window, and the status text speaks of what was last done.
#include "harness.h"

namespace psm::test {
namespace {

constexpr Modifiers kControl{true, false, false};

void change(Bench& bench) { bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.7)); }

Bench& asked(Bench& bench) {
  change(bench);
  bench.key('Q', kControl);
  EXPECT_FALSE(bench.work().wants_quit());
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::unsaved);
  return bench;
}

TEST(Quit, AsksNothingWithoutChanges) {
  Bench bench;
  bench.drag(bench.at("view.world"), bench.at("view.world", 0.7));
  bench.key('3');
  bench.key('Q', kControl);
  EXPECT_TRUE(bench.work().wants_quit()) << "the views are nobody's work";
}

TEST(Quit, AsksNothingWhenTheChangesAreUndone) {
  Bench bench;
  change(bench);
  bench.key('Z', kControl);
  bench.work().ask_to_quit();
  EXPECT_TRUE(bench.work().wants_quit());
}

TEST(Quit, DiscardsByKey) {
  Bench bench;
  asked(bench).key('D');
  EXPECT_TRUE(bench.work().wants_quit());
}

TEST(Quit, DiscardsByMouse) {
  Bench bench;
  bench.click(asked(bench).at("dialog.discard"));
  EXPECT_TRUE(bench.work().wants_quit());
}

TEST(Quit, EscapeGoesOnWorking) {
  Bench bench;
  asked(bench).key(key::escape);
  EXPECT_FALSE(bench.work().wants_quit());
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
  bench.key('S', kControl);
  bench.type((bench.folder() / "x.psm.json").string());
  bench.key(key::enter);
  EXPECT_FALSE(bench.work().wants_quit()) << "a later save does not close the window";
  bench.work().ask_to_quit();
  EXPECT_TRUE(bench.work().wants_quit());
}

TEST(Quit, SavesFirst) {
  for (int first : {int('S'), key::enter}) {
    Bench bench;
    asked(bench).key(first);
    ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::save);
    const std::string file = (bench.folder() / "kept.psm.json").string();
    bench.type(file);
    bench.key(key::enter);
    EXPECT_TRUE(bench.work().wants_quit());
    const auto kept = load_experiment(file, {});
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->experiment.light, bench.experiment().light);
  }
}

TEST(Quit, AKeyRightAfterASaveIsNotLost) {
  Bench bench;
  change(bench);
  bench.key('S', kControl);
  bench.type((bench.folder() / "kept.psm.json").string());
  for (const int code : {key::enter, key::control, int('Q')}) bench.input().key(code, true), bench.input().key(code, false);
  bench.input().key(key::control, true);
  bench.input().key('Q', true);
  bench.settle();
  EXPECT_TRUE(bench.work().wants_quit()) << "in the frame after the field has closed";
}

TEST(Quit, EnterTakesTheButtonThatTheArrowsReached) {
  Bench bench;
  asked(bench).key(key::right);
  bench.key(key::enter);
  EXPECT_TRUE(bench.work().wants_quit()) << "Discard is right of Save";
}

TEST(Quit, ASaveThatIsCancelledOrFailsKeepsTheWindow) {
  Bench bench;
  asked(bench).key('S');
  bench.type("/no/such/folder/x.psm.json");
  bench.key(key::enter);
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::error);
  bench.key(key::enter);
  ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::save);
  bench.key(key::escape);
  EXPECT_FALSE(bench.work().wants_quit());
  EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::none);
}

TEST(Status, GoesWithTheNextChange) {
  Bench bench;
  change(bench);
  bench.key('Z', kControl);
  EXPECT_EQ(bench.work().message(), "undone");
  bench.move(bench.at("view.world"));
  EXPECT_EQ(bench.work().message(), "undone");
  change(bench);
  EXPECT_EQ(bench.work().message(), "");
  bench.key('Z', kControl);
  bench.key('T');
  EXPECT_EQ(bench.work().message(), "");
  bench.key('Z', kControl);
  bench.key('R');
  EXPECT_EQ(bench.work().message(), "");
}

}  // namespace
}  // namespace psm::test
