// SPDX-License-Identifier: GPL-3.0-or-later
// The first run's card: where to begin. Over the control pane, so that it covers no picture.
#include <imgui.h>

#include <algorithm>

#include "ui/workbench.h"
#include "ui/workbench_frame.h"

namespace psm {

bool Workbench::shows_start_card() const {
  return options_.start_card && settings_.start_card && lessons_.progress().empty() && !presenting_;
}

/// What the card offers closes it as well; whether the key has had its effect.
bool Workbench::take_start_key(const KeyPress& press) {
  if (!shows_start_card()) return false;
  const bool closes = press.key == key::escape || press.key == key::enter || press.key == key::keypad_enter;
  const auto action = action_of(press);
  if (closes || action == Action::toggle_lesson || action == Action::open || action == Action::help) settings_.start_card = false;
  return closes;
}

void Workbench::start_card(Frame& f) {
  if (!shows_start_card() || dialogs_.shown() != Dialogs::Kind::none) return;
  const float em = ImGui::GetFontSize(), margin = 0.5f * em;
  const float room = f.layout.pane.empty() ? 20.0f * em : float(f.layout.pane.size().x);
  ImGui::SetNextWindowPos({float(f.size.x) - margin, float(f.layout.badges.min.y) - margin}, ImGuiCond_Always, {1.0f, 1.0f});
  ImGui::SetNextWindowSize({std::max(1.0f, room - 2.0f * margin), 0.0f});
  ImGui::Begin("start", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize);
  const bool elsewhere = ImGui::IsMouseClicked(0) && !ImGui::IsWindowHovered();
  const auto offer = [&](const char* label, const char* place, std::optional<Action> action) {
    const bool pressed = ImGui::Button(label, {ImGui::GetContentRegionAvail().x, 0.0f});
    note_place(f.ui, place);
    if (!pressed) return;
    settings_.start_card = false;
    requests_.action = action;
  };
  ImGui::TextUnformatted("Where to begin");
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0f, 0.5f});
  offer("Open a lesson (L)", "start.lesson", Action::toggle_lesson);
  offer("Open a scene or a file (Ctrl+O)", "start.open", Action::open);
  offer("All keys (F1)", "start.help", Action::help);
  offer("Close (Esc)", "start.close", std::nullopt);
  ImGui::PopStyleVar();
  places_["start"] = {
      {int(ImGui::GetWindowPos().x), int(ImGui::GetWindowPos().y)},
      {int(ImGui::GetWindowPos().x + ImGui::GetWindowSize().x), int(ImGui::GetWindowPos().y + ImGui::GetWindowSize().y)}};
  ImGui::End();
  if (elsewhere) settings_.start_card = false;
}

}  // namespace psm
