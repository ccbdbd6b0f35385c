// SPDX-License-Identifier: GPL-3.0-or-later
// What keys and menus make the workbench do.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <random>

#include "draw/curves_view.h"
#include "scene/curve_csv.h"
#include "scene/matrix_text.h"
#include "scene/share_text.h"
#include "ui/workbench.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

bool is_modifier(int code) { return code >= key::shift && code <= key::right_super; }

std::string scene_stem(const Experiment& experiment) { return fs::path(experiment.scene.source).stem().string(); }

std::optional<ViewId> view_of(Action action) {
  switch (action) {
    case Action::maximise_world:
      return ViewId::world;
    case Action::maximise_cube:
      return ViewId::cube;
    case Action::maximise_map:
      return ViewId::map;
    case Action::maximise_eye:
      return ViewId::eye;
    case Action::maximise_body:
      return ViewId::body;
    case Action::maximise_curves:
      return ViewId::curves;
    case Action::maximise_explorer:
      return ViewId::explorer;
    default:
      return std::nullopt;
  }
}

}  // namespace

void Workbench::take_keys(const std::vector<KeyPress>& presses) {
  for (const KeyPress& press : presses) {
    if (!is_modifier(press.key) && movements_.finish_reveal(ImGui::GetTime())) continue;  // the key that skips it
    const bool enter = press.key == key::enter || press.key == key::keypad_enter;
    if (dialogs_.shown() != Dialogs::Kind::none) {
      if (press.key == key::escape || (enter && dialogs_.only_closes())) dialogs_.close();
      continue;
    }
    // Escape in a text field or a menu belongs to it.
    if (is_typing() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) continue;
    if (drag_.selected && press.key == key::escape) {
      drag_.selected.reset();
      continue;
    }
    if (take_start_key(press)) continue;
    if (take_presenting_key(press)) continue;
    if (!key_is_free(press)) continue;
    const bool moves_handle = drag_.selected && (press.key == key::left || press.key == key::right);
    if (const auto action = moves_handle ? std::nullopt : action_of(press)) act(*action);
  }
}

void Workbench::act(Action action) {
  wake();
  switch (action) {
    case Action::handle_next:
      return select_handle(+1);
    case Action::handle_previous:
      return select_handle(-1);
    case Action::present:
      return present(!presenting_);
    case Action::next_screen:
      return step_screen(+1);
    case Action::previous_screen:
      return step_screen(-1);
    case Action::lesson_back:
      return lesson_way_back();
    case Action::show_answer:
      return show_answer();
    case Action::black_screen:
      black_ = presenting_;
      return;
    case Action::help:
      return dialogs_.show(Dialogs::Kind::help);
    case Action::settings:
      return dialogs_.show(Dialogs::Kind::settings);
    case Action::open:
      return dialogs_.show(Dialogs::Kind::open);
    case Action::save:
      return ask_for_path_to_save();
    case Action::undo:
      message_ = model_.undo() ? "undone" : "nothing to undo";
      return;
    case Action::redo:
      message_ = model_.redo() ? "redone" : "nothing to redo";
      return;
    case Action::reset:
      message_.clear();
      return model_.reset();
    case Action::fit_views:
      return fit_views();
    case Action::show_all:
      return maximise(std::nullopt);
    case Action::toggle_pane:
      settings_.layout.pane_shown = !settings_.layout.pane_shown;
      return;
    case Action::toggle_theme:
      settings_.theme = settings_.theme == Theme::light ? Theme::dark : Theme::light;
      return;
    case Action::toggle_profile:
      show_profile_ = !profile_.watched();
      if (*show_profile_) settings_.layout.pane_shown = true;
      return;
    case Action::bigger:
      settings_.scale_percent += 25;
      break;
    case Action::smaller:
      settings_.scale_percent -= 25;
      break;
    case Action::technique_next:
      return change_technique(+1);
    case Action::technique_previous:
      return change_technique(-1);
    case Action::play_camera_shift:
      if (const auto why_not = movements_.play_camera_shift(ImGui::GetTime(), settings_.reduced_motion)) message_ = *why_not;
      return;
    case Action::play_world_to_cube:
      return movements_.play_world_to_cube(ImGui::GetTime(), settings_.reduced_motion);
    case Action::eye_overlay_next:
      return change_eye_overlay();
    case Action::toggle_texel_grid:
      return toggle_texel_grid();
    case Action::pin_probe:
      return pin_probe();
    case Action::compare:
      return toggle_comparison();
    case Action::compare_layout:
      return change_compare_layout();
    case Action::split_left:
      return move_split(-0.02);
    case Action::split_right:
      return move_split(+0.02);
    case Action::next_pane:
      return next_pane();
    case Action::toggle_quiz:
      return toggle_quiz();
    case Action::copy_curves:
      return copy_curves();
    case Action::save_picture:
      return ask_for_picture();
    case Action::save_screen:
      return save_screen();
    case Action::toggle_lesson:
      return toggle_lesson_pane();
    case Action::quit:
      return ask_to_quit();
    case Action::copy_state:
      ImGui::SetClipboardText(experiment_to_json(model_.experiment()).c_str());
      message_ = "experiment copied as JSON";
      return;
    case Action::copy_share_text:
      ImGui::SetClipboardText(share_text(model_.experiment(), model_.scene()).c_str());
      message_ = "experiment copied as one line";
      return;
    case Action::copy_matrices:
      ImGui::SetClipboardText(matrices_text(model_.analysis(), settings_.matrix_language, settings_.clip_convention).c_str());
      message_ =
          std::string("matrices copied as ") + name_of(settings_.matrix_language) + ", " + name_of(settings_.clip_convention);
      return;
    case Action::paste:
      return paste();
    default:
      return maximise(view_of(action));
  }
  settings_ = clamped(settings_);
}

