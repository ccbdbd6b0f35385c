// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/input_queue.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace psm::test {
namespace {

class InputQueueTest : public testing::Test {
 protected:
  InputQueueTest() : context_(ImGui::CreateContext()) {}
  ~InputQueueTest() override { ImGui::DestroyContext(context_); }
  ImGuiIO& io() { return ImGui::GetIO(); }

  ImGuiContext* context_;
  InputQueue queue_;
};

TEST_F(InputQueueTest, AClickBetweenTwoFramesIsSeen) {
  queue_.mouse_move({3, 4});
  queue_.mouse_button(0, true);
  queue_.mouse_button(0, false);
  queue_.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
  EXPECT_EQ(io().MousePos.x, 3.0f);
  queue_.feed(io());
  EXPECT_FALSE(io().MouseDown[0]);
  EXPECT_TRUE(queue_.empty());
}

TEST_F(InputQueueTest, TheLastMoveOfADragIsSeenBeforeTheRelease) {
  queue_.mouse_button(0, true);
  queue_.mouse_move({10, 0});
  queue_.mouse_move({20, 0});
  queue_.mouse_button(0, false);
  queue_.feed(io());
  queue_.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
  EXPECT_EQ(io().MousePos.x, 20.0f);
  queue_.feed(io());
  EXPECT_FALSE(io().MouseDown[0]);
}

TEST_F(InputQueueTest, TheMouseIsWhereTheQueueIsNotWhereABackendSeesIt) {
  queue_.mouse_move({3, 4});
  queue_.mouse_button(0, true);
  queue_.mouse_move({5, 6});
  queue_.feed(io());
  io().MousePos = {99.0f, 99.0f};
  io().MouseDown[0] = false;
  queue_.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
  EXPECT_EQ(io().MousePos.x, 5.0f);
}

TEST_F(InputQueueTest, AKeyStrokeIsSeenWithItsModifiers) {
  queue_.key(key::control, true);
  queue_.key('Z', true);
  queue_.key('Z', false);
  queue_.key(key::control, false);
  const auto presses = queue_.feed(io());
  ASSERT_EQ(presses.size(), 2u);
  EXPECT_EQ(presses[1].key, 'Z');
  EXPECT_EQ(presses[1].modifiers, (Modifiers{true, false, false}));
  EXPECT_TRUE(io().KeysDown['Z']);
  while (!queue_.empty()) queue_.feed(io());
  EXPECT_FALSE(io().KeysDown['Z']);
  EXPECT_FALSE(io().KeyCtrl);
}

TEST_F(InputQueueTest, LosingTheFocusReleasesAllKeys) {
  queue_.key('A', true);
  queue_.feed(io());
  queue_.focus(false);
  queue_.feed(io());
  EXPECT_FALSE(io().KeysDown['A']);
}

TEST_F(InputQueueTest, NumbersOutOfRangeAreIgnored) {
  queue_.key(-1, true);
  queue_.key(512, true);
  queue_.mouse_button(7, true);
  EXPECT_TRUE(queue_.empty());
}

}  // namespace
}  // namespace psm::test
