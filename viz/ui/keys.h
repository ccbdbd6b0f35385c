// SPDX-License-Identifier: GPL-3.0-or-later
// The keys: one table that binds them and that the help (F1) prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/input_queue.h"

namespace psm {

enum class Action {
  help,
  undo,
  redo,
  open,
  save,
  save_picture,
  save_screen,
  reset,
  fit_views,
  maximise_world,
  maximise_cube,
  maximise_map,
  maximise_eye,
  maximise_body,
  maximise_curves,
  maximise_explorer,
  show_all,
  toggle_pane,
  next_pane,
  toggle_theme,
  settings,
  toggle_profile,
  bigger,
  smaller,
  technique_next,
  technique_previous,
  play_camera_shift,
  play_world_to_cube,
  eye_overlay_next,
  toggle_texel_grid,
  pin_probe,
  handle_next,
  handle_previous,
  compare,
  compare_layout,
  split_left,
  split_right,
  toggle_quiz,
  copy_curves,
  copy_state,
  copy_share_text,
  copy_matrices,
  paste,
  present,
  next_screen,
  previous_screen,
  black_screen,
  show_answer,
  toggle_lesson,
  lesson_back,
  quit
};

struct KeyBinding {
  int key;
  Modifiers modifiers;
  Action action;
  const char* name;  // as printed: "Ctrl+Z"
  const char* text;  // what it does
};

/// In the order in which the help lists them.
const std::vector<KeyBinding>& key_bindings();

/// What this key does, if anything.
std::optional<Action> action_of(const KeyPress& press);

}  // namespace psm
