// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/control_pane.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "ui/field_widgets.h"
#include "ui/theme.h"

namespace psm {
namespace {

// Short names at the left, long ones at the right.
constexpr std::array offered = {Technique::uniform, Technique::plane_optimal,    Technique::psm,     Technique::best_plane,
                                Technique::lispsm,  Technique::lispsm_reference, Technique::glpr,    Technique::psm_recipe,
                                Technique::gmnpr,   Technique::psm_divided,      Technique::minimax, Technique::minimax_frustum,
                                Technique::custom,  Technique::psm_two_maps};
constexpr int technique_rows = int(offered.size() + 1) / 2;

const char* explanation(Technique technique) {
  switch (technique) {
    case Technique::uniform:
      return "uniform: the vanishing plane at infinity; every texel covers the same part of the map's window.";
    case Technique::psm:
      return "psm: the map of the post-perspective cube, seen from the light (Stamminger & Drettakis 2002).";
    case Technique::lispsm:
      return "lispsm: light space perspective, λ as GMNPR 2007 prints it (Eq. 9).";
    case Technique::lispsm_reference:
      return "lispsm_reference: light space perspective as its authors' code computes it.";
    case Technique::glpr:
      return "glpr: generalised linear perspective; it exists only where θ > φ.";
    case Technique::gmnpr:
      return "gmnpr: generalised minimum norm, with its own λ below φ (GMNPR 2007, Eq. 4 and 7).";
    case Technique::minimax:
      return "minimax: the least maximum of F on the frustum's central line.";
    case Technique::minimax_frustum:
      return "minimax_frustum: the least maximum of E over the whole frustum.";
    case Technique::plane_optimal:
      return "plane_optimal: every texel on one receiver plane has the same size in the image (Chong & Gortler 2004).";
    case Technique::best_plane:
      return "best_plane: found by search; the smallest 95th percentile of m that any single vanishing plane gives here.";
    case Technique::psm_divided:
      return "psm_divided: PSM with the light divided by its w and the depth test reversed where w < 0, after the camera shift "
             "(2002 paper).";
    case Technique::psm_two_maps:
      return "psm_two_maps: PSM divided without a shift: what stands behind the eye has a second map, beyond the infinity plane "
             "(2002 paper).";
    case Technique::psm_recipe:
      return "psm_recipe: look at the cube's centre, opening angle around the cube (the paper's web page); its failures are "
             "noted.";
    default:
      return "custom: the vanishing plane that shadow.plane gives.";
  }
}

std::string scene_title(const std::string& source) {
  return source.find('/') == std::string::npos ? source : std::filesystem::path(source).filename().string();
}

void scene_selector(UiContext& ui, Requests& requests) {
  const std::string& current = ui.model.experiment().scene.source;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Scene");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const bool open = ImGui::BeginCombo("##scene", scene_title(current).c_str());
  note_place(ui, "scene.source");
  if (!open) return;
  for (const std::string& id : builtin_scene_ids()) {
    if (ImGui::Selectable(id.c_str(), id == current)) requests.open = id;
    note_place(ui, "scene.source=" + id);
  }
  ImGui::Separator();
  for (const std::filesystem::path& file : ui.experiments) {
    const std::string title = file.stem().stem().string();  // without .psm.json
    if (ImGui::Selectable(title.c_str())) requests.open = file.string();
    note_place(ui, "scene.source=" + title);
  }
  ImGui::Separator();
  if (ImGui::Selectable("Open a file…")) requests.action = Action::open;
  note_place(ui, "scene.source=file");
  if (ImGui::Selectable("Lessons…")) requests.action = Action::toggle_lesson;
  note_place(ui, "scene.source=lessons");
  ImGui::EndCombo();
}

/// Width of a column of radio buttons: every second technique.
float column_width(int first) {
  float widest = 0.0f;
  for (std::size_t i = std::size_t(first); i < offered.size(); i += 2)
    widest = std::max(widest, ImGui::CalcTextSize(display_name(offered[i])).x);
  return widest + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
}

/// Large type in a narrow pane has no room for two columns.
bool has_room_for_buttons(float width) { return column_width(0) + column_width(1) + 4.0f <= width; }

void technique_item(UiContext& ui, Technique technique, bool chosen, Experiment& experiment) {
  if (chosen) experiment.shadow.technique = technique;
  note_place(ui, std::string("shadow.technique=") + name_of(technique));
  rest_tooltip(explanation(technique));
}

void technique_buttons(UiContext& ui, Experiment& experiment) {
  const float spare = ImGui::GetContentRegionAvail().x - column_width(0) - column_width(1);
  const float right = ImGui::GetCursorPosX() + std::floor(column_width(0) + std::min(spare, 2.0f * ImGui::GetFontSize()));
  for (int i = 0; i < int(offered.size()); ++i) {
    if (i % 2 == 1) ImGui::SameLine(right);
    const Technique technique = offered[std::size_t(i)];
    const bool chosen = ImGui::RadioButton(display_name(technique), experiment.shadow.technique == technique);
    technique_item(ui, technique, chosen, experiment);
  }
}

void technique_menu(UiContext& ui, Experiment& experiment) {
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const bool open = ImGui::BeginCombo("##technique", display_name(experiment.shadow.technique));
  note_place(ui, "shadow.technique");
  if (!open) return;
  for (Technique technique : offered) {
    const bool chosen = ImGui::Selectable(display_name(technique), experiment.shadow.technique == technique);
    technique_item(ui, technique, chosen, experiment);
  }
  ImGui::EndCombo();
}

/// Which technique drew the picture, in one line that is always there, so that nothing below it jumps.
void used_line(const UiContext& ui) {
  const Analysis& a = ui.model.analysis();
  const bool fell_back = a.technique_used != a.experiment.shadow.technique;
  const glm::vec3 tone = warning_color(ui.theme);
  const std::string name = display_name(a.technique_used);
  if (fell_back)
    ImGui::TextColored({tone.r, tone.g, tone.b, 1.0f}, "▶ fell back to %s", name.c_str());
  else
    ImGui::TextDisabled("used: %s", name.c_str());
  for (const Note& note : a.notes)
    if (fell_back && &note == &a.notes.front() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", note.text.c_str());
}

bool shown_in_header(const Field& field) { return field.path == "scene.source" || field.path == "shadow.technique"; }

void group_of_fields(UiContext& ui, const std::string& group, Experiment& experiment) {
  for (const Field& field : experiment_fields())
    if (field_group(field) == group && !shown_in_header(field)) field_row(ui, field, experiment);
}

bool group_header(UiContext& ui, const char* group, bool open) {
  const bool shown = ImGui::CollapsingHeader(group, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
  note_place(ui, std::string("group.") + group);
  return shown;
}

}  // namespace

const std::vector<Technique>& offered_techniques() {
  static const std::vector<Technique> list(offered.begin(), offered.end());
  return list;
}

const char* display_name(Technique technique) {
  switch (technique) {
    case Technique::uniform:
      return "Uniform";
    case Technique::psm:
      return "PSM";
    case Technique::lispsm:
      return "LiSPSM";
    case Technique::lispsm_reference:
      return "LiSPSM code";
    case Technique::glpr:
      return "GLPR";
    case Technique::gmnpr:
      return "GMNPR";
    case Technique::minimax:
      return "Minimax";
    case Technique::minimax_frustum:
      return "Minimax full";
    case Technique::plane_optimal:
      return "Plane-optimal";
    case Technique::best_plane:
      return "Best plane";
    case Technique::psm_recipe:
      return "PSM recipe";
    case Technique::psm_divided:
      return "PSM divided";
    case Technique::psm_two_maps:
      return "PSM two maps";
    case Technique::custom:
      return "Custom";
  }
  return "";
}

void control_fields(UiContext& ui, LightControls& light, Experiment& experiment) {
  if (group_header(ui, "light", true)) {
    light_controls(ui, light, experiment);
    ImGui::Spacing();
    group_of_fields(ui, "light", experiment);
  }
  if (group_header(ui, "camera", true)) group_of_fields(ui, "camera", experiment);
  if (group_header(ui, "shadow", true)) group_of_fields(ui, "shadow", experiment);
  if (group_header(ui, "bias and filter", false)) group_of_fields(ui, "bias and filter", experiment);
  if (group_header(ui, "image", false)) group_of_fields(ui, "image", experiment);
  if (group_header(ui, "view", false)) group_of_fields(ui, "view", experiment);
}

float control_header_height(float pane_width) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const int rows = has_room_for_buttons(pane_width - 2.0f * style.WindowPadding.x) ? technique_rows : 1;
  return float(1 + rows) * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() + style.WindowPadding.y;
}

void control_header(UiContext& ui, Experiment& experiment, Requests& requests) {
  scene_selector(ui, requests);
  if (has_room_for_buttons(ImGui::GetContentRegionAvail().x))
    technique_buttons(ui, experiment);
  else
    technique_menu(ui, experiment);
  used_line(ui);
}

}  // namespace psm
