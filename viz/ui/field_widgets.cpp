// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/field_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/tile_menu.h"

namespace psm {
namespace {

std::string last_part(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::string with_unit(const Field& field, double value) {
  const std::string number = shown_number(value);
  if (field.unit == "deg") return number + "°";
  if (field.unit == "texels" || field.unit == "px") return number + " " + field.unit;
  return number;
}

/// Powers of two within the range.
std::vector<Tick> power_ticks(const SliderRange& range) {
  std::vector<Tick> ticks;
  for (double p = std::exp2(std::ceil(std::log2(range.min))); p <= range.max; p *= 2) ticks.push_back({p, "", Role::neutral});
  return ticks;
}

/// What a pixel of dragging is worth.
float drag_speed(const Field& field, double size) {
  if (field.unit == "scene units") return float(size / 400.0);
  return field.unit == "px" ? 2.0f : 0.01f;
}

struct RowWidgets {
  UiContext& ui;
  const Field& field;
  Experiment& experiment;
  double size;
  float width;

  void slider(double& value, const SliderRange& range, const std::vector<Tick>& ticks) const {
    ImGui::SetNextItemWidth(width);
    ticked_slider("##value", value, range, ticks, with_unit(field, value), ui.theme);
    note_place(ui, field.path);
  }

  void component(double& value, int index, const std::string& name, float item_width) const {
    ImGui::PushID(index);
    ImGui::SetNextItemWidth(item_width);
    const char* format = item_width < 6.0f * ImGui::GetFontSize() ? "%.3g" : "%.5g";
    const float speed = field.unit.empty() ? std::max(0.01f, 0.01f * std::abs(float(value))) : drag_speed(field, size);
    ImGui::DragScalar("##component", ImGuiDataType_Double, &value, speed, nullptr, nullptr, format,
                      ImGuiSliderFlags_NoRoundToFormat);
    note_place(ui, name);
    ImGui::PopID();
  }

  template <class Vector>
  void components(Vector& v) const {
    constexpr const char* names[] = {".x", ".y", ".z", ".w"};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const int count = Vector::length();
    const float each = std::floor((width - gap * float(count - 1)) / float(count));
    for (int i = 0; i < count; ++i) {
      if (i > 0) ImGui::SameLine(0.0f, gap);
      component(v[i], i, field.path + names[i], each);
    }
  }

  void operator()(const NumberRef& ref) const {
    double& value = ref(experiment);
    const auto range = slider_range(field, size);
    if (field.may_be_infinite) return or_infinite(value, *range);
    if (range)
      slider(value, *range, {});
    else
      component(value, 0, field.path, width);
  }

  void or_infinite(double& value, const SliderRange& range) const {
    bool infinite = std::isinf(value);
    if (ImGui::Checkbox("∞", &infinite)) value = infinite ? std::numeric_limits<double>::infinity() : finite_default(range);
    note_place(ui, field.path + ".infinite");
    ImGui::SameLine();
    const RowWidgets rest{ui, field, experiment, size, ImGui::GetContentRegionAvail().x - (full_width() - width)};
    ImGui::BeginDisabled(infinite);
    rest.slider(value, range, {});
    ImGui::EndDisabled();
  }
  double finite_default(const SliderRange& range) const {
    Experiment original = ui.model.original();
    const double value = std::get<NumberRef>(field.member)(original);
    return std::isinf(value) ? range.max : value;
  }
  float full_width() const { return width + reset_width(); }
  static float reset_width() { return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x; }

  void operator()(const IntRef& ref) const {
    int& value = ref(experiment);
    const auto range = slider_range(field, size);
    if (!range) {
      ImGui::SetNextItemWidth(width);
      ImGui::DragInt("##value", &value, drag_speed(field, size), int(field.min), int(field.max), ("%d " + field.unit).c_str());
      return note_place(ui, field.path);
    }
    double number = value;
    slider(number, *range, power_ticks(*range));
    if (number != value && std::isfinite(number)) value = int(std::lround(std::clamp(number, field.min, field.max)));
  }
  void operator()(const Vec2Ref& ref) const { components(ref(experiment)); }
  void operator()(const Vec3Ref& ref) const { components(ref(experiment)); }

  /// "auto" with a check mark, else the value. `standard`: where the value begins when "auto" goes.
  template <class Value, class Draw>
  void or_absent(std::optional<Value>& value, const Value& standard, Draw draw) const {
    bool absent = !value;
    if (ImGui::Checkbox(field.absent == "null" ? "none" : field.absent.c_str(), &absent))
      value = absent ? std::nullopt : std::optional<Value>(standard);
    note_place(ui, field.path + ".absent");
    if (value) draw(*value);
  }
  /// The rules and "number" to choose from; a number begins at the shift in use.
  void operator()(const ShiftRef& ref) const {
    CameraShift& shift = ref(experiment);
    double* number = std::get_if<double>(&shift);
    ImGui::SetNextItemWidth(number ? std::floor(0.5f * width) : width);
    const bool open = ImGui::BeginCombo("##rule", number ? "number" : name_of(std::get<ShiftRule>(shift)));
    note_place(ui, field.path + ".rule");
    if (open) {
      const auto item = [&](const char* name, bool current, const CameraShift& value) {
        if (ImGui::Selectable(name, current)) shift = value;
        note_place(ui, field.path + "=" + name);
      };
      for (ShiftRule rule : {ShiftRule::automatic, ShiftRule::in_front, ShiftRule::inside})
        item(name_of(rule), shift == CameraShift(rule), rule);
      item("number", number != nullptr, ui.model.analysis().camera_shift);
      ImGui::EndCombo();
    }
    if (!(number = std::get_if<double>(&shift))) return;
    ImGui::SameLine();
    component(*number, 0, field.path, ImGui::GetContentRegionAvail().x - reset_width());
  }
  /// A menu for each tile, and one more to open another.
  void operator()(const TilesRef& ref) const {
    std::vector<ViewId>& tiles = ref(experiment);
    const std::size_t shown = std::min(tiles.size() + 1, kMostTiles);
    const float half = std::floor(0.5f * (full_width() - ImGui::GetStyle().ItemInnerSpacing.x));
    for (std::size_t place = 0; place < shown; ++place) {
      if (place % 2 == 1) ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
      tile_field(ui, field.path + "." + std::to_string(place), half, place, tiles);
    }
  }
  void operator()(const AutoPixelRef& ref) const {
    const ImageSettings& image = experiment.image;
    or_absent(ref(experiment), {0.5 * image.width, 0.5 * image.height}, [this](glm::dvec2& pixel) { components(pixel); });
  }
  void operator()(const AutoPlaneRef& ref) const {
    // The plane in use is the best start for one to drag.
    const glm::dvec4 standard = ui.model.analysis().vanishing_plane.value_or(glm::dvec4(0, 1, 0, 0));
    const bool usable = glm::length(glm::dvec3(standard)) > 0.0;
    or_absent(ref(experiment), usable ? standard : glm::dvec4(0, 1, 0, 0), [this](glm::dvec4& plane) { components(plane); });
  }

  void operator()(const Choice& choice) const {
    const int current = choice.get(experiment);
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo("##value", choice.names[std::size_t(current)].c_str());
    note_place(ui, field.path);
    if (!open) return;
    for (int i = 0; i < int(choice.names.size()); ++i) {
      if (ImGui::Selectable(choice.names[std::size_t(i)].c_str(), i == current)) choice.set(experiment, i);
      note_place(ui, field.path + "=" + choice.names[std::size_t(i)]);
    }
    ImGui::EndCombo();
  }

  void operator()(const TextRef& ref) const {
    char text[4097];
    std::snprintf(text, sizeof text, "%s", ref(experiment).c_str());
    ImGui::SetNextItemWidth(width);
    if (ImGui::InputText("##value", text, sizeof text, ImGuiInputTextFlags_EnterReturnsTrue)) ref(experiment) = text;
    note_place(ui, field.path);
  }
};

std::string field_tooltip(const Field& field, const Experiment& experiment) {
  return field.help + "\n" + value_text(field, experiment) + (field.unit.empty() ? "" : " " + field.unit) +
         "; allowed: " + allowed_values(field);
}

bool needs_own_line(const Field& field) {
  return std::holds_alternative<Vec3Ref>(field.member) || std::holds_alternative<TilesRef>(field.member) ||
         std::holds_alternative<AutoPixelRef>(field.member) || std::holds_alternative<AutoPlaneRef>(field.member);
}

void reset_button(UiContext& ui, const Field& field, Experiment& experiment) {
  const bool differs = value_text(field, experiment) != value_text(field, ui.model.original());
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - ImGui::GetFrameHeight());
  if (!differs) return ImGui::Dummy({ImGui::GetFrameHeight(), ImGui::GetFrameHeight()});
  if (ImGui::Button("↺", {ImGui::GetFrameHeight(), ImGui::GetFrameHeight()})) copy_field(field, ui.model.original(), experiment);
  note_place(ui, field.path + ".reset");
  rest_tooltip("Back to " + value_text(field, ui.model.original()));
}

}  // namespace

std::string field_group(const Field& field) {
  return field.pane_group.empty() ? field.path.substr(0, field.path.find('.')) : field.pane_group;
}

std::string field_label(const Field& field) {
  std::string label = field.path.substr(field.path.find('.') + 1);
  std::replace(label.begin(), label.end(), '.', ' ');
  std::replace(label.begin(), label.end(), '_', ' ');
  if (label.size() > 4 && label.ends_with(" deg")) label.resize(label.size() - 4);
  if (label == "vertical fov") label = "field of view";
  return label;
}

double scene_size(const Scene& scene) {
  const double size = scene.bounds.empty() ? 1.0 : glm::length(scene.bounds.max - scene.bounds.min);
  return size > 0.0 && std::isfinite(size) ? size : 1.0;
}

std::optional<SliderRange> slider_range(const Field& field, double size) {
  const std::string name = last_part(field.path);
  if (field.unit == "deg") {
    const double inset = field.open_min ? 1.0 : 0.0;
    return SliderRange{std::max(field.min, -180.0) + inset, std::min(field.max, 180.0) - inset, false, false};
  }
  if (name == "near" || name == "far") return SliderRange{size * 1e-4, size * 1e2, true, false};
  if (name == "resolution") return SliderRange{field.min, field.max, true, true};
  if (name == "depth_bias" || name == "normal_bias") return SliderRange{0.0, 10.0, false, false};
  if (name == "slope_bias" || name == "radius" || name == "world_to_cube") return SliderRange{0.0, 1.0, false, false};
  if (name == "filter_size") return SliderRange{field.min, field.max, false, true, 2.0};
  if (name == "map_zoom") return SliderRange{0.1, 1000.0, true, false};
  return std::nullopt;
}

int field_row_lines(const Field& field) {
  if (!needs_own_line(field)) return 1;
  return std::holds_alternative<Vec3Ref>(field.member) ? 2 : 3;
}

void field_row(UiContext& ui, const Field& field, Experiment& experiment, const std::string& label) {
  if (!field.applies(experiment)) return;
  ImGui::PushID(field.path.c_str());
  const float region = ImGui::GetContentRegionAvail().x, left = ImGui::GetCursorPosX(),
              gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const bool own_line = needs_own_line(field);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted((label.empty() ? field_label(field) : label).c_str());
  const float text_end = ImGui::GetItemRectSize().x + gap;
  if (own_line) ImGui::SameLine();
  if (own_line) reset_button(ui, field, experiment);
  if (!own_line) ImGui::SameLine(left + std::max(std::floor(region * 0.36f), text_end));
  const float width = ImGui::GetContentRegionAvail().x - (own_line ? 0.0f : ImGui::GetFrameHeight() + gap);
  ImGui::BeginGroup();
  std::visit(RowWidgets{ui, field, experiment, scene_size(ui.model.scene()), std::max(16.0f, width)}, field.member);
  ImGui::EndGroup();
  rest_tooltip(field_tooltip(field, experiment));
  if (!own_line) ImGui::SameLine();
  if (!own_line) reset_button(ui, field, experiment);
  ImGui::PopID();
}

}  // namespace psm
