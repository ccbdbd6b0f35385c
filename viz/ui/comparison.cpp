// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/comparison.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "draw/annotation.h"
#include "ui/control_pane.h"
#include "ui/theme.h"
#include "ui/tile_menu.h"

namespace psm {
namespace {

constexpr double kNameHeight = 18.0;  // of A's and B's names, pixels at scale 1
constexpr float kLeastName = 0.4f;    // of that

int line_x(const Rect& picture, double split) { return picture.min.x + int(std::lround(split * picture.size().x)); }

}  // namespace

struct Comparison::Second {
  Second(LoadedExperiment loaded, std::uint64_t scene_of_first, const std::filesystem::path& assets,
         const std::filesystem::path& font)
      : model(std::move(loaded)), renderer(assets, font), images(renderer), scene(scene_of_first) {}
  Model model;
  Renderer renderer;
  ViewImages images;
  Profile unwatched;  // the whole of it is one stage of the frame's own profile
  std::uint64_t scene;
};

Comparison::Comparison(std::filesystem::path assets, std::filesystem::path font)
    : assets_(std::move(assets)), font_(std::move(font)) {}

Comparison::~Comparison() = default;

int Comparison::update(const Model& first, const ViewSettings& shown, const ViewRects& places, double scale, Theme theme,
                       const Emphasis& emphasis, const ShownParts& parts, bool resting) {
  if (!shown.compare) return second_.reset(), 0;
  Experiment experiment = first.experiment();
  experiment.shadow.technique = *shown.compare;
  if (!second_ || second_->scene != first.scene_revision())
    second_ = std::make_unique<Second>(LoadedExperiment{experiment, first.scene(), "."}, first.scene_revision(), assets_, font_);
  Second& s = *second_;
  s.model.follow(experiment);
  ViewSizes sizes{};
  for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] = places[i].empty() ? glm::ivec2(0) : places[i].size();
  if (resting && sizes[std::size_t(ViewId::eye)].x > 0) s.images.trace_overlay(s.model, s.unwatched);
  s.images.set_emphasis(emphasis);
  if (resting) s.images.set_shown_parts(parts);
  if (first.texels_counted()) s.model.count_texels();
  return s.images.update(s.model, shown, sizes, scale, theme, s.unwatched);
}

const Analysis* Comparison::analysis() const { return second_ ? &second_->model.analysis() : nullptr; }
const ViewImages* Comparison::images() const { return second_ ? &second_->images : nullptr; }

bool is_split(ViewId id, const ViewSettings& view) {
  return is_compared(id) && view.compare_layout == CompareLayout::split && id != ViewId::map;
}

ViewRects place_second(Layout& layout, const ViewSettings& view, int gap) {
  ViewRects second{};
  for (ViewId id : kAllViews) {
    Rect& first = layout.views[std::size_t(id)];
    if (!view.compare || !is_compared(id) || first.empty()) continue;
    second[std::size_t(id)] = first;
    if (is_split(id, view)) continue;
    const int half = (first.size().x - gap) / 2;
    first.max.x = first.min.x + half;
    second[std::size_t(id)].min.x = second[std::size_t(id)].max.x - half;
  }
  return second;
}

Rect first_part(ViewId id, const Rect& picture, const ViewSettings& view) {
  Rect part = picture;
  if (view.compare && is_split(id, view)) part.max.x = line_x(picture, view.split);
  return part;
}

std::string comparison_name(char letter, const Analysis& analysis) {
  const Technique asked = analysis.experiment.shadow.technique, used = analysis.technique_used;
  std::string name = std::string(1, letter) + "\u00a0\u00a0" + display_name(asked);
  if (used != asked) name += std::string(", fell back to ") + display_name(used);
  const bool sizes = analysis.experiment.view.eye_overlay == EyeOverlay::texel_size;
  return sizes && analysis.texels ? name + "  p95\u00a0" + shown_number(analysis.texels->m_p95, 3) : name;
}

