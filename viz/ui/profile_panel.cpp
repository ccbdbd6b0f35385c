// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "scene/eye_and_light.h"
#include "scene/texel_sampling.h"
#include "scene/visible_receivers.h"

namespace psm {
namespace {

std::string milliseconds(std::optional<double> ms) {
  char text[32] = "—";
  if (ms) std::snprintf(text, sizeof text, *ms < 9.995 ? "%.2f" : "%.1f", *ms);
  return text;
}

/// With this fit; over the same points whichever it is.
std::optional<double> texel_size(const Model& model, Focus focus, NearFit near_fit, std::span<const SurfacePoint> points) {
  Experiment x = model.experiment();
  if (x.shadow.near_fit == NearFit::off) near_fit = NearFit::off;
  x.shadow.focus = focus, x.shadow.near_fit = near_fit;
  const Analysis a = analyze(x, model.scene(), model.visible_points());
  if (!a.map_from_world) return std::nullopt;
  return texel_percentile(points, *a.map_from_world, a, 0.95);
}

void right_aligned(const std::string& text) {
  const float spare = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, spare));
  ImGui::TextUnformatted(text.c_str());
}

/// Name and, where it did not run, the reason under it; the times, or dashes.
void stage_row(const Profile& profile, Stage stage) {
  const StageRun& run = profile.busy()[std::size_t(stage)];
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (run.ran)
    ImGui::TextUnformatted(name_of(stage));
  else
    ImGui::TextDisabled("%s", name_of(stage));
  if (!run.ran) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("skipped: %s", run.why.c_str());
    ImGui::PopStyleColor();
  }
  ImGui::TableNextColumn();
  right_aligned(run.ran ? milliseconds(run.cpu_ms) : "—");
  ImGui::TableNextColumn();
  right_aligned(run.ran ? milliseconds(profile.gpu_ms(stage)) : "—");
}

void stage_table(const Profile& profile) {
  if (!ImGui::BeginTable("profile", 3, ImGuiTableFlags_RowBg)) return;
  const float column = ImGui::CalcTextSize("00.00 ms").x;
  ImGui::TableSetupColumn("stage", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("CPU ms", ImGuiTableColumnFlags_WidthFixed, column);
  ImGui::TableSetupColumn("GPU ms", ImGuiTableColumnFlags_WidthFixed, column);
  ImGui::TableHeadersRow();
  for (std::size_t i = 0; i < kStages; ++i) stage_row(profile, Stage(i));
  ImGui::EndTable();
}

void points_text(const Model& model, const DepthReadback& readback, const std::optional<FitGain>& gain) {
  const std::string count = std::to_string(model.visible_points().size());
  if (model.points_source() == PointsSource::rays)
    ImGui::TextWrapped("%s visible points from rays, in the frame that needs them.", count.c_str());
  else if (readback.delay())
    ImGui::TextWrapped("%s visible points from depth readback, %d frame(s) late; no frame waits.", count.c_str(),
                       *readback.delay());
  if (!gain) return;
  ImGui::TextWrapped("Depths: %s to %s by bounds, %s to %s visible.", shown_number(gain->bounds.min).c_str(),
                     shown_number(gain->bounds.max).c_str(), shown_number(gain->visible.min).c_str(),
                     shown_number(gain->visible.max).c_str());
  if (gain->m_bounds && gain->m_visible)
    ImGui::TextWrapped("95th percentile of m: %s fitted to bounds, %s to what is visible.",
                       shown_number(*gain->m_bounds, 3).c_str(), shown_number(*gain->m_visible, 3).c_str());
}

}  // namespace

std::optional<FitGain> fit_gain(const Model& model) {
  const Analysis& a = model.analysis();
  const std::vector<SurfacePoint> served = points_to_serve(model.visible_points(), a.light, a.receivers_body);
  if (served.empty() || model.points_sight() != model.sight()) return std::nullopt;
  const ViewFrame view = camera_frame(model.experiment());
  FitGain gain;
  for (const glm::dvec3& v : a.receivers_body.vertices) gain.bounds.add(view.depth(v));
  for (const SurfacePoint& p : served) gain.visible.add(view.depth(p.position));
  gain.m_bounds = texel_size(model, Focus::bounds, NearFit::bounds, served);
  gain.m_visible = texel_size(model, Focus::visible, NearFit::depth, served);
  return gain;
}

void ProfilePanel::draw(UiContext& ui, Profile& profile, const DepthReadback& readback, std::optional<bool> show) {
  if (show) ImGui::SetNextItemOpen(*show);
  const bool open = ImGui::CollapsingHeader("profile");
  if (show && *show) ImGui::SetScrollHereY(0.0f);
  note_place(ui, "profile");
  profile.watch(open);
  if (!open) return;
  const std::uint64_t since = profile.frames_since_busy();
  if (since == 0)
    ImGui::TextWrapped("The last frame:");
  else
    ImGui::TextWrapped("The last frame that computed anything; the %llu since then only drew the interface:",
                       static_cast<unsigned long long>(since));
  stage_table(profile);
  if (gain_of_ != ui.model.analysis_revision()) profile.run(Stage::gain, [&] { gain_ = fit_gain(ui.model); });
  gain_of_ = ui.model.analysis_revision();
  points_text(ui.model, readback, gain_);
}

}  // namespace psm
