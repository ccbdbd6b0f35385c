// SPDX-License-Identifier: GPL-3.0-or-later
// The handles of the world view without a mouse.
#include <set>

#include "harness.h"

namespace psm::test {
namespace {

TEST(HandleKeys, NSelectsOneHandleAfterTheOtherAndThenNone) {
  Bench bench("ground", {"light.type=point", "light.position=0,3,0"});
  std::vector<HandleKind> seen;
  for (int i = 0; i < 10; ++i) {
    bench.key('N');
    const auto selected = bench.work().selected_handle();
    if (!selected) break;
    seen.push_back(*selected);
  }
  EXPECT_EQ(bench.work().selected_handle(), std::nullopt);
  const std::set<HandleKind> kinds(seen.begin(), seen.end());
  EXPECT_EQ(kinds.size(), seen.size());
  for (const HandleKind kind : {HandleKind::camera_position, HandleKind::camera_target, HandleKind::light_position})
    EXPECT_EQ(kinds.count(kind), 1u) << name_of(kind);
}

TEST(HandleKeys, ArrowsMoveTheSelectedHandleAndOneUndoTakesThemBack) {
  Bench bench("ground", {"light.type=point", "light.position=0,3,0"});
  while (bench.work().selected_handle() != HandleKind::light_position) bench.key('N');
  const Experiment before = bench.experiment();
  for (int i = 0; i < 3; ++i) bench.key(key::right);
  const glm::dvec3 right = bench.experiment().light.position;
  EXPECT_NE(right, before.light.position);
  EXPECT_EQ(bench.experiment().camera, before.camera);
  EXPECT_EQ(bench.experiment().view, before.view);
  bench.key('Z', {true, false, false});
  EXPECT_EQ(bench.experiment(), before);
  bench.key(key::up, {false, true, false});
  const glm::dvec3 up = bench.experiment().light.position;
  EXPECT_GT(up.y, 3.0);
  EXPECT_NEAR(up.x, 0.0, 1e-9) << "with Shift along the vertical";
  EXPECT_NEAR(up.z, 0.0, 1e-9);
}

TEST(HandleKeys, EscapeLetsGoAndArrowsThenMoveNothing) {
  Bench bench("ground");
  bench.key('N');
  ASSERT_TRUE(bench.work().selected_handle());
  bench.key(key::escape);
  EXPECT_FALSE(bench.work().selected_handle());
  const Experiment before = bench.experiment();
  bench.key(key::right);
  EXPECT_EQ(bench.experiment(), before);
}

}  // namespace
}  // namespace psm::test