/// A lesson's experiments are not the student's work, which waits behind it.
const Experiment& Workbench::own_experiment() const { return lessons_.run() ? lessons_.own() : model_.experiment(); }

void Workbench::ask_to_quit() {
  wake();
  if (!model_.unsaved(own_experiment()))
    wants_quit_ = true;
  else if (dialogs_.shown() != Dialogs::Kind::unsaved)
    dialogs_.show(Dialogs::Kind::unsaved);
}

std::optional<std::string> Workbench::unsaved_text() const {
  const Experiment& own = own_experiment();
  if (!model_.unsaved(own)) return std::nullopt;
  if (own.scene == model_.experiment().scene) return share_text(own, model_.scene());
  const auto scene = load_scene(own.scene.source, {});
  return scene ? std::optional(share_text(own, *scene)) : std::nullopt;
}

void Workbench::ask_for_path_to_save() { dialogs_.show(Dialogs::Kind::save, scene_stem(model_.experiment()) + ".psm.json"); }

void Workbench::save(const std::string& file) {
  if (const auto error = model_.save(file)) return dialogs_.show_error(error->text, Dialogs::Kind::save, file);
  message_ = "saved " + file;
  wants_quit_ = wants_quit_ || quits_after_save_;
}

void Workbench::commit_now(const Experiment& edited) {
  model_.end_gesture();
  if (model_.commit(edited, "", ImGui::GetTime())) message_.clear();
  model_.end_gesture();
}

void Workbench::maximise(std::optional<ViewId> view) {
  Experiment edited = model_.experiment();
  edited.view.maximised = view;
  commit_now(edited);
}

void Workbench::fit_views() {
  Experiment edited = model_.experiment();
  const ViewSettings fitted;
  edited.view.world = fitted.world, edited.view.cube = fitted.cube, edited.view.body = fitted.body;
  edited.view.map_center = fitted.map_center, edited.view.map_zoom = fitted.map_zoom;
  fitted_.fit_again();
  commit_now(edited);
}

void Workbench::change_technique(int step) {
  const auto& offered = offered_techniques();
  Experiment edited = model_.experiment();
  const auto found = std::find(offered.begin(), offered.end(), edited.shadow.technique);
  const int count = int(offered.size()), at = found == offered.end() ? 0 : int(found - offered.begin());
  edited.shadow.technique = offered[std::size_t((at + step + count) % count)];
  commit_now(edited);
}

