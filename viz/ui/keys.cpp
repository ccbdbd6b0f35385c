// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/keys.h"

namespace psm {

const std::vector<KeyBinding>& key_bindings() {
  constexpr Modifiers none{}, control{true, false, false}, control_shift{true, true, false}, shift{false, true, false};
  static const std::vector<KeyBinding> table = {
      {key::f1, none, Action::help, "F1", "list the keys"},
      {'1', none, Action::maximise_world, "1", "world view alone"},
      {'2', none, Action::maximise_cube, "2", "unit cube alone"},
      {'3', none, Action::maximise_map, "3", "shadow map alone"},
      {'4', none, Action::maximise_eye, "4", "eye view alone"},
      {'5', none, Action::maximise_body, "5", "body H alone"},
      {'6', none, Action::maximise_curves, "6", "curves alone"},
      {'7', none, Action::maximise_explorer, "7", "explorer of lights alone"},
      {'0', none, Action::show_all, "0", "the tiles again"},
      {key::escape, none, Action::show_all, "Esc", "the tiles again"},
      {'F', none, Action::fit_views, "F", "views back to where they show everything"},
      {'T', none, Action::technique_next, "T", "next technique"},
      {'T', shift, Action::technique_previous, "Shift+T", "previous technique"},
      {'A', none, Action::play_camera_shift, "A", "play the camera shift of the PSM techniques, from 0"},
      {'W', none, Action::play_world_to_cube, "W", "cube view: from the cube to the world, or back"},
      {'E', none, Action::eye_overlay_next, "E", "eye view: picture, texel size m, anisotropy, errors, penumbra"},
      {'G', none, Action::toggle_texel_grid, "G", "texel grid on the receivers, on or off"},
      {'X', none, Action::pin_probe, "X", "keep the texel under the mouse shown, or let it go"},
      {'N', none, Action::handle_next, "N", "select the next handle of the world view; the arrow keys move it"},
      {'N', shift, Action::handle_previous, "Shift+N", "select the handle before"},
      {'B', none, Action::compare, "B", "compare with a second technique, B: the uniform map at first"},
      {'B', shift, Action::compare_layout, "Shift+B", "A and B divided by a line that can be dragged, or side by side"},
      {key::left, control, Action::split_left, "Ctrl+←", "the line between A and B to the left"},
      {key::right, control, Action::split_right, "Ctrl+→", "and to the right"},
      {'L', none, Action::toggle_lesson, "L", "open the lessons, or hide them"},
      {'Q', none, Action::toggle_quiz, "Q", "quiz about light cases, in the explorer"},
      {'R', none, Action::reset, "R", "experiment back to how it was opened"},
      {'Z', control, Action::undo, "Ctrl+Z", "undo"},
      {'Y', control, Action::redo, "Ctrl+Y", "redo"},
      {'Z', control_shift, Action::redo, "Ctrl+Shift+Z", "redo"},
      {'O', control, Action::open, "Ctrl+O", "open an experiment or a glTF file"},
      {'S', control, Action::save, "Ctrl+S", "save the experiment"},
      {'P', none, Action::save_picture, "P",
       "save the views as a picture: .png, .svg or .pdf; a lesson's animation as a film: .mp4 or .gif"},
      {key::f12, none, Action::save_screen, "F12", "save a PNG of the window, or of the view that is alone, at once"},
      {'C', control, Action::copy_state, "Ctrl+C", "copy the experiment as JSON"},
      {'C', control_shift, Action::copy_share_text, "Ctrl+Shift+C",
       "copy the experiment as one short line, to send and to paste"},
      {'V', control, Action::paste, "Ctrl+V", "open the experiment that was copied, as a line or as JSON"},
      {'M', none, Action::copy_matrices, "M", "copy the matrices, in the language and clip space chosen under the numbers"},
      {'C', none, Action::copy_curves, "C", "copy what the curves view plots as CSV"},
      {'H', none, Action::toggle_pane, "H", "hide or show the control pane"},
      {key::f6, none, Action::next_pane, "F6",
       "the keyboard to the next pane: lesson, controls, quiz; arrows go on, Space presses, Ctrl+Space or Enter types"},
      {'D', none, Action::toggle_theme, "D", "light or dark theme"},
      {key::f3, none, Action::toggle_profile, "F3", "hide or show the profile: what a frame computed, and how long it took"},
      {',', control, Action::settings, "Ctrl+,", "settings: scale, font size, theme"},
      {'=', control, Action::bigger, "Ctrl+=", "everything bigger"},
      {'-', control, Action::smaller, "Ctrl+-", "everything smaller"},
      {key::f11, none, Action::present, "F11", "in front of a class: large type, no controls; Esc leaves it"},
      {key::f5, none, Action::present, "F5", "the same"},
      {key::page_down, none, Action::next_screen, "Page Down",
       "lesson: next step, after the last the next lesson; in front of a class: the answer, the next screen, or one view after "
       "the other"},
      {key::right, none, Action::next_screen, "→", "the same"},
      {key::page_up, none, Action::previous_screen, "Page Up", "the step or the view before"},
      {key::backspace, none, Action::lesson_back, "Backspace", "lesson: back to where you followed a link to another one"},
      {key::left, none, Action::previous_screen, "←", "the same"},
      {'.', none, Action::black_screen, ".", "in front of a class: a black screen, until any key"},
      {key::enter, none, Action::show_answer, "Enter",
       "lesson in front of a class: the answer; a task's next hint, then its solution"},
      {'Q', control, Action::quit, "Ctrl+Q", "close psmlab"},
  };
  return table;
}

std::optional<Action> action_of(const KeyPress& press) {
  for (const KeyBinding& binding : key_bindings())
    if (binding.key == press.key && binding.modifiers == press.modifiers) return binding.action;
  return std::nullopt;
}

}  // namespace psm
