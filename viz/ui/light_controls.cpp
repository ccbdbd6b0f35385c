// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/light_controls.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "scene/light_angles.h"

namespace psm {
namespace {

constexpr double half_pi = 1.57079632679489661923;

float full_width() { return ImGui::GetContentRegionAvail().x; }

void caption(const char* text, const std::vector<Tick>& ticks) {
  ImGui::TextUnformatted(text);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + std::floor(0.7f * tick_label_height(ticks)));
}

/// What one looks at sets the scale; a light beyond it is still on the slider.
double depth_slider_reach(const Experiment& e) {
  return std::max(2.0 * glm::length(e.camera.target - e.camera.position), 1.25 * std::abs(light_depth(e)));
}

void depth_slider(UiContext& ui, LightControls& state, Experiment& e) {
  double depth = light_depth(e);
  const double reach = state.depth_reach.value_or(depth_slider_reach(e));
  const std::vector<Tick> ticks = {{0.0, "w = 0", Role::infinity}};
  caption("w, depth of the light", ticks);
  ImGui::SetNextItemWidth(full_width());
  if (ticked_slider("##depth", depth, {-reach, reach, false, false}, ticks, shown_number(depth, 3), ui.theme))
    if (std::isfinite(depth)) e.light.position = position_at_depth(e, std::clamp(depth, -1e6 * reach, 1e6 * reach));
  note_place(ui, "depth");
  if (ImGui::IsItemActive())
    state.depth_reach = reach;
  else
    state.depth_reach.reset();
  rest_tooltip(
      "How far the light is in front of the plane through the eye, in scene units: w = v·(l − e).\nPositive: a point after "
      "the projection. 0: directional. Negative: an inverted point.\nAlt while dragging: no snapping.");
}

// ---- the dial ----

struct Dial {
  ImVec2 center;
  float radius;
  ImVec2 place(const glm::dvec3& direction) const {
    const Bearing b = bearing_of(direction);
    const float r = radius * float(1.0 - std::abs(b.elevation) / half_pi);
    return {center.x + r * float(std::sin(b.azimuth)), center.y + r * float(std::cos(b.azimuth))};
  }
  /// The direction under the mouse, above or below the horizon.
  glm::dvec3 direction(const ImVec2& mouse, bool below) const {
    const double x = mouse.x - center.x, y = mouse.y - center.y;
    const double elevation = half_pi * (1.0 - std::min(1.0, std::hypot(x, y) / radius));
    return direction_of({std::atan2(x, y), below ? -elevation : elevation});
  }
};

/// A circle of directions around `axis` at this angle; only what is above the horizon (or below, with the light).
void sky_circle(const Dial& dial, const glm::dvec3& axis, double angle, bool below, Color color, float width) {
  const glm::dvec3 a = std::abs(axis.y) < 0.9 ? glm::normalize(glm::cross(axis, glm::dvec3(0, 1, 0))) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(a - glm::dot(a, axis) * axis), v = glm::cross(axis, u);
  const auto point = [&](int i) {
    const double t = 4.0 * half_pi * i / 96.0;
    return std::cos(angle) * axis + std::sin(angle) * (std::cos(t) * u + std::sin(t) * v);
  };
  for (int i = 0; i < 96; ++i) {
    const glm::dvec3 p = point(i), q = point(i + 1);
    if ((p.y < 0.0) == below && (q.y < 0.0) == below)
      ImGui::GetWindowDrawList()->AddLine(dial.place(p), dial.place(q), color, width);
  }
}

void draw_dial(const UiContext& ui, const Dial& dial, const Experiment& e, bool hot) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const glm::dvec3 to_light = e.light.to_light, view = view_forward(e.camera);
  const bool below = to_light.y < 0.0;
  const float line = std::max(1.5f, float(1.5 * ui.scale)), grip = float((hot ? 8.0 : 6.5) * ui.scale);
  list->AddCircleFilled(dial.center, dial.radius, ImGui::GetColorU32(ImGuiCol_FrameBg), 64);
  list->AddCircle(dial.center, dial.radius, text_color(0.6), 64, line);
  list->AddCircle(dial.center, dial.radius * 0.5f, text_color(0.2), 48, line * 0.6f);
  list->AddLine({dial.center.x - dial.radius, dial.center.y}, {dial.center.x + dial.radius, dial.center.y}, text_color(0.2));
  list->AddLine({dial.center.x, dial.center.y - dial.radius}, {dial.center.x, dial.center.y + dial.radius}, text_color(0.2));
  sky_circle(dial, view, half_pi, below, line_color(Role::infinity, ui.theme), line * 1.3f);
  const double phi = phi_towards_light(e);
  sky_circle(dial, view, phi, below, line_color(Role::frustum, ui.theme), line);
  sky_circle(dial, -view, phi, below, line_color(Role::frustum, ui.theme), line);
  const ImVec2 at = dial.place(to_light);
  const Color light = color(role_color(Role::light));
  if (below)
    list->AddCircle(at, grip, line_color(Role::light, ui.theme), 24, line * 2.0f);
  else
    list->AddCircleFilled(at, grip, light, 24);
  list->AddCircle(at, grip + line, text_color(0.8), 24, line * 0.7f);
}

