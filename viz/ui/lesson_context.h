// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the lesson pane pass around. Private to lesson_*.cpp.
#pragma once

#include <imgui.h>

#include <cmath>

#include "ui/lesson_panel.h"

namespace psm {

struct LessonPanel::Context {
  UiContext& ui;
  const LessonSession& session;
  Rect pane;
  Experiment& experiment;
  PageStyle style;      // of the texts
  bool staged = false;  // in front of a class
  std::vector<LessonCommand> commands = {};

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

  // Heights of widgets in type of `style.size`, which need not be ImGui's size at the moment.
  double gap() const { return ImGui::GetStyle().ItemSpacing.y; }
  double widget_height() const { return style.size + 2.0 * ImGui::GetStyle().FramePadding.y; }
  double words_height(const std::string& words) const {
    return ImGui::GetFont()->CalcTextSizeA(float(style.size), 1e9f, float(style.width), words.c_str()).y;
  }
  double part_heading_height() const { return 1.4 * style.size + 2.0 * gap(); }
};

Prose heading_prose(const std::string& text, int level);

/// A line of a heading between the parts of a step.
inline void part_heading(const char* text) {
  ImGui::Dummy({0, 0.4f * ImGui::GetFontSize()});
  ImGui::Separator();
  ImGui::TextDisabled("%s", text);
}

inline void wrapped_words(const std::string& words) {
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
}

inline void toned_words(const glm::vec3& tone, const std::string& words) {
  ImGui::PushStyleColor(ImGuiCol_Text, {tone.r, tone.g, tone.b, 1.0f});
  wrapped_words(words);
  ImGui::PopStyleColor();
}

}  // namespace psm
