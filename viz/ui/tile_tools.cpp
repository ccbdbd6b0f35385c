// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tile_tools.h"

#include <imgui.h>

#include <cmath>

namespace psm {

bool begin_tile_tools(const char* id, const Rect& picture, float width) {
  const float font = ImGui::GetFontSize(), pad = std::floor(0.25f * font);
  const float full = width + 2.0f * pad, height = 2.0f * pad + ImGui::GetFrameHeight();
  if (float(picture.size().x) < full + 4.0f * font || float(picture.size().y) < 3.0f * height) return false;
  ImGui::SetCursorScreenPos({float(picture.max.x) - full - pad, float(picture.min.y) + pad});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::BeginChild(id, {full, height}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  return true;
}

void end_tile_tools() {
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

}  // namespace psm