void dial_legend(const UiContext& ui, const Experiment& e) {
  const auto entry = [&](Role role, const char* text) {
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({at.x, at.y + 0.55f * em}, {at.x + 0.9f * em, at.y + 0.55f * em},
                                        line_color(role, ui.theme), float(2.0 * ui.scale));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.2f * em);
    ImGui::TextUnformatted(text);
  };
  const Bearing b = bearing_of(e.light.to_light);
  ImGui::Text("az. %.1f°", glm::degrees(b.azimuth));
  ImGui::Text("alt. %.1f°", glm::degrees(b.elevation));
  entry(Role::infinity, "w = 0");
  entry(Role::frustum, "θ = φ");
}

}  // namespace

std::vector<Tick> theta_ticks(const Experiment& e) {
  const double phi = glm::degrees(phi_towards_light(e));
  return {{phi, "φ", Role::frustum}, {90.0, "w = 0", Role::infinity}, {180.0 - phi, "180°−φ", Role::frustum}};
}

bool light_dial(UiContext& ui, Experiment& e) {
  const float size = std::floor(std::min(7.0f * ImGui::GetFontSize(), 0.55f * full_width()));
  if (size < 16.0f) return false;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Dial dial{{corner.x + 0.5f * size, corner.y + 0.5f * size}, 0.5f * size - float(4.0 * ui.scale)};
  ImGui::InvisibleButton("##dial", {size, size});
  focus_ring();
  note_place(ui, "dial");
  const bool active = ImGui::IsItemActive();
  const ImVec2 mouse = ImGui::GetIO().MousePos, press = ImGui::GetIO().MouseClickedPos[0];
  const bool moved = mouse.x != press.x || mouse.y != press.y || !ImGui::IsMouseDown(0);
  bool changed = false;
  if (active && (moved || ImGui::IsItemActivated())) {
    const glm::dvec3 wanted = dial.direction(mouse, e.light.to_light.y < 0.0) * glm::length(e.light.to_light);
    changed = wanted != e.light.to_light;
    e.light.to_light = wanted;
  }
  rest_tooltip(
      "Where the light comes from: the sky from above, the rim is the horizon.\nA ring instead of a disc: below the horizon.");
  draw_dial(ui, dial, e, active || ImGui::IsItemHovered());
  ImGui::SameLine();
  ImGui::BeginGroup();
  dial_legend(ui, e);
  ImGui::EndGroup();
  note_place(ui, "dial.legend");
  return changed;
}

void theta_slider(UiContext& ui, LightControls& state, Experiment& e) {
  double degrees = glm::degrees(light_theta(e));
  const double before = degrees;
  const auto ticks = theta_ticks(e);
  caption("θ, between light and view", ticks);
  ImGui::SetNextItemWidth(full_width());
  if (ticked_slider("##theta", degrees, {0.0, 180.0, false, false}, ticks,
                    shown_number(std::abs(degrees) < 1e-9 ? 0.0 : degrees) + "°", ui.theme)) {
    if (!state.theta_side) state.theta_side = theta_side(e);
    const double theta = degrees == 90.0 ? half_pi : glm::radians(std::clamp(degrees, 0.0, 180.0));
    if (degrees != before) e.light.to_light = to_light_at(e, theta, *state.theta_side);
  }
  note_place(ui, "theta");
  if (ImGui::IsItemActivated() && !state.theta_side) state.theta_side = theta_side(e);
  if (!ImGui::IsItemActive()) state.theta_side.reset();
  rest_tooltip(
      "Angle between the view direction and the direction to the light, in degrees.\nAt 90° w = 0: the light is "
      "directional after the projection. Below φ and above 180° − φ the light shines along the view.\nAlt while dragging: "
      "no snapping.");
}

void light_controls(UiContext& ui, LightControls& state, Experiment& e) {
  if (e.light.type == LightType::directional) {
    light_dial(ui, e);
    theta_slider(ui, state, e);
  } else {
    depth_slider(ui, state, e);
  }
}

}  // namespace psm
