// SPDX-License-Identifier: GPL-3.0-or-later
// Key A: the camera shift of the 2002 paper, played from 0 to its automatic value.
#include "harness.h"

namespace psm::test {
namespace {

const std::vector<std::string> kShifted = {"light.type=point", "light.position=-6,9,8", "shadow.technique=psm_divided"};

TEST(CameraShift, PlaysFromZeroToTheAutomaticValue) {
  Bench bench("ground", kShifted);
  const Experiment before = bench.experiment();
  const double automatic = bench.analysis().camera_shift;
  ASSERT_GT(automatic, 0.0);
  bench.input().key('A', true);
  bench.input().key('A', false);
  double last = -1.0;
  int steps = 0;
  for (; bench.experiment().shadow.camera_shift != CameraShift(automatic) && steps < 100; ++steps) {
    bench.frame();
    const double* shift = std::get_if<double>(&bench.experiment().shadow.camera_shift);
    ASSERT_TRUE(shift);
    EXPECT_GE(*shift, last);
    EXPECT_LE(*shift, automatic);
    if (steps == 0) {
      EXPECT_LT(*shift, 0.05 * automatic);
    }
    last = *shift;
  }
  EXPECT_NEAR(steps, 36, 3) << "0.6 s at 60 frames a second";
  bench.settle();
  const auto drawn = bench.work().frames(), views = bench.work().views_drawn();
  bench.settle();
  EXPECT_EQ(bench.work().frames(), drawn);
  EXPECT_EQ(bench.work().views_drawn(), views);
  EXPECT_EQ(bench.experiment().shadow.camera_shift, CameraShift(automatic));
  EXPECT_EQ(bench.work().model().history().undo_count(), 1u);
  bench.key('Z', {true, false, false});
  EXPECT_EQ(bench.experiment(), before);
}

TEST(CameraShift, WithReducedMotionItIsAtItsEndAtOnce) {
  Bench bench("ground", kShifted);
  const double automatic = bench.analysis().camera_shift;
  Settings settings = bench.work().settings();
  settings.reduced_motion = true;
  bench.work().set_settings(settings);
  bench.settle();
  bench.input().key('A', true);
  bench.input().key('A', false);
  bench.frame();
  EXPECT_EQ(bench.experiment().shadow.camera_shift, CameraShift(automatic));
}

TEST(CameraShift, TheRuleThatWasChosenIsPlayedAgain) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,8", "shadow.technique=psm", "shadow.camera_shift=inside"});
  const double inside = bench.analysis().camera_shift;
  ASSERT_GT(inside, 0.0);
  for (int play = 0; play < 2; ++play) {
    bench.input().key('A', true);
    bench.input().key('A', false);
    bench.frame();
    EXPECT_NE(bench.experiment().shadow.camera_shift, CameraShift(inside));
    for (int i = 0; i < 50 && bench.experiment().shadow.camera_shift != CameraShift(inside); ++i) bench.frame();
    EXPECT_EQ(bench.experiment().shadow.camera_shift, CameraShift(inside));
  }
}

TEST(CameraShift, UndoOnTheWayStopsIt) {
  Bench bench("ground", kShifted);
  const Experiment before = bench.experiment();
  bench.input().key('A', true);
  bench.input().key('A', false);
  for (int i = 0; i < 10; ++i) bench.frame();
  ASSERT_NE(bench.experiment(), before);
  bench.key('Z', {true, false, false});
  EXPECT_EQ(bench.experiment(), before);
}

TEST(CameraShift, OtherTechniquesSayWhyNothingMoves) {
  Bench bench("ground");
  const Experiment before = bench.experiment();
  bench.key('A');
  EXPECT_EQ(bench.experiment(), before);
  EXPECT_NE(bench.work().message().find("PSM divided"), std::string::npos);
}

TEST(CameraShift, WhereNoneIsNeededTheStatusSaysSo) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8", "shadow.technique=psm_divided"});
  ASSERT_EQ(bench.analysis().camera_shift, 0.0);
  bench.key('A');
  EXPECT_NE(bench.work().message().find("is 0 here"), std::string::npos);
}

}  // namespace
}  // namespace psm::test
