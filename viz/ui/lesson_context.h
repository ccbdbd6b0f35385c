// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the lesson pane pass around. Private to lesson_*.cpp.
#pragma once

#include <imgui.h>

#include "ui/lesson_panel.h"

namespace psm {

struct LessonPanel::Context {
  UiContext& ui;
  const LessonSession& session;
  Rect pane;
  Experiment& experiment;
  std::vector<LessonCommand> commands;

  const LessonRun& run() const { return *session.run(); }
  void ask(LessonCommand::Kind kind, std::size_t index = 0, std::string text = "") {
    commands.push_back({kind, index, std::move(text), 0, 0.0});
  }
  /// A button that tests find.
  bool button(const char* label, const std::string& place) {
    ImGui::PushID(place.c_str());
    const bool pressed = ImGui::Button(label);
    ImGui::PopID();
    note_place(ui, place);
    return pressed;
  }
};

/// A line of a heading between the parts of a step.
inline void part_heading(const char* text) {
  ImGui::Dummy({0, 0.4f * ImGui::GetFontSize()});
  ImGui::Separator();
  ImGui::TextDisabled("%s", text);
}

}  // namespace psm
