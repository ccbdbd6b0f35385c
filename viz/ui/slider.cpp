// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

constexpr double snap_pixels = 6.0;

/// The stretch of pixels that the middle of the grab can reach.
struct Track {
  ImRect frame;
  float grab = 0.0f;
  double left() const { return frame.Min.x + 2.0 + 0.5 * grab; }
  double width() const { return std::max(1.0, double(frame.GetWidth()) - 4.0 - grab); }
  double x(double place) const { return left() + place * width(); }
  double place(double x) const { return std::clamp((x - left()) / width(), 0.0, 1.0); }
};

Track track_of(const ImRect& frame) {
  return {frame, std::min(ImGui::GetStyle().GrabMinSize * 0.7f, std::max(1.0f, frame.GetWidth() - 4.0f))};
}

constexpr ImGuiKey step_keys[] = {ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_PageUp,
                                  ImGuiKey_PageDown,  ImGuiKey_Home,       ImGuiKey_End};

bool any_step_key_down() {
  return std::any_of(std::begin(step_keys), std::end(step_keys),
                     [](ImGuiKey k) { return ImGui::IsKeyDown(ImGui::GetKeyIndex(k)); });
}

/// Focus is enough for the keys that step, which would lead to another widget otherwise. It is taken while one is held: one
/// entry in the history.
void take_by_keys(ImGuiID id) {
  ImGuiContext& g = *GImGui;
  if (g.ActiveId != 0 || g.NavId != id || g.NavWindow != g.CurrentWindow || g.IO.KeyCtrl || !any_step_key_down()) return;
  ImGui::SetActiveID(id, g.CurrentWindow);
  g.ActiveIdSource = ImGuiInputSource_Nav;
  g.ActiveIdUsingNavDirMask |= (1 << ImGuiDir_Left) | (1 << ImGuiDir_Right);
  for (ImGuiKey k : step_keys) g.ActiveIdUsingKeyInputMask |= ImU64(1) << k;
  ImGui::NavMoveRequestCancel();
}

/// A click or Enter takes the slider; with Ctrl, Tab or Enter on the focused one it becomes a text field. True: text.
bool activate(ImGuiID id, bool hovered) {
  ImGuiContext& g = *GImGui;
  ImGuiWindow* window = g.CurrentWindow;
  const bool tabbed = (g.LastItemData.StatusFlags & ImGuiItemStatusFlags_FocusedByTabbing) != 0;
  const bool clicked = hovered && g.IO.MouseClicked[0];
  if (!tabbed && !clicked && g.NavActivateId != id && g.NavActivateInputId != id) return false;
  ImGui::SetActiveID(id, window);
  ImGui::SetFocusID(id, window);
  ImGui::FocusWindow(window);
  g.ActiveIdUsingNavDirMask |= (1 << ImGuiDir_Left) | (1 << ImGuiDir_Right);
  return tabbed || (clicked && (g.IO.KeyCtrl || g.IO.MouseDoubleClicked[0])) || g.NavActivateInputId == id;
}

/// The grab keeps the place at which it was taken; a press beside it brings its middle there.
double drag(const Track& track, const SliderRange& range, double value, std::span<const Tick> ticks) {
  ImGuiContext& g = *GImGui;
  if (!g.IO.MouseDown[0]) {
    ImGui::ClearActiveID();
    return value;
  }
  const double mouse = g.IO.MousePos.x;
  if (g.IO.MouseClicked[0]) {
    const double off = mouse - track.x(slider_place(range, value));
    const bool on_grab = std::abs(off) <= 0.5 * track.grab;
    g.ActiveIdClickOffset.x = on_grab ? float(off) : 0.0f;
    if (on_grab) return value;
  } else if (g.IO.MouseDragMaxDistanceSqr[0] == 0.0f) {
    return value;  // a click to focus must not change the value, not even by rounding
  }
  const double wanted = slider_value(range, track.place(mouse - g.ActiveIdClickOffset.x));
  if (g.IO.KeyAlt) return wanted;
  return snapped(range, wanted, ticks, snap_pixels / track.width());
}

double step_by_keys(const SliderRange& range, double value) {
  if (!any_step_key_down()) {
    ImGui::ClearActiveID();
    return value;
  }
  const auto pressed = [](ImGuiKey k) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(k)); };
  if (pressed(ImGuiKey_Home)) return range.min;
  if (pressed(ImGuiKey_End)) return range.max;
  double step = 0.0;
  if (pressed(ImGuiKey_RightArrow)) step += 0.01;
  if (pressed(ImGuiKey_LeftArrow)) step -= 0.01;
  if (pressed(ImGuiKey_PageUp)) step += 0.1;
  if (pressed(ImGuiKey_PageDown)) step -= 0.1;
  if (step == 0.0) return value;
  const double next = slider_value(range, slider_place(range, value) + step);
  return range.whole && next == value ? value + (step > 0 ? range.step : -range.step) : next;
}

