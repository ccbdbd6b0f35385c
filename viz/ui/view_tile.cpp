// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view_tile.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "draw/facet_pick.h"
#include "ui/curves_tile.h"
#include "ui/explorer_tile.h"
#include "ui/navigation.h"
#include "ui/theme.h"

namespace psm {
namespace {

constexpr double handle_reach = 10.0;  // pixels at scale 1
constexpr double handle_radius = 8.0;
constexpr double snap_pixels = 6.0;  // as the sliders

struct Mouse {
  glm::dvec2 pixel;  // of the picture, y downwards
  glm::dvec2 drag;   // since the last frame, in fractions of the height, y up
  bool shift, alt;
};

Mouse mouse_in(const Rect& picture) {
  const ImGuiIO& io = ImGui::GetIO();
  const double height = std::max(1, picture.size().y);
  return {glm::dvec2(io.MousePos.x, io.MousePos.y) - glm::dvec2(picture.min),
          glm::dvec2(io.MouseDelta.x, -io.MouseDelta.y) / height, io.KeyShift, io.KeyAlt};
}

bool is_flat(ViewId id) { return id == ViewId::curves || id == ViewId::explorer; }

OrbitSettings& orbit_of(ViewId id, ViewSettings& view) {
  return id == ViewId::world ? view.world : id == ViewId::cube ? view.cube : view.body;
}

double aspect(const Rect& rect) { return double(rect.size().x) / std::max(1, rect.size().y); }

OrbitCamera camera_now(ViewId id, const ViewImages& images, const Rect& picture) {
  return view_camera(id, images.analysis(), aspect(picture));
}

/// The orbit as it is shown: what the fit decided becomes the experiment's own.
void write_out(ViewId id, const ViewImages& images, Experiment& experiment) {
  OrbitSettings& orbit = orbit_of(id, experiment.view);
  ViewSettings shown = images.analysis().experiment.view;
  if (!(orbit.distance > 0.0)) orbit = orbit_of(id, shown);
}

glm::dvec2 map_point(const ViewImages& images, const Rect& picture, glm::dvec2 pixel) {
  const glm::dvec2 size = picture.size();
  const glm::dvec4 ndc(2.0 * pixel.x / size.x - 1.0, 1.0 - 2.0 * pixel.y / size.y, 0.0, 1.0);
  const glm::dvec4 p = glm::inverse(images.picture(ViewId::map).clip_from_list) * ndc;
  return glm::dvec2(p) / p.w;
}

/// On a plot or the explorer's map the light is wherever the mouse goes down.
void begin_light_drag(ViewId id, const Rect& picture, const ViewImages& images, const Mouse& mouse, double scale, ViewDrag& drag,
                      const Experiment& experiment) {
  const bool grabbed = id == ViewId::curves ? grabs_cursor(images, mouse.pixel, scale)
                                            : on_explorer_map(images, picture.size(), mouse.pixel, scale);
  drag = {};
  if (grabbed) drag.kind = ViewDrag::Kind::light, drag.before = experiment;
}

void drag_light(ViewId id, const Rect& picture, const ViewImages& images, const Mouse& mouse, double scale, const ViewDrag& drag,
                Experiment& e) {
  const double snap = mouse.alt ? 0.0 : snap_pixels;
  e.light = (id == ViewId::curves ? with_cursor_at(*drag.before, images, mouse.pixel, scale, snap)
                                  : with_light_under(*drag.before, images, picture.size(), mouse.pixel, scale, snap))
                .light;
}

void begin_drag(ViewId id, const Rect& picture, const ViewImages& images, const Mouse& mouse, double scale, ViewDrag& drag,
                const Experiment& experiment) {
  if (is_flat(id)) return begin_light_drag(id, picture, images, mouse, scale, drag, experiment);
  const bool middle = ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  drag = {};
  drag.kind = middle || mouse.shift || id == ViewId::map ? ViewDrag::Kind::pan : ViewDrag::Kind::turn;
  if (id != ViewId::world || middle) return;
  const auto near =
      picked_handle(handles(images.picture(id), images.analysis().experiment, picture.size()), mouse.pixel, handle_reach * scale);
  if (!near) return;
  drag.kind = ViewDrag::Kind::handle;
  drag.handle = HandleDrag{*near,          experiment,  camera_now(id, images, picture),
                           picture.size(), mouse.pixel, shown_vanishing_plane(images.analysis()).value_or(glm::dvec4(0.0))};
}

void drag_orbit(ViewId id, const Rect& picture, const ViewImages& images, const Mouse& mouse, ViewDrag::Kind kind,
                Experiment& e) {
  OrbitSettings& orbit = orbit_of(id, e.view);
  if (kind == ViewDrag::Kind::turn) return turn(orbit, mouse.drag);
  write_out(id, images, e);
  pan(orbit, camera_now(id, images, picture), mouse.drag);
}

void apply_drag(ViewId id, const Rect& picture, const ViewImages& images, const Mouse& mouse, double scale, const ViewDrag& drag,
                Experiment& e) {
  if (drag.kind == ViewDrag::Kind::none) return;
  if (drag.kind == ViewDrag::Kind::light) return drag_light(id, picture, images, mouse, scale, drag, e);
  if (drag.kind == ViewDrag::Kind::handle) {
    const ViewSettings view = e.view;
    e = dragged(*drag.handle, mouse.pixel, mouse.shift, mouse.alt ? 0.0 : snap_pixels);
    e.view = view;
    return;
  }
  if (mouse.drag == glm::dvec2(0.0)) return;
  if (id == ViewId::eye)
    drag.kind == ViewDrag::Kind::turn ? turn(e.camera, mouse.drag) : pan(e.camera, mouse.drag);
  else if (id == ViewId::map)
    pan_map(e.view, 1.0 / images.picture(id).clip_from_list[1][1], mouse.drag);
  else
    drag_orbit(id, picture, images, mouse, drag.kind, e);
}

std::string wheel(ViewId id, const Rect& picture, const ViewImages& images, const Mouse& mouse, Experiment& e) {
  const double steps = ImGui::GetIO().MouseWheel;
  if (steps == 0.0 || is_flat(id)) return "";
  if (id == ViewId::eye) {
    dolly(e.camera, steps);
  } else if (id == ViewId::map) {
    zoom_map(e.view, steps, map_point(images, picture, mouse.pixel));
  } else {
    write_out(id, images, e);
    zoom(orbit_of(id, e.view), steps);
  }
  return std::string("wheel ") + name_of(id);
}

void toggle_maximised(ViewId id, ViewDrag& drag, Experiment& e) {
  drag = {};
  e.view.maximised = e.view.maximised ? std::nullopt : std::optional<ViewId>(id);
}

/// As the labels of the pictures: what lies behind must not make it illegible.
void write_on_plate(ImVec2 at, const char* text) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text);
  const float margin = 0.2f * ImGui::GetFontSize();
  list->AddRectFilled({at.x - margin, at.y - margin}, {at.x + size.x + margin, at.y + size.y + margin},
                      ImGui::GetColorU32(ImGuiCol_PopupBg), margin);
  list->AddText(at, text_color(), text);
}

