// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/keys.h"
#include "ui/theme.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

const char* title_of(Dialogs::Kind kind) {
  switch (kind) {
    case Dialogs::Kind::open:
      return "Open";
    case Dialogs::Kind::save:
      return "Save experiment";
    case Dialogs::Kind::picture:
      return "Save picture";
    case Dialogs::Kind::progress:
      return "Saving";
    case Dialogs::Kind::error:
      return "That did not work";
    case Dialogs::Kind::help:
      return "Keys and mouse";
    case Dialogs::Kind::unsaved:
      return "Save the experiment?";
    default:
      return "Settings";
  }
}

bool can_be_opened(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".glb") || name.ends_with(".gltf") || name.ends_with(".psm.json");
}

std::vector<std::string> files_here() {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator it(".", error), end; !error && it != end && files.size() < 500; it.increment(error))
    if (can_be_opened(it->path())) files.push_back(it->path().filename().string());
  std::sort(files.begin(), files.end());
  return files;
}

float em() { return ImGui::GetFontSize(); }

/// Two columns: what to press or do, and what happens.
void help_row(const char* what, const char* effect) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(what);
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", effect);
}

bool button(UiContext& ui, const char* label, const std::string& place) {
  const bool pressed = ImGui::Button(label, {std::max(5.0f * em(), ImGui::CalcTextSize(label).x + 1.5f * em()), 0.0f});
  note_place(ui, place);
  return pressed;
}

}  // namespace

void Dialogs::show(Kind kind, const std::string& text) {
  shown_ = kind;
  opens_ = true;
  closing_ = false;
  age_ = 0;
  text_ = text;
  back_to_ = Kind::none;
  if (kind == Kind::open) files_ = files_here();
}

void Dialogs::show_error(const std::string& error, Kind asked, const std::string& path) {
  show(Kind::error, error);
  back_to_ = asked;
  back_path_ = path;
}

void Dialogs::show_progress(double part, const std::string& text) {
  if (shown() != Kind::progress) show(Kind::progress);
  part_ = part;
  text_ = text;
}

Dialogs::Answer Dialogs::draw(UiContext& ui, Settings& settings) {
  Answer answer;
  if (shown_ == Kind::none) return answer;
  ++age_;
  const char* title = title_of(shown_);
  if (opens_) ImGui::OpenPopup(title);
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(viewport->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({std::min(24.0f * em(), viewport->Size.x), 0.0f},
                                      {std::max(1.0f, 0.92f * viewport->Size.x), std::max(1.0f, 0.92f * viewport->Size.y)});
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove)) {
    if (!opens_) shown_ = Kind::none;
    return answer;
  }
  if (shown_ == Kind::open)
    answer.open = path_dialog(ui, "An experiment (.psm.json), a .gltf or .glb file, or a scene's name:", "Open");
  if (shown_ == Kind::save) answer.save = path_dialog(ui, "Where to save the experiment:", "Save");
  if (shown_ == Kind::picture)
    answer.picture = path_dialog(ui, "The views as .png, .svg or .pdf; a lesson's animation as .mp4 or .gif:", "Save");
  if (shown_ == Kind::progress) progress_dialog(ui);
  if (shown_ == Kind::error) error_dialog(ui);
  if (shown_ == Kind::unsaved) answer = unsaved_dialog(ui);
  if (shown_ == Kind::help) help_dialog(ui);
  if (shown_ == Kind::settings) settings_dialog(ui, settings);
  opens_ = false;
  if (closing_) ImGui::CloseCurrentPopup();
  if (closing_) shown_ = Kind::none;
  closing_ = false;
  ImGui::EndPopup();
  if (shown_ == Kind::none && back_to_ != Kind::none) show(back_to_, std::string(back_path_));
  return answer;
}

