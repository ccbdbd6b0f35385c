// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, key and text events on their way to the widgets. The window and the tests fill the same queue.
#pragma once

#include <array>
#include <deque>
#include <glm/glm.hpp>
#include <optional>
#include <set>
#include <vector>

struct ImGuiIO;

namespace psm {

/// Key numbers are GLFW's; letters and digits are their ASCII capitals.
namespace key {
constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, del = 261;
constexpr int right = 262, left = 263, down = 264, up = 265, page_up = 266, page_down = 267, home = 268, end = 269;
constexpr int f1 = 290, f3 = 292, f5 = 294, f6 = 295, f11 = 300, f12 = 301, keypad_enter = 335;
constexpr int shift = 340, control = 341, alt = 342, super = 343;
constexpr int right_shift = 344, right_control = 345, right_alt = 346, right_super = 347;
}  // namespace key

struct Modifiers {
  bool control = false, shift = false, alt = false;
  bool operator==(const Modifiers&) const = default;
};

struct KeyPress {
  int key = 0;
  Modifiers modifiers;
};

/// Dear ImGui 1.86 sees only the state at the start of a frame: a button or key that goes down and up between two frames would be
/// lost. The queue hands over as many events as one frame can tell apart and keeps the rest for the next frame.
class InputQueue {
 public:
  void mouse_move(glm::dvec2 pixels);
  void mouse_leave();
  void mouse_button(int button, bool down);
  void wheel(glm::dvec2 steps);
  void key(int key, bool down);
  void text(unsigned character);
  void focus(bool focused);

  bool empty() const { return events_.empty(); }

  /// Moves events into `io` for the frame that begins now; returns the keys that went down, in order. `hold`: all events wait.
  std::vector<KeyPress> feed(ImGuiIO& io, bool hold = false);

 private:
  enum class Kind { move, button, wheel, key, text, focus };
  struct Event {
    Kind kind;
    glm::dvec2 place{0.0};
    int code = 0;
    bool down = false;
  };
  /// What this frame has taken already.
  struct Taken {
    bool move = false, button = false, wheel = false, text = false;
    std::set<int> keys;
  };
  static bool fits(const Event& event, const Taken& taken);
  void take(const Event& event, Taken& taken, ImGuiIO& io, std::vector<KeyPress>& presses);
  void write_mouse(ImGuiIO& io) const;

  std::deque<Event> events_;
  unsigned held_ = 0;  // buttons down after the last event in the queue, one bit each
  // As of the last event taken. A window system's backend may write the mouse of this very moment, which is ahead of the queue.
  std::optional<glm::dvec2> mouse_;
  std::array<bool, 5> buttons_{};
};

}  // namespace psm
