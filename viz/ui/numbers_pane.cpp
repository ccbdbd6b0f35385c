// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/numbers_pane.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme.h"

namespace psm {
namespace {

constexpr const char* absent = "—";

std::string text_of(const std::optional<double>& value) { return value ? shown_number(*value, 5) : absent; }
std::string degrees_of(const std::optional<double>& value) {
  return value ? shown_number(glm::degrees(*value), 5) + "°" : absent;
}

std::optional<double> model_value(const Analysis& a, double ModelError::*member) {
  return a.model_error ? std::optional<double>((*a.model_error).*member) : std::nullopt;
}

std::string texel_value(const Analysis& a, double TexelStatistics::*member) {
  return a.texels ? shown_number((*a.texels).*member, 4) + " px" : absent;
}

/// All lines at all times, so that nothing below them jumps.
std::vector<NumberLine> probe_lines(const std::optional<Probe>& probe) {
  std::vector<NumberLine> lines;
  for (const auto& [name, value] : probe_numbers(probe.value_or(Probe{})))
    lines.push_back({name, probe ? value : absent, "Of the texel that the mouse points at, in the eye, world or map view."});
  return lines;
}

std::string decisions_text(const ConvexBody& b) {
  return std::to_string(b.vertices.size()) + " vertices, " + std::to_string(b.facets.size()) + " facets.";
}

/// "0 of 83": of the signs that made the body, those that needed exact arithmetic or what planes are known to share.
std::string exact_count(const ConvexBody& b) {
  const int beyond = b.decisions.exact + b.decisions.shared;
  return std::to_string(beyond) + " of " + std::to_string(beyond + b.decisions.filtered);
}

/// `second`: what stands in a column of its own; empty, or one for each line.
void draw_lines(const std::vector<NumberLine>& lines, const std::vector<NumberLine>& second = {}) {
  const bool both = !second.empty();
  if (!ImGui::BeginTable(both ? "numbers of both" : "numbers", both ? 3 : 2, ImGuiTableFlags_RowBg)) return;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(lines[i].name.c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", lines[i].help.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(lines[i].value.c_str());
    if (!both) continue;
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(second[i].value.c_str());
  }
  ImGui::EndTable();
}

/// Under a line with the names of both where there are two.
void draw_numbers(const Analysis& first, const Analysis* second) {
  if (!second) return draw_lines(number_lines(first));
  std::vector<NumberLine> lines{{"", std::string("A: ") + display_name(first.technique_used), ""}};
  std::vector<NumberLine> others{{"", std::string("B: ") + display_name(second->technique_used), ""}};
  for (const NumberLine& line : number_lines(first)) lines.push_back(line);
  for (const NumberLine& line : number_lines(*second)) others.push_back(line);
  draw_lines(lines, others);
}

/// A menu of an enum's values; its places are "NAME" and "NAME=VALUE".
template <class Enum, std::size_t N>
void menu(UiContext& ui, const std::string& name, float width, const std::array<const char*, N>& labels, Enum& value) {
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), labels[std::size_t(value)]);
  note_place(ui, name);
  if (!open) return;
  for (std::size_t i = 0; i < N; ++i) {
    if (ImGui::Selectable(labels[i], std::size_t(value) == i)) value = Enum(i);
    note_place(ui, name + "=" + name_of(Enum(i)));
  }
  ImGui::EndCombo();
}

/// Which text the matrices are copied as, and the button that copies them.
void matrix_row(UiContext& ui, Settings& settings, Requests& requests) {
  constexpr std::array languages{"GLSL", "C++", "JSON"};                 // by MatrixLanguage
  constexpr std::array conventions{"OpenGL", "Direct3D", "Reversed z"};  // by ClipConvention
  const ImGuiStyle& style = ImGui::GetStyle();
  const float button = ImGui::CalcTextSize("Copy matrices").x + 2.0f * style.FramePadding.x;
  const float left = ImGui::GetContentRegionAvail().x - 2.0f * style.ItemSpacing.x - button;
  if (ImGui::Button("Copy matrices")) requests.action = Action::copy_matrices;
  note_place(ui, "matrices.copy");
  rest_tooltip("The matrices of this experiment as text (key M), in the clip space of the program that they go to.");
  ImGui::SameLine();
  menu(ui, "matrices.language", std::floor(0.42f * left), languages, settings.matrix_language);
  ImGui::SameLine();
  menu(ui, "matrices.convention", std::floor(0.58f * left), conventions, settings.clip_convention);
}

void draw_notes(const UiContext& ui, const std::vector<Note>& notes) {
  const glm::vec3 tone = warning_color(ui.theme);
  if (notes.empty()) ImGui::TextDisabled("none");
  for (const Note& note : notes) {
    ImGui::PushTextWrapPos(0.0f);
    std::string code = note.code;
    std::replace(code.begin(), code.end(), '_', ' ');  // so that it breaks between words
    ImGui::TextColored({tone.r, tone.g, tone.b, 1.0f}, "▶ %s", code.c_str());
    ImGui::TextUnformatted(note_text(note).c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
  }
}

}  // namespace