std::optional<std::string> Dialogs::path_dialog(UiContext& ui, const char* explanation, const char* confirm) {
  ImGui::TextUnformatted(explanation);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(std::min(30.0f * em(), 0.8f * ImGui::GetMainViewport()->Size.x));
  bool confirmed = ImGui::InputText("##path", &text_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  note_place(ui, "dialog.path");
  if (shown_ == Kind::open) list_files(ui);
  confirmed |= button(ui, confirm, "dialog.confirm");
  ImGui::SameLine();
  const bool cancelled = button(ui, "Cancel", "dialog.cancel");
  if (cancelled) close();
  if (!confirmed || text_.empty()) return std::nullopt;
  close();
  return text_;
}

void Dialogs::list_files(UiContext& ui) {
  if (files_.empty()) return ImGui::TextDisabled("Files can also be dropped on the window.");
  const float lines = float(std::min<std::size_t>(files_.size(), 8));
  if (ImGui::BeginListBox("##files", {std::min(30.0f * em(), 0.8f * ImGui::GetMainViewport()->Size.x),
                                      lines * ImGui::GetTextLineHeightWithSpacing() + em()})) {
    for (const std::string& file : files_) {
      if (ImGui::Selectable(file.c_str(), file == text_)) text_ = file;
      note_place(ui, "dialog.file=" + file);
    }
    ImGui::EndListBox();
  }
}

void Dialogs::close_button(UiContext& ui) {
  if (button(ui, "Close", "dialog.confirm")) close();
}

void Dialogs::progress_dialog(UiContext& ui) {
  const float width = std::min(28.0f * em(), 0.8f * ImGui::GetMainViewport()->Size.x);
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, color(accent_color(ui.theme)));
  ImGui::ProgressBar(float(part_), {width, 0.0f}, "");
  ImGui::PopStyleColor();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::TextUnformatted(text_.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  if (button(ui, "Cancel", "dialog.cancel")) close();
}

void Dialogs::error_dialog(UiContext& ui) {
  ImGui::PushTextWrapPos(std::min(32.0f * em(), 0.85f * ImGui::GetMainViewport()->Size.x));
  ImGui::TextUnformatted(text_.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  close_button(ui);
}

Dialogs::Answer Dialogs::unsaved_dialog(UiContext& ui) {
  Answer answer;
  ImGui::TextUnformatted("The experiment has changed since it was opened or saved.");
  ImGui::TextDisabled("Enter or S saves, D discards the changes, Esc goes on working.");
  ImGui::Spacing();
  const auto typed = [&](char letter) { return !settling() && ImGui::IsKeyPressed(letter, false); };
  const auto enter = [&] {
    return !settling() && (ImGui::IsKeyPressed(key::enter, false) || ImGui::IsKeyPressed(key::keypad_enter, false));
  };
  // Enter belongs to the button that has the focus, Save at first.
  const auto choice = [&](const char* label, const char* place) {
    return button(ui, label, place) || (ImGui::IsItemFocused() && enter());
  };
  answer.save_first = choice("Save…", "dialog.save") || typed('S');
  ImGui::SetItemDefaultFocus();
  ImGui::SameLine();
  answer.discard = choice("Discard", "dialog.discard") || typed('D');
  ImGui::SameLine();
  const bool cancelled = choice("Cancel", "dialog.cancel");
  if (cancelled || answer.save_first || answer.discard) close();
  return answer;
}

void Dialogs::help_dialog(UiContext& ui) {
  const ImVec2 room = ImGui::GetMainViewport()->Size;
  const ImVec2 size(std::max(1.0f, std::min(36.0f * em(), 0.85f * room.x)),
                    std::max(1.0f, std::min(34.0f * em(), 0.72f * room.y)));
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY, size)) {
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, 11.0f * em());
    ImGui::TableSetupColumn("effect", ImGuiTableColumnFlags_WidthStretch);
    for (const KeyBinding& binding : key_bindings()) help_row(binding.name, binding.text);
    help_row("left drag", "turn a view; the eye view turns the experiment's camera; the map moves");
    help_row("Shift or middle drag", "move a view");
    help_row("wheel", "nearer and farther");
    help_row("drag a circle", "move the camera, the light or a target in the world view; with Shift along the vertical");
    help_row("arrow keys", "move the selected handle (key N); with Shift along the vertical, with Ctrl finely; Esc lets it go");
    help_row("double click", "one view alone, and back; on a divider: back to the middle");
    help_row("Ctrl+click on a slider", "type the value; Alt while dragging: no snapping");
    ImGui::EndTable();
  }
  close_button(ui);
}

