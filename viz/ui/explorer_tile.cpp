// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explorer_tile.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "draw/explorer_map.h"
#include "ui/tile_tools.h"

namespace psm {
namespace {

constexpr double kLeastQuiz = 300.0, kOverWords = 10.0;  // pixels at scale 1; all of what is written beside the map is covered

ExplorerMap map_of(const ViewImages& images, glm::ivec2 size, double scale) {
  return explorer_map(images.analysis(), glm::dvec2(size) / scale);
}

void slice_menu(UiContext& ui, ExplorerSlice& slice, float width) {
  constexpr std::array names{"from the side", "from above"};
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##slice", names[std::size_t(slice)]);
  note_place(ui, "tile.explorer_slice");
  if (!open) return rest_tooltip(find_field("view.explorer_slice")->help);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (ImGui::Selectable(names[i], std::size_t(slice) == i)) slice = ExplorerSlice(i);
    note_place(ui, "tile.explorer_slice=" + std::to_string(i));
  }
  ImGui::EndCombo();
}

}  // namespace

bool on_explorer_map(const ViewImages& images, glm::ivec2 size, glm::dvec2 pixel, double scale) {
  return map_of(images, size, scale).contains(pixel / scale);
}

Experiment with_light_under(const Experiment& before, const ViewImages& images, glm::ivec2 size, glm::dvec2 pixel, double scale,
                            double snap_pixels) {
  return map_of(images, size, scale).with_light_at(before, pixel / scale, snap_pixels / scale);
}

bool explorer_tools(UiContext& ui, const Rect& picture, Experiment& experiment) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const bool sliced = experiment.light.type != LightType::directional;
  const float menu = sliced ? 8.0f * ImGui::GetFontSize() : 0.0f, gap = sliced ? style.ItemSpacing.x : 0.0f;
  const float quiz = ImGui::CalcTextSize("Quiz").x + 2.0f * style.FramePadding.x;
  if (!begin_tile_tools("explorer tools", picture, menu + gap + quiz)) return false;
  if (sliced) slice_menu(ui, experiment.view.explorer_slice, menu);
  if (sliced) ImGui::SameLine();
  const bool clicked = ImGui::Button("Quiz");
  note_place(ui, "tile.quiz");
  rest_tooltip("Random lights: what are they after the projection?");
  end_tile_tools();
  return clicked;
}

Rect quiz_place(const Rect& picture, double scale) {
  if (picture.empty()) return {};
  const PageRect beside = beside_explorer_map(glm::dvec2(picture.size()) / scale);
  const int top = picture.min.y + int(beside.min.y * scale);
  if (beside.max.x - beside.min.x >= kLeastQuiz)
    return {{picture.min.x + int((beside.min.x - kOverWords) * scale), top},
            picture.min + glm::ivec2(int(beside.max.x * scale), int(beside.max.y * scale))};
  return {{picture.min.x, top}, picture.max};
}

}  // namespace psm