std::vector<NumberLine> number_lines(const Analysis& a) {
  return {
      {"θ", degrees_of(a.theta), "Angle between light and view that the technique used."},
      {"φ", degrees_of(a.phi), "Half opening angle of the frustum towards the light."},
      {"n", text_of(a.near), "Eye depth at which the receivers begin."},
      {"f", text_of(a.far), "Eye depth at which the receivers end."},
      {"ρ", text_of(a.rho), "Warp: ratio of the warp frustum's near and far distance; 1 is uniform."},
      {"λ", text_of(a.lambda), "Warp parameter, ρ / (1 − ρ); infinite is uniform."},
      {"F near", text_of(model_value(a, &ModelError::F_near)), "Error F of the 2D model at n."},
      {"F far", text_of(model_value(a, &ModelError::F_far)), "Error F of the 2D model at f."},
      {"F max", text_of(model_value(a, &ModelError::F_max)), "Largest F on the central line."},
      {"E max", text_of(model_value(a, &ModelError::E_max_line)), "Largest E = F sin θ on the central line."},
      {"E max, frustum", text_of(model_value(a, &ModelError::E_max_frustum)), "Largest E over the whole frustum."},
      {"storage factor", text_of(model_value(a, &ModelError::storage_factor)),
       "Largest error across times largest error along: texels needed per pixel."},
      {"w", shown_number(a.light_case.w, 5), "v·l or v·(l − e): its sign decides the light case."},
      {"κ", shown_number(a.light_case.kappa, 5), "The light's w after P V, by the length of its x, y, z."},
      {"volume of H", shown_number(a.caster_body.volume(), 5),
       "All casters: hull(V + l) ∩ S ∩ L. " + decisions_text(a.caster_body)},
      {"volume of R", shown_number(a.receivers_body.volume(), 5),
       "All receivers: V ∩ S ∩ L. " + decisions_text(a.receivers_body)},
      {"H decided exactly", exact_count(a.caster_body),
       "Signs that doubles with an error bound could not decide, of all signs that made H."},
      {"m, median", texel_value(a, &TexelStatistics::m_p50),
       "Largest extent of a texel in pixels, over the pixels that face the light: half are finer. A grid of them stands for all "
       "unless the eye view shows texels or the lesson speaks of them."},
      {"m, 95 %", texel_value(a, &TexelStatistics::m_p95), "The same: 95 of 100 points are finer."},
      {"m, largest", texel_value(a, &TexelStatistics::m_max), "The same: the coarsest."},
      {"m > 1", a.texels ? shown_number(100.0 * a.texels->undersampled_fraction, 3) + " %" : absent,
       "Undersampled: the part of these points whose texel is larger than a pixel."},
      {"camera shift", shown_number(a.camera_shift, 5), "How far the virtual camera stands back."},
  };
}

std::string note_text(const Note& note) {
  std::string text = note.text;
  if (note.value) text += " Value " + shown_number(*note.value, 5);
  if (note.limit) text += (note.value ? ", limit " : " Limit ") + shown_number(*note.limit, 5);
  if (note.value || note.limit) text += ".";
  return text;
}

std::vector<Note> all_notes(const Scene& scene, const Analysis& analysis) {
  std::vector<Note> notes = analysis.notes;
  for (const Note& note : scene.notes) {
    bool known = false;
    for (const Note& other : analysis.notes) known = known || other == note;
    if (!known) notes.push_back(note);
  }
  return notes;
}

void numbers_pane(UiContext& ui, const Analysis* second, const std::optional<Probe>& probe, Settings& settings,
                  Requests& requests, bool show_notes) {
  const auto notes = all_notes(ui.model.scene(), ui.model.analysis());
  const bool numbers_open = ImGui::CollapsingHeader("numbers", ImGuiTreeNodeFlags_DefaultOpen);
  note_place(ui, "numbers");
  if (numbers_open) draw_numbers(ui.model.analysis(), second);
  if (numbers_open) matrix_row(ui, settings, requests);
  const bool texel_open = ImGui::CollapsingHeader("texel under the mouse", ImGuiTreeNodeFlags_DefaultOpen);
  note_place(ui, "texel");
  if (texel_open) draw_lines(probe_lines(probe));
  if (show_notes) ImGui::SetNextItemOpen(true);
  const bool notes_open = ImGui::CollapsingHeader("notes", ImGuiTreeNodeFlags_DefaultOpen);
  if (show_notes) ImGui::SetScrollHereY(0.0f);
  note_place(ui, "notes");
  if (notes_open) draw_notes(ui, notes);
}

}  // namespace psm