// Taken over when let go: a slider must not change its own size under the mouse.
void Dialogs::settings_slider(UiContext& ui, const char* label, int Settings::*member, int low, int high, const char* format,
                              Settings& settings) {
  ImGui::SetNextItemWidth(12.0f * em());
  ImGui::SliderInt(label, &(pending_.*member), low, high, format, ImGuiSliderFlags_AlwaysClamp);
  note_place(ui, std::string("settings.") + label);
  if (!ImGui::IsItemActive()) settings.*member = pending_.*member;
}

/// The dividers, for the keyboard.
void Dialogs::divider_sliders(UiContext& ui, LayoutSettings& layout) {
  const auto part = [&](const char* label, double LayoutSettings::*member, double low, double high) {
    ImGui::SetNextItemWidth(8.0f * em());
    ImGui::SliderScalar(label, ImGuiDataType_Double, &(layout.*member), &low, &high, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    note_place(ui, std::string("settings.") + label);
  };
  ImGui::TextUnformatted("widths and heights, as parts of the room");
  part("lesson", &LayoutSettings::lesson, 0.2, 0.6);
  ImGui::SameLine();
  part("controls", &LayoutSettings::pane, 0.15, 0.6);
  part("left views", &LayoutSettings::column, 0.1, 0.9);
  ImGui::SameLine();
  part("upper views", &LayoutSettings::row, 0.1, 0.9);
}

void Dialogs::settings_dialog(UiContext& ui, Settings& settings) {
  if (opens_) pending_ = settings;
  settings_slider(ui, "scale", &Settings::scale_percent, 75, 300, "%d %%", settings);
  settings_slider(ui, "font size", &Settings::font_px, 12, 32, "%d px", settings);
  for (int percent : {75, 100, 125, 150, 200, 300}) {
    if (percent != 75) ImGui::SameLine();
    const std::string label = std::to_string(percent) + " %";
    if (ImGui::Button(label.c_str())) settings.scale_percent = pending_.scale_percent = percent;
    note_place(ui, "settings." + std::to_string(percent));
  }
  int theme = int(settings.theme);
  ImGui::RadioButton("light", &theme, int(Theme::light));
  ImGui::SameLine();
  ImGui::RadioButton("dark", &theme, int(Theme::dark));
  settings.theme = Theme(theme);
  int source = int(settings.points_from);
  ImGui::Spacing();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("visible points from");
  ImGui::SameLine();
  ImGui::RadioButton("rays", &source, int(PointsSource::rays));
  note_place(ui, "settings.points=rays");
  ImGui::SameLine();
  ImGui::RadioButton("depth readback", &source, int(PointsSource::depth));
  note_place(ui, "settings.points=depth");
  rest_tooltip(
      "Rays answer in the same frame. The card's depth (PSM 2002, section 6) is read back without waiting: it answers a "
      "frame or more later. The profile shows what each costs.");
  settings.points_from = PointsSource(source);
  divider_sliders(ui, settings.layout);
  ImGui::Checkbox("the texel under the mouse shows in all views", &settings.hovering);
  note_place(ui, "settings.hovering");
  ImGui::Checkbox("reduced motion", &settings.reduced_motion);
  note_place(ui, "settings.reduced_motion");
  rest_tooltip("What is played, such as the camera shift, is at its end at once.");
  ImGui::Spacing();
  close_button(ui);
}

}  // namespace psm
