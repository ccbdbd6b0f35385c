// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/input_queue.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <limits>

namespace psm {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

bool key_down(const ImGuiIO& io, int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; }

void update_modifiers(ImGuiIO& io) {
  io.KeyCtrl = key_down(io, key::control, key::right_control);
  io.KeyShift = key_down(io, key::shift, key::right_shift);
  io.KeyAlt = key_down(io, key::alt, key::right_alt);
  io.KeySuper = key_down(io, key::super, key::right_super);
}

}  // namespace

void InputQueue::mouse_move(glm::dvec2 pixels) {
  // A run of moves is one move: only the last place counts.
  if (!events_.empty() && events_.back().kind == Kind::move) events_.pop_back();
  events_.push_back({Kind::move, pixels});
}
void InputQueue::mouse_leave() {
  // A drag goes on outside the window.
  if (held_ == 0) mouse_move(glm::dvec2(nowhere));
}
void InputQueue::mouse_button(int button, bool down) {
  if (button < 0 || button >= int(buttons_.size())) return;
  held_ = down ? held_ | (1u << button) : held_ & ~(1u << button);
  events_.push_back({Kind::button, {}, button, down});
}
void InputQueue::wheel(glm::dvec2 steps) { events_.push_back({Kind::wheel, steps}); }
void InputQueue::key(int key, bool down) {
  if (key >= 0 && key < 512) events_.push_back({Kind::key, {}, key, down});
}
void InputQueue::text(unsigned character) { events_.push_back({Kind::text, {}, int(character)}); }
void InputQueue::focus(bool focused) { events_.push_back({Kind::focus, {}, 0, focused}); }

bool InputQueue::fits(const Event& event, const Taken& taken) {
  switch (event.kind) {
    case Kind::move:
      return !taken.button && !taken.wheel;
    // A release ends the drag that the move before it still belongs to.
    case Kind::button:
      return !taken.button && !taken.wheel && (event.down || !taken.move);
    case Kind::wheel:
      return !taken.button;
    // A click may open a text field: what is typed next is for it.
    case Kind::key:
      return !taken.button && !taken.text && !taken.keys.count(event.code);
    case Kind::text:
      return !taken.button;
    default:
      return true;
  }
}

void InputQueue::take(const Event& event, Taken& taken, ImGuiIO& io, std::vector<KeyPress>& presses) {
  switch (event.kind) {
    case Kind::move:
      mouse_ = event.place.x == nowhere ? std::nullopt : std::optional<glm::dvec2>(event.place);
      taken.move = true;
      break;
    case Kind::button:
      buttons_[std::size_t(event.code)] = event.down;
      taken.button = true;
      break;
    case Kind::wheel:
      io.MouseWheel += float(event.place.y);
      io.MouseWheelH += float(event.place.x);
      taken.wheel = true;
      break;
    case Kind::key:
      io.KeysDown[event.code] = event.down;
      update_modifiers(io);
      taken.keys.insert(event.code);
      if (event.down) presses.push_back({event.code, {io.KeyCtrl, io.KeyShift, io.KeyAlt}});
      break;
    case Kind::text:
      io.AddInputCharacter(unsigned(event.code));
      taken.text = true;
      break;
    case Kind::focus:
      io.AddFocusEvent(event.down);
      if (!event.down) std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
      update_modifiers(io);
      break;
  }
}

void InputQueue::write_mouse(ImGuiIO& io) const {
  io.MousePos = mouse_ ? ImVec2(float(mouse_->x), float(mouse_->y)) : ImVec2(-FLT_MAX, -FLT_MAX);
  for (std::size_t i = 0; i < buttons_.size(); ++i) io.MouseDown[i] = buttons_[i];
}

std::vector<KeyPress> InputQueue::feed(ImGuiIO& io, bool hold) {
  std::vector<KeyPress> presses;
  Taken taken;
  while (!hold && !events_.empty() && fits(events_.front(), taken)) {
    take(events_.front(), taken, io, presses);
    events_.pop_front();
  }
  write_mouse(io);
  return presses;
}

}  // namespace psm
