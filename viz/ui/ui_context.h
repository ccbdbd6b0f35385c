// SPDX-License-Identifier: GPL-3.0-or-later
// What every widget of a frame may look at.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "draw/sketch.h"
#include "ui/layout.h"
#include "ui/model.h"
#include "ui/settings.h"

namespace psm {

/// Where each widget stood in the last frame, by name ("camera.near", "light.to_light.x", "theta", "view.world"): tests and
/// scripts find them here.
using Places = std::map<std::string, Rect>;

/// The panes that are on the screen, in order, and which of them is to take the keyboard. Key F6 goes from one to the next.
struct KeyboardPane {
  std::vector<std::string> panes;
  std::string wanted, last;
};

struct UiContext {
  const Model& model;
  Theme theme;
  double scale;  // pixels per pixel at scale 1
  Places& places;
  const std::vector<std::filesystem::path>& experiments;  // that come with the program
  KeyboardPane* keyboard = nullptr;
};

/// Notes the place of the widget that was submitted last.
void note_place(UiContext& ui, const std::string& name);

/// In a pane that has just begun: gives it the keyboard if that is wanted. The arrow keys then start at its first widget.
void take_keyboard(UiContext& ui, const std::string& pane);

constexpr float kTooltipDelay = 0.4f;  // seconds

/// The ring around the widget that was submitted last where it has the keyboard: for those that ImGui draws nothing of.
void focus_ring();

/// A tooltip for the widget that was submitted last, once the mouse has rested on it.
void rest_tooltip(const std::string& text);

/// Whether a text field takes what is typed in this frame. ImGui's WantTextInput still says so in the frame after the field has
/// closed, when keys mean the window again.
bool is_typing();

/// Whether the mouse is on the widget of this name, in the current window.
bool mouse_on(const char* name);

/// Whether the mouse has rested on the widget of this name, in the current window, for as long as a tooltip takes.
bool rested_on(const char* name);

/// A short number: at most `digits` significant ones; "∞" for infinity.
inline std::string shown_number(double value, int digits = 4) { return short_number(value, digits); }

}  // namespace psm
