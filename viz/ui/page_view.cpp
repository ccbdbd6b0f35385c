// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "draw/utf8.h"
#include "ui/theme.h"

namespace psm {
namespace {

constexpr float lean = 0.2f;  // of oblique type, as in DejaVu Sans Oblique

float scale_of(const ImFont* font, const Type& type) { return float(type.size) / font->FontSize; }

double width_of(const std::string& text, const Type& type) {
  const ImFont* font = face_font(type.face);
  float width = 0.0f;
  for (const char32_t point : decode_utf8(text)) width += font->GetCharAdvance(ImWchar(point));
  return width * scale_of(font, type);
}

Reach reach_of(const std::string& text, const Type& type) {
  const ImFont* font = face_font(type.face);
  float above = 0.0f, below = 0.0f;
  for (const char32_t point : decode_utf8(text)) {
    const ImFontGlyph* glyph = font->FindGlyph(ImWchar(point));
    if (!glyph || !glyph->Visible) continue;
    above = std::max(above, font->Ascent - glyph->Y0), below = std::max(below, glyph->Y1 - font->Ascent);
  }
  return {above * scale_of(font, type), below * scale_of(font, type)};
}

Color ink_color(Ink ink, Theme theme) {
  switch (ink) {
    case Ink::text:
      return text_color();
    case Ink::faint:
      return ImGui::GetColorU32(ImGuiCol_TextDisabled);
    case Ink::link:
      return color(accent_color(theme));
    case Ink::live:
      return color(warning_color(theme));
    case Ink::code:
      return ImGui::GetColorU32(ImGuiCol_TextDisabled);
  }
  return 0;
}

/// What a click does.
std::string link_tip(const std::string& target) {
  if (target.starts_with("https:")) return target + "\nClick: copies the address.";
  if (target.starts_with("lesson:")) return "Opens lesson " + target.substr(7);
  if (target.starts_with("set:")) return "Sets " + target.substr(4);
  return target;
}

void draw_run(const GlyphRun& run, const ImVec2& origin, Theme theme) {
  ImFont* font = face_font(run.type.face);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float scale = scale_of(font, run.type);
  float pen = origin.x + float(run.baseline.x);
  const float baseline = std::round(origin.y + float(run.baseline.y));
  if (!run.type.oblique) pen = std::round(pen);
  const Color ink = ink_color(run.ink, theme);
  for (const char32_t point : decode_utf8(run.text)) {
    const ImFontGlyph* glyph = font->FindGlyph(ImWchar(point));
    if (!glyph) continue;
    if (glyph->Visible) {
      const float left = pen + glyph->X0 * scale, right = pen + glyph->X1 * scale;
      const float top = (glyph->Y0 - font->Ascent) * scale, bottom = (glyph->Y1 - font->Ascent) * scale;
      const float at_top = run.type.oblique ? -lean * top : 0.0f, at_bottom = run.type.oblique ? -lean * bottom : 0.0f;
      list->PrimReserve(6, 4);
      list->PrimQuadUV({left + at_top, baseline + top}, {right + at_top, baseline + top}, {right + at_bottom, baseline + bottom},
                       {left + at_bottom, baseline + bottom}, {glyph->U0, glyph->V0}, {glyph->U1, glyph->V0},
                       {glyph->U1, glyph->V1}, {glyph->U0, glyph->V1}, ink);
    }
    pen += glyph->AdvanceX * scale;
  }
}

void draw_ink(const TypesetBox& box, const ImVec2& origin, Theme theme) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float top = list->GetClipRectMin().y, bottom = list->GetClipRectMax().y;
  for (const GlyphRun& run : box.runs) {
    const float y = origin.y + float(run.baseline.y), size = 2.0f * float(run.type.size);
    if (y + size > top && y - size < bottom) draw_run(run, origin, theme);
  }
  for (const Rule& rule : box.rules) {
    const ImVec2 min(origin.x + float(rule.min.x), std::round(origin.y + float(rule.min.y)));
    const float height = std::max(1.0f, std::round(float(rule.max.y - rule.min.y)));
    list->AddRectFilled(min, {origin.x + float(rule.max.x), min.y + height}, ink_color(rule.ink, theme));
  }
  for (const TextStroke& stroke : box.strokes) {
    std::vector<ImVec2> points;
    for (const glm::dvec2& p : stroke.points) points.push_back({origin.x + float(p.x), origin.y + float(p.y)});
    list->AddPolyline(points.data(), int(points.size()), ink_color(stroke.ink, theme), 0, float(stroke.width));
  }
}

}  // namespace

FontMetrics screen_metrics() { return {width_of, reach_of}; }

std::string show_page(UiContext& ui, const TextPage& page, const std::string& name) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  std::string clicked;
  ImGui::PushID(name.c_str());
  for (std::size_t i = 0; i < page.links.size(); ++i) {
    const LinkArea& link = page.links[i];
    ImGui::SetCursorScreenPos({origin.x + float(link.min.x), origin.y + float(link.min.y)});
    ImGui::PushID(int(i));
    if (ImGui::InvisibleButton("link", {float(link.max.x - link.min.x), float(link.max.y - link.min.y)})) clicked = link.target;
    ImGui::PopID();
    focus_ring();
    note_place(ui, name + ".link." + std::to_string(i));
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    rest_tooltip(link_tip(link.target));
    const float line = std::round(origin.y + float(link.max.y) - 0.1f * float(link.max.y - link.min.y));
    ImGui::GetWindowDrawList()->AddLine({origin.x + float(link.min.x), line}, {origin.x + float(link.max.x), line},
                                        ink_color(Ink::link, ui.theme));
  }
  ImGui::PopID();
  draw_ink(page.ink, origin, ui.theme);
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({float(page.ink.width), float(std::ceil(page.height))});
  return clicked;
}

}  // namespace psm
