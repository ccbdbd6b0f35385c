// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tile_menu.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "draw/annotation.h"
#include "ui/theme.h"

namespace psm {
namespace {

/// As the titles of the pictures are drawn.
double title_px(double scale) { return std::round(kTextHeight * scale); }

bool is_alone(const ViewSettings& view) { return view.maximised.has_value(); }

void choose(ViewSettings& view, ViewId here, ViewId wanted) {
  if (is_alone(view)) {
    view.maximised = wanted;
    return;
  }
  const auto found = std::find(view.tiles.begin(), view.tiles.end(), here);
  put_in_tile(view.tiles, std::size_t(found - view.tiles.begin()), wanted);
}

std::optional<ViewId> hidden_view(const std::vector<ViewId>& tiles) {
  for (const ViewId id : kAllViews)
    if (std::find(tiles.begin(), tiles.end(), id) == tiles.end()) return id;
  return std::nullopt;
}

bool item(UiContext& ui, const std::string& name, const char* text, bool chosen = false, bool enabled = true) {
  const bool clicked = ImGui::MenuItem(text, nullptr, chosen, enabled);
  note_place(ui, name);
  return clicked;
}

void items(UiContext& ui, const std::string& name, ViewId id, ViewSettings& view) {
  for (const ViewId other : kAllViews)
    if (item(ui, name + "=" + name_of(other), display_name(other), other == id)) choose(view, id, other);
  ImGui::Separator();
  if (item(ui, name + "=alone", "Alone (double click)", is_alone(view)))
    view.maximised = is_alone(view) ? std::nullopt : std::optional<ViewId>(id);
  if (is_alone(view)) return;
  const auto next = hidden_view(view.tiles);
  if (item(ui, name + "=more", "One more tile", false, view.tiles.size() < kMostTiles && next)) view.tiles.push_back(*next);
  if (item(ui, name + "=close", "Close this tile", false, view.tiles.size() > 1)) std::erase(view.tiles, id);
}

/// The mark of a menu, as ImGui's own combo boxes have it.
void draw_arrow(glm::dvec2 middle, double size) {
  const auto at = [&](double x, double y) { return ImVec2(float(middle.x + x * size), float(middle.y + y * size)); };
  ImGui::GetWindowDrawList()->AddTriangleFilled(at(-0.45, -0.25), at(0.45, -0.25), at(0.0, 0.35), text_color(0.8));
}

}  // namespace

const char* display_name(ViewId view) {
  constexpr const char* names[] = {"World", "Unit cube", "Shadow map", "Eye", "Body H", "Curves", "Explorer"};
  static_assert(std::size(names) == kAllViews.size());
  return names[std::size_t(view)];
}

void put_in_tile(std::vector<ViewId>& tiles, std::size_t place, std::optional<ViewId> view) {
  if (!view) {
    if (tiles.size() > 1 && place < tiles.size()) tiles.erase(tiles.begin() + std::ptrdiff_t(place));
    return;
  }
  const auto elsewhere = std::find(tiles.begin(), tiles.end(), *view);
  if (place >= tiles.size()) {
    if (elsewhere == tiles.end() && tiles.size() < kMostTiles) tiles.push_back(*view);
    return;
  }
  if (elsewhere != tiles.end()) *elsewhere = tiles[place];
  tiles[place] = *view;
}

ShownTitle shown_title(const ViewPicture& picture, glm::ivec2 tile, double scale) {
  const auto text_size = [&](const std::string& text) {
    const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(float(title_px(scale)), 1e9f, 0.0f, text.c_str());
    return glm::dvec2(size.x, size.y);
  };
  ShownTitle title{title_lines(picture, {glm::dvec2(tile), scale, Theme::light}, text_size)};
  glm::dvec2 extent(0.0);
  for (const std::string& line : title.lines) {
    title.last = text_size(line).x;
    extent = {std::max(extent.x, title.last), extent.y + text_size(line).y};
  }
  if (!title.lines.empty()) title.end = extent + (kTitleInset + label_margin) * scale;
  return title;
}

void tile_menu(UiContext& ui, ViewId id, const Rect& tile, const ViewPicture& picture, ViewSettings& view) {
  const double s = ui.scale, margin = label_margin * s, inset = kTitleInset * s, px = title_px(s);
  const ShownTitle title = shown_title(picture, tile.size(), s);
  // The mark stands behind the last line.
  const glm::dvec2 end(std::max(title.end.x, inset + title.last + margin + px), title.end.y);
  if (title.lines.empty() || tile.size().x < end.x + margin || tile.size().y < 2.0 * end.y) return;
  const glm::dvec2 corner = glm::dvec2(tile.min) + inset - margin, size = end - inset + margin;
  const std::string name = std::string("tile.") + name_of(id);
  ImGui::SetCursorScreenPos({float(corner.x), float(corner.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
  ImGui::BeginChild(name.c_str(), {float(size.x), float(size.y)}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (ImGui::InvisibleButton("menu", {float(size.x), float(size.y)})) ImGui::OpenPopup("views");
  focus_ring();
  note_place(ui, name);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const glm::dvec2 arrow(min.x + title.last + 1.5 * margin + 0.5 * px, max.y - margin - 0.5 * px);
  list->AddRectFilled({float(arrow.x - 0.5 * px), float(arrow.y - 0.5 * px)}, {float(arrow.x + 0.5 * (px + margin)), max.y},
                      color(ground_color(ui.theme), 0.85), float(margin));
  draw_arrow(arrow, 0.7 * px);
  if (ImGui::IsItemHovered() || ImGui::IsPopupOpen("views"))
    list->AddRect(min, max, color(accent_color(ui.theme)), float(margin), 0, float(1.5 * s));
  rest_tooltip("Which view stands here.");
  if (ImGui::BeginPopup("views")) {
    items(ui, name, id, view);
    ImGui::EndPopup();
  }
  ImGui::EndChild();
}

void tile_field(UiContext& ui, const std::string& name, float width, std::size_t place, std::vector<ViewId>& tiles) {
  const bool exists = place < tiles.size();
  ImGui::PushID(int(place));
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##tile", exists ? display_name(tiles[place]) : "none");
  note_place(ui, name);
  if (open) {
    const std::vector<ViewId> before = tiles;
    for (const ViewId id : kAllViews) {
      if (ImGui::Selectable(display_name(id), exists && before[place] == id)) put_in_tile(tiles, place, id);
      note_place(ui, name + "=" + name_of(id));
    }
    if (ImGui::Selectable("none", !exists)) put_in_tile(tiles, place, std::nullopt);
    note_place(ui, name + "=none");
    ImGui::EndCombo();
  }
  ImGui::PopID();
}

}  // namespace psm
