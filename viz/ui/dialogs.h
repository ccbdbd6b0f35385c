// SPDX-License-Identifier: GPL-3.0-or-later
// Pop-ups: open, save, what went wrong, the keys, the settings.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/settings.h"
#include "ui/ui_context.h"

namespace psm {

class Dialogs {
 public:
  enum class Kind { none, open, save, picture, progress, error, help, settings, unsaved };

  void show(Kind kind, const std::string& text = "");  // text: the path to begin with, or what went wrong
  /// What went wrong with a path; afterwards the dialog that asked for it is there again, with the path.
  void show_error(const std::string& error, Kind asked, const std::string& path);
  /// How far something has come that goes on until this is closed. `part`: of 1.
  void show_progress(double part, const std::string& text);
  Kind shown() const { return closing_ ? Kind::none : shown_; }
  /// A new pop-up needs some frames until its first field takes keys; those typed meanwhile must wait.
  bool settling() const { return shown() != Kind::none && age_ < 3; }
  /// It can be read and closed, nothing else: Enter closes it.
  bool only_closes() const { return shown() == Kind::error || shown() == Kind::help; }
  void close() { closing_ = true; }

  /// What the user has decided in this frame.
  struct Answer {
    std::optional<std::string> open, save, picture;  // a path
    bool save_first = false, discard = false;        // of the question before quitting
  };
  Answer draw(UiContext& ui, Settings& settings);

 private:
  /// The path, once it is confirmed.
  std::optional<std::string> path_dialog(UiContext& ui, const char* explanation, const char* confirm);
  void list_files(UiContext& ui);
  void progress_dialog(UiContext& ui);
  void error_dialog(UiContext& ui);
  Answer unsaved_dialog(UiContext& ui);
  void help_dialog(UiContext& ui);
  void settings_slider(UiContext& ui, const char* label, int Settings::*member, int low, int high, const char* format,
                       Settings& settings);
  void divider_sliders(UiContext& ui, LayoutSettings& layout);
  void settings_dialog(UiContext& ui, Settings& settings);
  void close_button(UiContext& ui);

  Kind shown_ = Kind::none;
  bool opens_ = false;    // in the next frame
  int age_ = 0;           // frames
  bool closing_ = false;  // at the end of this frame: ImGui must see a pop-up once more to let go of it
  std::string text_;
  double part_ = 0.0;          // of the progress
  Kind back_to_ = Kind::none;  // after an error
  std::string back_path_;
  Settings pending_;                // while a slider of the settings is held
  std::vector<std::string> files_;  // what the folder offers to open
};

}  // namespace psm