void Workbench::change_eye_overlay() {
  Experiment edited = model_.experiment();
  EyeOverlay& overlay = edited.view.eye_overlay;
  overlay = overlay == EyeOverlay::penumbra ? EyeOverlay::none : EyeOverlay(int(overlay) + 1);
  commit_now(edited);
}

void Workbench::toggle_texel_grid() {
  Experiment edited = model_.experiment();
  edited.view.texel_grid = !edited.view.texel_grid;
  commit_now(edited);
}

/// Opens the explorer with it where that is hidden.
void Workbench::toggle_quiz() {
  if (quiz_) return quiz_.reset();
  const ViewSettings& view = model_.experiment().view;
  const bool shown = view.maximised ? *view.maximised == ViewId::explorer
                                    : std::find(view.tiles.begin(), view.tiles.end(), ViewId::explorer) != view.tiles.end();
  if (!shown) maximise(ViewId::explorer);
  quiz_.emplace(std::random_device()(), settings_.quiz);
  quiz_->next(model_.experiment(), model_.scene());
  keyboard_.wanted = "quiz";
}

void Workbench::copy_curves() {
  const CurveKind kind = model_.experiment().view.curve;
  ImGui::SetClipboardText(curve_csv(kind, curve_setting(model_.analysis())).c_str());
  message_ = std::string("copied as CSV: ") + display_name(kind);
}

void Workbench::pin_probe() {
  Experiment edited = model_.experiment();
  const bool over_eye = pointed_ && pointed_->view == ViewId::eye;
  if (edited.view.probe)
    edited.view.probe.reset();
  else if (over_eye)
    edited.view.probe = image_pixel(*pointed_, images_);
  if (edited.view == model_.experiment().view) message_ = "point at a pixel of the eye view first";
  commit_now(edited);
}

// The uniform map is what every technique has to beat; beside it, GMNPR stands for the others.
void Workbench::toggle_comparison() {
  Experiment edited = model_.experiment();
  const bool uniform = edited.shadow.technique == Technique::uniform;
  edited.view.compare =
      edited.view.compare ? std::nullopt : std::optional<Technique>(uniform ? Technique::gmnpr : Technique::uniform);
  commit_now(edited);
}

void Workbench::change_compare_layout() {
  Experiment edited = model_.experiment();
  const bool split = edited.view.compare_layout == CompareLayout::split;
  edited.view.compare_layout = split ? CompareLayout::side_by_side : CompareLayout::split;
  commit_now(edited);
  if (!edited.view.compare)
    message_ = std::string("A and B will be ") + (split ? "side by side" : "split by a line") + " (key B)";
}

void Workbench::move_split(double by) {
  Experiment edited = model_.experiment();
  edited.view.split = std::clamp(edited.view.split + by, 0.0, 1.0);
  if (edited.view.compare)
    commit_now(edited);
  else
    message_ = "the line divides A and B (key B)";
}

/// The keyboard goes to the pane after the one that had it last.
void Workbench::next_pane() {
  const auto& panes = keyboard_.panes;
  if (panes.empty()) return;
  const auto now = std::find(panes.begin(), panes.end(), keyboard_.last);
  keyboard_.wanted = now == panes.end() || now + 1 == panes.end() ? panes.front() : *(now + 1);
}

void Workbench::open(const std::string& source) {
  wake();
  const bool typed = std::exchange(typed_path_, "") == source;
  if (const auto error = model_.open(source))
    return dialogs_.show_error(error->text, typed ? Dialogs::Kind::open : Dialogs::Kind::none, source);
  show_opened("opened " + source);
}

void Workbench::paste() {
  const char* text = ImGui::GetClipboardText();
  if (const auto error = model_.paste(text ? text : "")) return dialogs_.show(Dialogs::Kind::error, error->text);
  show_opened("opened what was copied");
}

void Workbench::show_opened(const std::string& message) {
  drag_ = {};
  fitted_.fit_again();
  message_ = message;
}

std::string Workbench::window_title() const { return "psmlab: " + scene_stem(model_.experiment()); }

}  // namespace psm
