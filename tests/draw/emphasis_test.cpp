// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/emphasis.h"

#include <gtest/gtest.h>

namespace psm {
namespace {

DrawList two_roles() {
  DrawList list;
  for (const Role role : {Role::light, Role::frustum, Role::neutral}) {
    DrawLine line;
    line.role = role;
    list.lines.push_back(line);
    DrawFill fill;
    fill.role = role;
    list.fills.push_back(fill);
  }
  return list;
}

TEST(Emphasis, DrawsWhatIsNamedStrongerAndTheRestFainter) {
  const DrawList before = two_roles();
  DrawList list = before;
  emphasise(list, {{Role::light}, {}});
  EXPECT_GT(list.lines[0].width, before.lines[0].width);
  EXPECT_EQ(list.lines[0].fade_a, 1.0);
  EXPECT_GT(list.fills[0].alpha, before.fills[0].alpha);
  EXPECT_LT(list.lines[1].fade_a, 0.5);
  EXPECT_LT(list.lines[1].fade_b, 0.5);
  EXPECT_LT(list.fills[1].alpha, before.fills[1].alpha);
  EXPECT_EQ(list.lines[2].fade_a, 1.0) << "axes and cube have no role to compete";
}

TEST(Emphasis, LeavesOutWhatIsHidden) {
  DrawList list = two_roles();
  emphasise(list, {{}, {Role::light}});
  ASSERT_EQ(list.lines.size(), 2u);
  EXPECT_EQ(list.lines[0].role, Role::frustum);
  EXPECT_EQ(list.lines[0].fade_a, 1.0) << "nothing is stressed";
}

TEST(Emphasis, OfNothingChangesNothing) {
  const DrawList before = two_roles();
  DrawList list = before;
  emphasise(list, {});
  for (std::size_t i = 0; i < list.lines.size(); ++i) {
    EXPECT_EQ(list.lines[i].fade_a, before.lines[i].fade_a);
    EXPECT_EQ(list.lines[i].width, before.lines[i].width);
    EXPECT_EQ(list.fills[i].alpha, before.fills[i].alpha);
  }
}

}  // namespace
}  // namespace psm