void draw_ticks(const Track& track, const SliderRange& range, std::span<const Tick> ticks, Theme theme) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float thick = std::max(1.0f, std::floor(ImGui::GetFontSize() / 9.0f)), small = 0.72f * ImGui::GetFontSize();
  for (const Tick& tick : ticks) {
    if (tick.value < range.min || tick.value > range.max) continue;
    const float x = std::floor(float(track.x(slider_place(range, tick.value))));
    const float top = tick.label.empty() ? track.frame.Max.y - 0.3f * track.frame.GetHeight() : track.frame.Min.y - 0.15f * small;
    list->AddLine({x, top}, {x, track.frame.Max.y}, line_color(tick.role, theme), thick);
    if (tick.label.empty()) continue;
    const float width = ImGui::GetFont()->CalcTextSizeA(small, FLT_MAX, 0.0f, tick.label.c_str()).x;
    const float left = std::clamp(x - 0.5f * width, track.frame.Min.x, std::max(track.frame.Min.x, track.frame.Max.x - width));
    list->AddText(ImGui::GetFont(), small, {left, track.frame.Min.y - 1.15f * small}, text_color(), tick.label.c_str());
  }
}

/// Where the number stands: in the middle, or at an end where the grab or a labelled mark would cross it.
float text_left(const Track& track, const SliderRange& range, double value, std::span<const Tick> ticks, float width) {
  const float pad = ImGui::GetStyle().FramePadding.x, half = 0.5f * track.grab;
  const auto crosses = [&](double what, float left) {
    const float x = float(track.x(slider_place(range, what)));
    return x + half + 0.5f * pad > left && x - half - 0.5f * pad < left + width;
  };
  const float middle = track.frame.GetCenter().x - 0.5f * width;
  const float places[] = {middle, track.frame.Max.x - pad - width, track.frame.Min.x + pad};
  for (float left : places) {
    bool free = !crosses(value, left);
    for (const Tick& tick : ticks) free = free && (tick.label.empty() || !crosses(tick.value, left));
    if (free) return left;
  }
  return slider_place(range, value) > 0.5 ? places[2] : places[1];
}

void draw_slider(ImGuiID id, const Track& track, const SliderRange& range, double value, std::span<const Tick> ticks,
                 const std::string& text, bool hovered) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const bool hot = GImGui->ActiveId == id || hovered;
  ImGui::RenderNavHighlight(track.frame, id);
  ImGui::RenderFrame(track.frame.Min, track.frame.Max, ImGui::GetColorU32(hot ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), true,
                     style.FrameRounding);
  const float x = float(track.x(slider_place(range, value))), half = 0.5f * track.grab;
  ImGui::GetWindowDrawList()->AddRectFilled({x - half, track.frame.Min.y + 2.0f}, {x + half, track.frame.Max.y - 2.0f},
                                            ImGui::GetColorU32(ImGuiCol_SliderGrab), style.GrabRounding);
  const float left = text_left(track, range, value, ticks, ImGui::CalcTextSize(text.c_str()).x);
  ImGui::RenderTextClipped({left, track.frame.Min.y}, track.frame.Max, text.c_str(), nullptr, nullptr, {0.0f, 0.5f});
}

}  // namespace

double slider_place(const SliderRange& r, double value) {
  const double v = std::clamp(value, r.min, r.max);
  if (!(r.max > r.min)) return 0.0;
  return r.logarithmic ? std::log(v / r.min) / std::log(r.max / r.min) : (v - r.min) / (r.max - r.min);
}

double slider_value(const SliderRange& r, double place) {
  if (place <= 0.0) return r.min;
  if (place >= 1.0) return r.max;
  const double value = r.logarithmic ? r.min * std::pow(r.max / r.min, place) : r.min + place * (r.max - r.min);
  return r.whole ? r.min + r.step * std::round((value - r.min) / r.step) : value;
}

double snapped(const SliderRange& range, double value, std::span<const Tick> ticks, double reach) {
  double best = value, nearest = reach;
  for (const Tick& tick : ticks) {
    if (tick.value < range.min || tick.value > range.max) continue;
    const double distance = std::abs(slider_place(range, tick.value) - slider_place(range, value));
    if (distance <= nearest) best = tick.value, nearest = distance;
  }
  return best;
}

float tick_label_height(std::span<const Tick> ticks) {
  const bool any = std::any_of(ticks.begin(), ticks.end(), [](const Tick& t) { return !t.label.empty(); });
  return any ? std::floor(0.72f * 1.15f * ImGui::GetFontSize()) : 0.0f;
}

bool ticked_slider(const char* label, double& value, const SliderRange& range, std::span<const Tick> ticks,
                   const std::string& text, Theme theme) {
  ImGuiContext& g = *GImGui;
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (window->SkipItems) return false;
  const ImGuiID id = window->GetID(label);
  const ImVec2 at = window->DC.CursorPos;
  const ImRect frame(at, {at.x + std::max(8.0f, ImGui::CalcItemWidth()), at.y + ImGui::GetFrameHeight()});
  ImGui::ItemSize(frame, g.Style.FramePadding.y);
  if (!ImGui::ItemAdd(frame, id, &frame, ImGuiItemFlags_Inputable)) return false;
  const bool hovered = ImGui::ItemHoverable(frame, id);
  if (ImGui::TempInputIsActive(id) || activate(id, hovered))
    return ImGui::TempInputScalar(frame, id, label, ImGuiDataType_Double, &value, "%.10g");

  take_by_keys(id);
  const Track track = track_of(frame);
  const double before = value;
  if (g.ActiveId == id)
    value = g.ActiveIdSource == ImGuiInputSource_Mouse ? drag(track, range, value, ticks) : step_by_keys(range, value);
  if (value != before) ImGui::MarkItemEdited(id);
  draw_slider(id, track, range, value, ticks, text, hovered);
  draw_ticks(track, range, ticks, theme);
  return value != before;
}

}  // namespace psm
