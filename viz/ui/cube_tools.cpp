// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cube_tools.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "ui/slider.h"
#include "ui/tile_tools.h"

namespace psm {

void cube_tools(UiContext& ui, const Rect& picture, Experiment& experiment) {
  const float font = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemInnerSpacing.x, slider = 5.0f * font;
  const float width = slider + 2.0f * gap + ImGui::CalcTextSize("WorldCube").x;
  if (!begin_tile_tools("cube tools", picture, width)) return;
  double& t = experiment.view.world_to_cube;
  char text[16];
  std::snprintf(text, sizeof text, "%.2f", t);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("World");
  ImGui::SameLine(0.0f, gap);
  ImGui::SetNextItemWidth(slider);
  if (ticked_slider("##world_to_cube", t, {0.0, 1.0}, {}, text, ui.theme)) t = t >= 0.0 ? std::min(t, 1.0) : 0.0;
  note_place(ui, "tile.world_to_cube");
  rest_tooltip("The eye comes from infinity (the world as it is) to its place (the cube). Key W plays it.");
  ImGui::SameLine(0.0f, gap);
  ImGui::TextUnformatted("Cube");
  end_tile_tools();
}

}  // namespace psm