namespace {

float widest_word(const std::string& text, float px) {
  float widest = 0.0f;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    widest = std::max(widest, ImGui::GetFont()->CalcTextSizeA(px, 1e9f, 0.0f, text.substr(at, end - at).c_str()).x);
    at = end + 1;
  }
  return widest;
}

float name_px(const UiContext& ui) { return std::min(ImGui::GetFontSize(), float(std::round(kNameHeight * ui.scale))); }

float name_pad(const UiContext& ui) { return std::floor(0.3f * name_px(ui)); }

/// Its top left is `at`, or its top right. Stays on its side of the line: in more lines, or smaller, or, where hardly anything is
/// left of the side, not at all. Returns its place.
Rect name_plate(UiContext& ui, const std::string& text, ImVec2 at, bool right_aligned, const Rect& within) {
  const float full = name_px(ui), pad = name_pad(ui);
  const float wrap = (right_aligned ? at.x - float(within.min.x) : float(within.max.x) - at.x) - 3.0f * pad;
  const float px = full * std::min(1.0f, 0.98f * wrap / widest_word(text, full));
  if (px < kLeastName * full) return {};
  const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(px, 1e9f, wrap, text.c_str());
  const float x = right_aligned ? at.x - size.x - 2.0f * pad : at.x;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled({x, at.y}, {x + size.x + 2.0f * pad, at.y + size.y + 2.0f * pad}, ImGui::GetColorU32(ImGuiCol_PopupBg),
                      pad);
  list->AddText(ImGui::GetFont(), px, {x + pad, at.y + pad}, text_color(), text.c_str(), nullptr, wrap);
  const Rect place{{int(x), int(at.y)}, {int(x + size.x + 2.0f * pad), int(at.y + size.y + 2.0f * pad)}};
  return ui.places["compare." + std::string(1, text.front())] = place;
}

ShownPart part_of(const Rect& picture, const glm::dvec2& columns, const Rect& name) {
  ShownPart part{columns, {}};
  const glm::dvec2 size = picture.size();
  if (!name.empty()) part.covered.push_back({glm::dvec2(name.min - picture.min) / size, glm::dvec2(name.size()) / size});
  return part;
}

/// A line with a grip in the middle, dark between light edges or the reverse: it stands out from any picture.
void draw_line(const UiContext& ui, const Rect& picture, int x) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float s = float(ui.scale), middle = 0.5f * float(picture.min.y + picture.max.y), grip = 9.0f * s;
  const ImU32 ink = text_color(), halo = ImGui::GetColorU32(ImGuiCol_PopupBg);
  const auto bar = [&](float half, ImU32 tone) {
    list->AddRectFilled({float(x) - half, float(picture.min.y)}, {float(x) + half, float(picture.max.y)}, tone);
  };
  bar(2.5f * s, halo);
  bar(1.25f * s, ink);
  list->AddCircleFilled({float(x), middle}, grip + 1.5f * s, ink, 32);
  list->AddCircleFilled({float(x), middle}, grip, halo, 32);
  for (const float side : {-1.0f, 1.0f})
    list->AddTriangleFilled({float(x) + side * 7.0f * s, middle}, {float(x) + side * 2.5f * s, middle - 4.0f * s},
                            {float(x) + side * 2.5f * s, middle + 4.0f * s}, ink);
}

/// Takes the mouse on the line between A and B.
void drag_split(UiContext& ui, ViewId id, const Rect& picture, ViewSettings& view) {
  const int x = line_x(picture, view.split), reach = std::max(3, int(std::lround(6.0 * ui.scale)));
  ImGui::SetCursorScreenPos({float(x - reach), float(picture.min.y)});
  ImGui::PushID(name_of(id));
  ImGui::InvisibleButton("split", {float(2 * reach), float(picture.size().y)});
  ImGui::PopID();
  note_place(ui, std::string("split.") + name_of(id));
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    view.split = ViewSettings().split;
  } else if (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0.0f) {
    view.split = std::clamp((double(ImGui::GetIO().MousePos.x) - picture.min.x) / std::max(1, picture.size().x), 0.0, 1.0);
  }
}

