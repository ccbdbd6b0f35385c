// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/badge_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/control_pane.h"
#include "ui/numbers_pane.h"
#include "ui/theme.h"

namespace psm {
namespace {

Badge light_badge(const Analysis& a) {
  const bool directional = a.light_case.post == PostLight::directional || a.light_case.within_half_texel;
  BadgeShape shape = directional ? BadgeShape::parallels : BadgeShape::disc;
  if (!directional && a.light_case.post == PostLight::inverted_point) shape = BadgeShape::ring;
  return {shape, light_case_text(a), "What the eye's projection makes of the light, and the number that decides.",
          role_color(Role::light), "badge.light"};
}

Badge notes_badge(const Model& model, Theme theme) {
  const std::size_t count = all_notes(model.scene(), model.analysis()).size();
  const std::string text = count == 0 ? "no notes" : std::to_string(count) + (count == 1 ? " note" : " notes");
  return {count == 0 ? BadgeShape::none : BadgeShape::square, text,
          "Fallbacks, clamps and limits. A click shows them in the control pane.", warning_color(theme), "badge.notes"};
}

std::string milliseconds(double ms) {
  char text[32];
  std::snprintf(text, sizeof text, ms < 10.0 ? "%.1f ms" : "%.0f ms", ms);
  return text;
}

void draw_shape(BadgeShape shape, ImVec2 c, float r, Color fill, Color edge, float line) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  switch (shape) {
    case BadgeShape::none:
      break;
    case BadgeShape::disc:
      list->AddCircleFilled(c, r, fill, 24);
      list->AddCircle(c, r, edge, 24, line);
      break;
    case BadgeShape::ring:
      list->AddCircle(c, r * 0.8f, fill, 24, r * 0.5f);
      list->AddCircle(c, r, edge, 24, line);
      list->AddCircle(c, r * 0.55f, edge, 24, line);
      break;
    case BadgeShape::parallels:
      for (int i = -1; i <= 1; ++i) {
        const float x = c.x + 0.7f * r * float(i);
        list->AddLine({x - 0.3f * r, c.y + r}, {x + 0.3f * r, c.y - r}, edge, line * 2.6f);
        list->AddLine({x - 0.3f * r, c.y + r}, {x + 0.3f * r, c.y - r}, fill, line * 1.4f);
      }
      break;
    case BadgeShape::triangle:
      list->AddTriangleFilled({c.x, c.y - r}, {c.x - r, c.y + 0.8f * r}, {c.x + r, c.y + 0.8f * r}, fill);
      break;
    case BadgeShape::square:
      list->AddRectFilled({c.x - 0.8f * r, c.y - 0.8f * r}, {c.x + 0.8f * r, c.y + 0.8f * r}, fill);
      break;
  }
}

float shape_width(const Badge& badge) { return badge.shape == BadgeShape::none ? 0.0f : 1.2f * ImGui::GetFontSize(); }
float badge_width(const Badge& b) { return ImGui::CalcTextSize(b.text.c_str()).x + shape_width(b) + ImGui::GetFontSize(); }
float line_height() { return std::floor(1.75f * ImGui::GetFontSize()); }
float gap() { return std::floor(0.35f * ImGui::GetFontSize()); }

/// Top left corners, line after line, relative to the bar. Where there are two lines the second begins with the times, so that
/// it is not empty when all would fit into the first.
std::vector<ImVec2> badge_corners(const std::vector<Badge>& badges, float width, bool two_lines) {
  std::vector<ImVec2> corners;
  float x = gap(), y = 0.0f;
  for (const Badge& badge : badges) {
    const float needed = badge_width(badge);
    const bool full = x > gap() && x + needed + gap() > width, begins = two_lines && y == 0.0f && badge.name == "badge.time";
    if (full || begins) x = gap(), y += line_height();
    corners.push_back({x, y});
    x += needed + gap();
  }
  return corners;
}

bool draw_badge(UiContext& ui, const Badge& badge, ImVec2 at) {
  const float em = ImGui::GetFontSize(), y = at.y + 0.5f * gap(), height = line_height() - gap();
  const ImVec2 end{at.x + badge_width(badge), y + height};
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, end, ImGui::GetColorU32(ImGuiCol_FrameBg), 0.3f * em);
  draw_shape(badge.shape, {at.x + 0.9f * em, y + 0.5f * (line_height() - gap())}, 0.42f * em, color(badge.tone), text_color(0.85),
             std::max(1.0f, em / 14.0f));
  const ImVec2 text_at{at.x + 0.5f * em + shape_width(badge), std::floor(y + 0.5f * (line_height() - gap() - em))};
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), em, text_at, text_color(), badge.text.c_str());
  ImGui::SetCursorScreenPos({at.x, y});
  const bool clicked = ImGui::InvisibleButton(badge.name.c_str(), {std::max(1.0f, end.x - at.x), height});
  focus_ring();
  note_place(ui, badge.name);
  rest_tooltip(badge.help.empty() ? badge.text : badge.help);
  return clicked;
}

}  // namespace

std::vector<Badge> badges(const Model& model, double views_ms, const std::string& message, Theme theme) {
  const Analysis& a = model.analysis();
  std::vector<Badge> out = {light_badge(a)};
  out.push_back(
      {BadgeShape::none, display_name(a.technique_used), "The technique that made the shadow map.", {}, "badge.technique"});
  if (a.worse_than_uniform)
    out.push_back({BadgeShape::triangle, "worse than uniform", "The uniform map has the smaller largest error here.",
                   warning_color(theme), "badge.worse"});
  out.push_back(notes_badge(model, theme));
  out.push_back({BadgeShape::none,
                 "analysis " + milliseconds(model.points_ms() + model.analysis_ms()) + ", views " + milliseconds(views_ms),
                 "Time on the processor for the last analysis, and for the views that were drawn last.",
                 {},
                 "badge.time"});
  if (!message.empty()) out.push_back({BadgeShape::none, message, message, {}, "badge.message"});
  return out;
}

int badge_line_height() { return int(line_height()); }

// Not by what the badges say now: the views must not change their size while one drags.
int badge_bar_height(int width) {
  const int lines = float(width) < 80.0f * ImGui::GetFontSize() ? 2 : 1;
  return lines * int(line_height());
}

std::string badge_bar(UiContext& ui, const std::vector<Badge>& badges, const Rect& bar) {
  constexpr float least = 0.25f;    // what is left in a window of a few pixels: ImGui takes neither type nor buttons of size zero
  ImGui::SetWindowFontScale(1.0f);  // ImGui keeps it from frame to frame
  if (badges.size() == 1)
    ImGui::SetWindowFontScale(
        std::clamp(std::min((float(bar.size().x) - 2.0f * gap()) / badge_width(badges[0]), float(bar.size().y) / line_height()),
                   least, 1.0f));
  const auto corners = badge_corners(badges, float(bar.size().x), float(bar.size().y) > 1.5f * line_height());
  std::string clicked;
  for (std::size_t i = 0; i < badges.size() && corners[i].y + line_height() <= float(bar.size().y) + 1.0f; ++i)
    if (draw_badge(ui, badges[i], {float(bar.min.x) + corners[i].x, float(bar.min.y) + corners[i].y})) clicked = badges[i].name;
  return clicked;
}

}  // namespace psm
