// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile_panel.h"

#include <imgui.h>

#include <chrono>
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

/// The last two columns, from the right.
void times_of_row(const std::string& cpu, const std::string& gpu) {
  const float right = ImGui::GetContentRegionMax().x, column = ImGui::CalcTextSize("CPU ms").x + 0.7f * ImGui::GetFontSize();
  const auto put = [&](const std::string& text, float end) {
    ImGui::SameLine(end - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextUnformatted(text.c_str());
  };
  put(cpu, right - column);
  put(gpu, right);
}

void stage_rows(const Profile& profile) {
  ImGui::TextDisabled("stage");
  times_of_row("CPU ms", "GPU ms");
  for (std::size_t i = 0; i < kStages; ++i) {
    const StageRun& run = profile.busy()[i];
    if (run.ran) {
      ImGui::TextUnformatted(name_of(Stage(i)));
      times_of_row(milliseconds(run.cpu_ms), milliseconds(profile.gpu_ms(Stage(i))));
    } else {
      ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
      ImGui::TextWrapped("%s: not run, %s", name_of(Stage(i)), run.why.c_str());
      ImGui::PopStyleColor();
    }
  }
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

void ProfilePanel::update_gain(const Model& model, Profile& profile) {
  const auto start = std::chrono::steady_clock::now();
  gain_ = fit_gain(model);
  profile.ran(Stage::gain, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
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
  stage_rows(profile);
  ImGui::Spacing();
  if (gain_of_ != ui.model.analysis_revision()) update_gain(ui.model, profile);
  gain_of_ = ui.model.analysis_revision();
  points_text(ui.model, readback, gain_);
}

}  // namespace psm
