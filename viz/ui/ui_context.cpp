// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/ui_context.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace psm {

void note_place(UiContext& ui, const std::string& name) {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ui.places[name] = {{int(min.x), int(min.y)}, {int(max.x), int(max.y)}};
}

void take_keyboard(UiContext& ui, const std::string& pane) {
  if (!ui.keyboard) return;
  ui.keyboard->panes.push_back(pane);
  if (ui.keyboard->wanted != pane) return;
  ui.keyboard->last = std::exchange(ui.keyboard->wanted, "");
  ImGuiContext& g = *ImGui::GetCurrentContext();
  ImGui::FocusWindow(g.CurrentWindow);
  ImGui::NavInitWindow(g.CurrentWindow, true);
  g.NavDisableHighlight = false;
  g.NavDisableMouseHover = true;
}

void focus_ring() {
  const ImGuiLastItemData& item = ImGui::GetCurrentContext()->LastItemData;
  ImGui::RenderNavHighlight(item.Rect, item.ID);
}

bool is_typing() {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  return g.ActiveId != 0 && ImGui::GetInputTextState(g.ActiveId) != nullptr;
}

bool mouse_on(const char* name) { return ImGui::GetCurrentContext()->HoveredId == ImGui::GetID(name); }

bool rested_on(const char* name) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  return g.HoveredId == ImGui::GetID(name) && !ImGui::IsAnyItemActive() && g.HoveredIdTimer >= kTooltipDelay;
}

void rest_tooltip(const std::string& text) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  if (!ImGui::IsItemHovered() || ImGui::IsAnyItemActive() || g.HoveredIdTimer < kTooltipDelay) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace psm
