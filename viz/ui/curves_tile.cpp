// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/curves_tile.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "draw/curves_view.h"
#include "scene/eye_and_light.h"
#include "scene/light_angles.h"
#include "ui/overlay.h"
#include "ui/theme.h"
#include "ui/tile_tools.h"

namespace psm {
namespace {

CurveKind kind_of(const ViewImages& images) { return images.analysis().experiment.view.curve; }

const std::optional<ChartFrame>& frame_of(const ViewImages& images) { return images.picture(ViewId::curves).chart; }

bool over_theta(CurveKind kind) { return kind != CurveKind::F_z && kind != CurveKind::E_z; }

/// The angle at a place of the page, or a marked one nearby.
double snapped_theta(const ViewImages& images, const ChartFrame& frame, double x, double reach) {
  const CurveSetting setting = curve_setting(images.analysis());
  double theta = std::clamp(frame.x.value_at(x), 0.0, 90.0);
  std::vector<double> attracting{90.0};
  for (const CriticalAngle& angle : critical_angles(kind_of(images), setting)) attracting.push_back(angle.theta_deg);
  for (const double angle : attracting) {
    const double distance = std::abs(frame.x.at(angle) - x);
    if (distance < reach) theta = angle, reach = distance;
  }
  return theta;
}

glm::dvec2 mouse_on_page(const UiContext& ui, const Rect& picture) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return (glm::dvec2(mouse.x, mouse.y) - glm::dvec2(picture.min)) / ui.scale;
}

std::string value_text(double value) { return std::isnan(value) ? "–" : shown_number(value); }

void reading_tooltip(const UiContext& ui, const CurveReading& reading) {
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(reading.x.c_str());
  for (const CurveReading::Row& row : reading.rows) {
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 0.4f * size}, {at.x + size, at.y + 0.6f * size},
                                              line_color(curve_role(row.warp), ui.theme));
    ImGui::SetCursorScreenPos({at.x + 1.3f * size, at.y});
    ImGui::Text("%s  %s", display_name(row.warp), value_text(row.value).c_str());
  }
  ImGui::EndTooltip();
}

template <class Value, std::size_t N>
void menu(UiContext& ui, const char* path, const std::array<const char*, N>& names, Value& value, float width) {
  ImGui::PushID(path);
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##menu", names[std::size_t(value)]);
  note_place(ui, std::string("tile.") + path);
  if (open) {
    for (std::size_t i = 0; i < N; ++i) {
      if (ImGui::Selectable(names[i], std::size_t(value) == i)) value = Value(i);
      note_place(ui, std::string("tile.") + path + "=" + std::to_string(i));
    }
    ImGui::EndCombo();
  } else {
    rest_tooltip(find_field(std::string("view.") + path)->help);
  }
  ImGui::PopID();
}

}  // namespace

bool grabs_cursor(const ViewImages& images, glm::dvec2 pixel, double scale) {
  const auto& frame = frame_of(images);
  return frame && over_theta(kind_of(images)) && frame->contains(pixel / scale);
}

Experiment with_cursor_at(const Experiment& before, const ViewImages& images, glm::dvec2 pixel, double scale,
                          double snap_pixels) {
  const auto& frame = frame_of(images);
  if (!frame) return before;
  const double wanted = snapped_theta(images, *frame, pixel.x / scale, snap_pixels);
  const double now = curve_setting(images.analysis()).theta_deg;
  const ConvexBody& seen = images.analysis().receivers_body;
  const glm::dvec3 middle = seen.empty() ? before.camera.target : seen.centroid();
  return with_light_at(before, kRadiansPerDegree * (now > 90.0 ? 180.0 - wanted : wanted), middle);
}

void draw_curve_reading(const UiContext& ui, const Rect& picture, const ViewImages& images) {
  const auto& frame = frame_of(images);
  const glm::dvec2 page = mouse_on_page(ui, picture);
  if (!frame || !frame->contains(page) || ImGui::IsAnyMouseDown()) return;
  const glm::dvec2 value(frame->x.value_at(page.x), frame->y.value_at(page.y));
  const CurveReading reading = read_curves(kind_of(images), curve_setting(images.analysis()), value);
  DrawList list;
  const auto at = [](double x, double y) { return glm::dvec4(x, y, 0.0, 1.0); };
  list.lines.push_back({at(page.x, frame->y.from()), at(page.x, frame->y.to()), Role::neutral, 1.0});
  for (const CurveReading::Row& row : reading.rows)
    if (kind_of(images) != CurveKind::surface && frame->y.contains(row.value))
      list.points.push_back({at(page.x, frame->y.at(row.value)), curve_role(row.warp), 3.5});
  draw_over(ui, list, images.picture(ViewId::curves), picture);
  reading_tooltip(ui, reading);
}

bool curve_tools(UiContext& ui, const Rect& picture, Experiment& experiment) {
  const float font = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
  const float kinds = 9.5f * font, frusta = 7.0f * font;
  const float csv = ImGui::CalcTextSize("CSV").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  const bool narrow = float(picture.size().x) < kinds + frusta + csv + 2.0f * gap + 14.0f * font;
  if (!begin_tile_tools("curve tools", picture, narrow ? kinds : kinds + gap + frusta + gap + csv)) return false;
  std::array<const char*, kCurveKinds> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = display_name(CurveKind(i));
  menu(ui, "curve", names, experiment.view.curve, kinds);
  bool copy = false;
  if (!narrow) {
    ImGui::SameLine();
    menu(ui, "curve_range", std::array{"experiment", "n 1, f 100"}, experiment.view.curve_range, frusta);
    ImGui::SameLine();
    copy = ImGui::Button("CSV");
    note_place(ui, "tile.curve_csv");
    rest_tooltip("Copies what the plot shows as CSV; over θ the same as psmlab curves prints.");
  }
  end_tile_tools();
  return copy;
}

}  // namespace psm