/// Whether the name has room at the right of the title, where a tile may have controls.
bool fits_beside_title(const UiContext& ui, const std::string& name, const ViewPicture& picture, const Rect& tile) {
  const double gap = std::round(8.0 * ui.scale), menu = kTextHeight * ui.scale;
  const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(name_px(ui), 1e9f, 0.0f, name.c_str());
  const double title = shown_title(picture, tile.size(), ui.scale).end.x;
  return title + menu + size.x + 2.0f * name_pad(ui) + 2.0 * gap <= tile.size().x;
}

/// In a tile of its own: at the right of the title's row, or below it.
Rect name_tile(UiContext& ui, const std::string& name, const ViewPicture& picture, const Rect& tile, bool at_right, bool beside) {
  const float gap = float(std::round(8.0 * ui.scale));
  const float below = std::max(2.6f * ImGui::GetFontSize(), float(shown_title(picture, tile.size(), ui.scale).end.y) + gap);
  at_right |= beside;
  return name_plate(ui, name,
                    {at_right ? float(tile.max.x) - gap : float(tile.min.x) + gap, float(tile.min.y) + (beside ? gap : below)},
                    at_right, tile);
}

void draw_second(UiContext& ui, ViewId id, const Rect& first, const Rect& second, const ViewImages& first_images,
                 const ViewImages& images, const ViewDrag& drag, ComparedParts& parts) {
  const ViewSettings& view = ui.model.experiment().view;
  ShownPart &part_a = parts.first[std::size_t(id)], &part_b = parts.second[std::size_t(id)];
  const bool split = is_split(id, view);
  const int x = split ? line_x(first, view.split) : first.max.x;
  ImGui::PushClipRect({float(split ? x : second.min.x), float(second.min.y)}, {float(second.max.x), float(second.max.y)}, true);
  draw_tile(ui, id, second, images, drag);
  ImGui::PopClipRect();
  if (split) draw_line(ui, first, x);
  const std::string name_a = comparison_name('A', first_images.analysis()), name_b = comparison_name('B', images.analysis());
  if (split) {
    // Below the title and the view's own controls.
    const float gap = float(std::round(8.0 * ui.scale)), y = float(first.min.y) + 2.6f * ImGui::GetFontSize();
    part_a = part_of(first, {0.0, view.split}, name_plate(ui, name_a, {float(x) - gap, y}, true, first));
    part_b = part_of(first, {view.split, 1.0}, name_plate(ui, name_b, {float(x) + gap, y}, false, second));
    return;
  }
  const bool has_controls = id == ViewId::eye && ui.places.contains("tile.eye_overlay");
  const ViewPicture &a = first_images.picture(id), &b = images.picture(id);
  const bool beside = !has_controls && fits_beside_title(ui, name_a, a, first) && fits_beside_title(ui, name_b, b, second);
  part_a = part_of(first, {0.0, 1.0}, name_tile(ui, name_a, a, first, true, beside));
  part_b = part_of(second, {0.0, 1.0}, name_tile(ui, name_b, b, second, false, beside));
}

}  // namespace

std::string second_input(UiContext& ui, const ViewRects& places, const ViewImages* images, ViewDrag& drag,
                         Experiment& experiment) {
  std::string tag;
  for (ViewId id : kAllViews) {
    const Rect& rect = places[std::size_t(id)];
    if (!images || rect.empty()) continue;
    if (is_split(id, experiment.view)) {
      drag_split(ui, id, rect, experiment.view);
      continue;
    }
    ImGui::PushID("B");
    const std::string step = tile_input(ui, id, rect, *images, drag, experiment);
    ImGui::PopID();
    if (!step.empty()) tag = step;
  }
  return tag;
}

ComparedParts draw_seconds(UiContext& ui, const Layout& layout, const ViewRects& places, const ViewImages& first_images,
                           const ViewImages* images, const ViewDrag& drag) {
  ComparedParts parts;
  for (ViewId id : kAllViews)
    if (images && !places[std::size_t(id)].empty())
      draw_second(ui, id, layout.view(id), places[std::size_t(id)], first_images, *images, drag, parts);
  return parts;
}

}  // namespace psm
