// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "draw/font_face.h"

namespace psm {
namespace {

/// kTextRanges as ImGui takes them; all are in DejaVu Sans.
const std::vector<ImWchar>& glyph_ranges() {
  static const std::vector<ImWchar> list = [] {
    std::vector<ImWchar> out;
    for (const auto& range : kTextRanges) out.insert(out.end(), {ImWchar(range[0]), ImWchar(range[1])});
    out.push_back(0);
    return out;
  }();
  return list;
}

/// Code needs no more than this.
const ImWchar code_ranges[] = {0x0020, 0x007E, 0x00A0, 0x00FF, 0x0370, 0x03FF, 0};

// Of headings, which are the largest bold text; strong words are drawn smaller from the same glyphs.
constexpr double bold_scale = 1.25;

glm::vec3 hex(unsigned rgb) { return glm::vec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0f; }
ImVec4 vec4(const glm::vec3& c, float alpha = 1.0f) { return {c.r, c.g, c.b, alpha}; }

/// The few tones that a theme is made of.
struct Tones {
  glm::vec3 ground, pane, field, field_hovered, line, text, faint, accent, on_accent;
};

Tones tones(Theme theme) {
  if (theme == Theme::dark)
    return {hex(0x141414), hex(0x1E1E1E), hex(0x343434), hex(0x444444), hex(0x808080),
            hex(0xF2F2F2), hex(0xB0B0B0), hex(0x56B4E9), hex(0x101010)};
  return {hex(0xDADADA), hex(0xFAFAFA), hex(0xE6E6E6), hex(0xD8E6F0), hex(0x8A8A8A),
          hex(0x161616), hex(0x5A5A5A), hex(0x0072B2), hex(0xFFFFFF)};
}

void set_surfaces(ImVec4* colors, const Tones& t) {
  colors[ImGuiCol_Text] = vec4(t.text);
  colors[ImGuiCol_TextDisabled] = vec4(t.faint);
  colors[ImGuiCol_WindowBg] = vec4(t.pane);
  colors[ImGuiCol_ChildBg] = vec4(t.pane);
  colors[ImGuiCol_PopupBg] = vec4(t.pane);
  colors[ImGuiCol_Border] = vec4(t.line);
  colors[ImGuiCol_BorderShadow] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = colors[ImGuiCol_TitleBgCollapsed] = vec4(t.field);
  colors[ImGuiCol_MenuBarBg] = vec4(t.field);
  colors[ImGuiCol_Separator] = vec4(t.line, 0.6f);
  colors[ImGuiCol_SeparatorHovered] = colors[ImGuiCol_SeparatorActive] = vec4(t.accent);
  colors[ImGuiCol_TableHeaderBg] = vec4(t.field);
  colors[ImGuiCol_TableBorderStrong] = colors[ImGuiCol_TableBorderLight] = vec4(t.line, 0.5f);
  colors[ImGuiCol_TableRowBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_TableRowBgAlt] = vec4(t.field, 0.5f);
  colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.35f);
}

void set_controls(ImVec4* colors, const Tones& t) {
  colors[ImGuiCol_FrameBg] = vec4(t.field);
  colors[ImGuiCol_FrameBgHovered] = vec4(t.field_hovered);
  colors[ImGuiCol_FrameBgActive] = vec4(t.field_hovered);
  colors[ImGuiCol_Button] = vec4(t.field);
  colors[ImGuiCol_ButtonHovered] = vec4(t.field_hovered);
  colors[ImGuiCol_ButtonActive] = vec4(t.accent, 0.5f);
  colors[ImGuiCol_Header] = vec4(t.accent, 0.20f);
  colors[ImGuiCol_HeaderHovered] = vec4(t.accent, 0.30f);
  colors[ImGuiCol_HeaderActive] = vec4(t.accent, 0.45f);
  colors[ImGuiCol_SliderGrab] = colors[ImGuiCol_SliderGrabActive] = vec4(t.accent);
  colors[ImGuiCol_CheckMark] = vec4(t.accent);
  colors[ImGuiCol_ScrollbarBg] = vec4(t.pane);
  colors[ImGuiCol_ScrollbarGrab] = vec4(t.line);
  colors[ImGuiCol_ScrollbarGrabHovered] = colors[ImGuiCol_ScrollbarGrabActive] = vec4(t.accent);
  colors[ImGuiCol_TextSelectedBg] = vec4(t.accent, 0.35f);
  colors[ImGuiCol_NavHighlight] = vec4(t.accent);
  colors[ImGuiCol_ResizeGrip] = colors[ImGuiCol_ResizeGripHovered] = colors[ImGuiCol_ResizeGripActive] = vec4(t.accent, 0.5f);
}

void set_spacing(ImGuiStyle& style) {
  style.WindowPadding = {12, 12};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 6};
  style.CellPadding = {4, 3};
  style.FrameRounding = style.ChildRounding = style.PopupRounding = style.GrabRounding = style.WindowRounding = 4;
  style.GrabMinSize = style.ScrollbarSize = 16;
  style.WindowBorderSize = style.PopupBorderSize = 1;
  style.ChildBorderSize = 0;
  style.FrameBorderSize = 1;  // fields and buttons stand out from the pane by 3:1
}

}  // namespace

void apply_look(const LookKey& look, const std::filesystem::path& font) {
  ImGuiStyle style;  // fresh: ScaleAllSizes accumulates
  set_spacing(style);
  style.ScaleAllSizes(float(look.scale));
  style.FrameBorderSize = style.PopupBorderSize = float(std::max(1.0, std::floor(look.scale)));
  const Tones t = tones(look.theme);
  set_surfaces(style.Colors, t);
  set_controls(style.Colors, t);
  ImGui::GetStyle() = style;

  ImGuiIO& io = ImGui::GetIO();
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  io.Fonts->Clear();
  // The default's 1024 would make a tower at large sizes that old cards refuse.
  io.Fonts->TexDesiredWidth = look.font_px > 30 ? 4096 : 2048;
  const auto add = [&](const char* file, double size, const ImWchar* ranges) {
    const std::filesystem::path path = font.parent_path() / file;
    return io.Fonts->AddFontFromFileTTF(path.c_str(), float(std::round(size)), &config, ranges);
  };
  io.FontDefault = io.Fonts->AddFontFromFileTTF(font.c_str(), float(look.font_px), &config, glyph_ranges().data());
  add("DejaVuSans-Bold.ttf", bold_scale * look.font_px, glyph_ranges().data());
  add("DejaVuSansMono.ttf", 0.92 * look.font_px, code_ranges);
  io.Fonts->Build();
}

ImFont* face_font(Face face) {
  const auto& fonts = ImGui::GetIO().Fonts->Fonts;
  return fonts[std::min(int(face), fonts.Size - 1)];
}

Color color(const glm::vec3& srgb, double alpha) {
  return ImGui::ColorConvertFloat4ToU32(vec4(glm::clamp(srgb, 0.0f, 1.0f), float(alpha)));
}

Color text_color(double alpha) { return ImGui::GetColorU32(ImGuiCol_Text, float(alpha)); }

Color line_color(Role role, Theme theme) { return color(theme == Theme::dark ? role_color(role) : role_line_color(role)); }

glm::vec3 ground_color(Theme theme) { return tones(theme).ground; }
glm::vec3 accent_color(Theme theme) { return tones(theme).accent; }
glm::vec3 warning_color(Theme theme) { return theme == Theme::dark ? hex(0xFF9A4D) : hex(0xA83F00); }

}  // namespace psm
