// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/eye_tools.h"

#include <imgui.h>

#include "ui/tile_tools.h"

namespace psm {
namespace {

constexpr EyeOverlay kOverlays[] = {EyeOverlay::none, EyeOverlay::texel_size, EyeOverlay::anisotropy, EyeOverlay::errors,
                                    EyeOverlay::penumbra};

const char* explanation(EyeOverlay overlay) {
  switch (overlay) {
    case EyeOverlay::none:
      return "The picture itself, with shadows from the map.";
    case EyeOverlay::texel_size:
      return "m: the largest extent of a shadow-map texel in pixels, at each pixel. Hatched where m > 1.";
    case EyeOverlay::anisotropy:
      return "A texel's largest extent in the picture by its smallest.";
    case EyeOverlay::errors:
      return "Where the map is wrong against ray-traced shadows, by cause; traced when nothing moves.";
    case EyeOverlay::penumbra:
      return "How much of the light each point sees, by rays: umbra, penumbra, lit. light.radius gives the light its size.";
  }
  return "";
}

void overlay_menu(UiContext& ui, Experiment& experiment, float width) {
  EyeOverlay& overlay = experiment.view.eye_overlay;
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##overlay", display_name(overlay));
  note_place(ui, "tile.eye_overlay");
  if (!open) return rest_tooltip(explanation(overlay));
  for (const EyeOverlay each : kOverlays) {
    if (ImGui::Selectable(display_name(each), each == overlay)) overlay = each;
    note_place(ui, std::string("tile.eye_overlay=") + name_of(each));
    rest_tooltip(explanation(each));
  }
  ImGui::EndCombo();
}

}  // namespace

const char* display_name(EyeOverlay overlay) {
  constexpr const char* names[] = {"Picture", "Texel size m", "Anisotropy", "Errors", "Penumbra"};
  return names[std::size_t(overlay)];
}

void eye_tools(UiContext& ui, const Rect& picture, Experiment& experiment) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float menu = 8.0f * ImGui::GetFontSize();
  const float check = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize("Grid").x;
  if (!begin_tile_tools("eye tools", picture, menu + style.ItemSpacing.x + check)) return;
  overlay_menu(ui, experiment, menu);
  ImGui::SameLine();
  ImGui::Checkbox("Grid", &experiment.view.texel_grid);
  note_place(ui, "tile.texel_grid");
  rest_tooltip("The map's texels on the receivers, in the eye, world and cube view.");
  end_tile_tools();
}

}  // namespace psm