void draw_handles(const UiContext& ui, const Rect& picture, const ViewImages& images, const ViewDrag& drag) {
  const auto all = handles(images.picture(ViewId::world), images.analysis().experiment, picture.size());
  std::optional<Handle> hot;
  const bool dragging = drag.kind == ViewDrag::Kind::handle;
  if (dragging || drag.selected) {
    for (const Handle& handle : all)
      if (handle.kind == (dragging ? drag.handle->handle.kind : *drag.selected)) hot = handle;
  } else {
    hot = picked_handle(all, mouse_in(picture).pixel, handle_reach * ui.scale);
  }
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const Handle& handle : all) {
    const bool lit = hot && hot->kind == handle.kind;
    const ImVec2 at(float(picture.min.x + handle.pixel.x), float(picture.min.y + handle.pixel.y));
    const float radius = float((lit ? 1.3 : 1.0) * handle_radius * ui.scale), width = float((lit ? 3.0 : 1.5) * ui.scale);
    list->AddCircle(at, radius, line_color(role_of(handle.kind), ui.theme), 32, width);
    if (lit && !is_labelled(handle, images.picture(ViewId::world), picture.size()))
      write_on_plate({at.x + 1.6f * radius, at.y - 0.5f * ImGui::GetFontSize()}, name_of(handle.kind));
  }
}

/// The facet of H or R under the mouse, once it has rested: its outline, and the planes that made it.
void draw_facet(const UiContext& ui, ViewId id, const Rect& picture, const ViewImages& images) {
  const auto facet = pick_facet(images.picture(id), images.analysis(), picture.size(), mouse_in(picture).pixel);
  if (!facet) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  std::vector<ImVec2> outline;
  for (const glm::dvec2& p : facet->outline) outline.push_back({float(picture.min.x + p.x), float(picture.min.y + p.y)});
  list->AddPolyline(outline.data(), int(outline.size()), line_color(facet->body, ui.theme), ImDrawFlags_Closed,
                    float(3.0 * ui.scale));
  ImGui::SetTooltip("%s", facet->text.c_str());
}

}  // namespace

std::string tile_input(UiContext& ui, ViewId id, const Rect& picture, const ViewImages& images, ViewDrag& drag,
                       Experiment& experiment) {
  if (picture.empty()) return "";
  ImGui::SetCursorScreenPos({float(picture.min.x), float(picture.min.y)});
  ImGui::InvisibleButton(name_of(id), {float(picture.size().x), float(picture.size().y)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  ui.places[std::string("view.") + name_of(id)] = picture;
  if (images.texture(id) == 0) return "";
  const Mouse mouse = mouse_in(picture);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    toggle_maximised(id, drag, experiment);
  else if (ImGui::IsItemActivated())
    begin_drag(id, picture, images, mouse, ui.scale, drag, experiment);
  else if (ImGui::IsItemActive())
    apply_drag(id, picture, images, mouse, ui.scale, drag, experiment);
  if (ImGui::IsItemDeactivated()) drag = {};
  return ImGui::IsItemHovered() ? wheel(id, picture, images, mouse, experiment) : "";
}

void draw_tile(UiContext& ui, ViewId id, const Rect& picture, const ViewImages& images, const ViewDrag& drag) {
  if (picture.empty() || images.texture(id) == 0) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 corner(float(picture.min.x), float(picture.min.y)), end(float(picture.max.x), float(picture.max.y));
  list->PushClipRect(corner, end, true);
  // The texture's first row is the bottom one.
  list->AddImage(reinterpret_cast<ImTextureID>(std::uintptr_t(images.texture(id))), corner, end, {0, 1}, {1, 0});
  if (id == ViewId::world) draw_handles(ui, picture, images, drag);
  if (id == ViewId::curves && mouse_on(name_of(id))) draw_curve_reading(ui, picture, images);
  const bool solid = id == ViewId::world || id == ViewId::cube || id == ViewId::body;
  if (solid && drag.kind == ViewDrag::Kind::none && rested_on(name_of(id))) draw_facet(ui, id, picture, images);
  list->PopClipRect();
}

}  // namespace psm
