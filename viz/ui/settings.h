// SPDX-License-Identifier: GPL-3.0-or-later
// What belongs to the user and the machine, not to the experiment: sizes, theme, places of the dividers.
#pragma once

#include <filesystem>

#include "gl/renderer.h"
#include "scene/light_quiz.h"
#include "scene/matrix_text.h"
#include "ui/points_source.h"

namespace psm {

/// Places of the dividers as fractions, and what is hidden.
struct LayoutSettings {
  double lesson = 0.36;  // of the width
  double pane = 0.28;    // of the width
  double column = 0.5;   // of what the pane leaves
  double row = 0.5;      // of what the badge bar leaves
  bool pane_shown = true;
  bool lesson_shown = false;  // of this run alone
  bool operator==(const LayoutSettings&) const = default;
};

struct Settings {
  int scale_percent = 100;  // 75 to 300
  int font_px = 18;         // body text at 100 %: 12 to 32
  Theme theme = Theme::light;
  PointsSource points_from = PointsSource::rays;
  bool reduced_motion = false;  // what would move is there at once
  bool hovering = true;         // the texel under the mouse shows in all views
  MatrixLanguage matrix_language = MatrixLanguage::glsl;
  ClipConvention clip_convention = ClipConvention::opengl;
  LayoutSettings layout;
  QuizScore quiz;          // of all quizzes so far
  bool start_card = true;  // nobody has closed it yet
  bool operator==(const Settings&) const = default;
};

/// Everything back into its range.
Settings clamped(Settings settings);

/// $XDG_CONFIG_HOME/psmlab/settings.txt, or ~/.config/psmlab/settings.txt; empty where there is no home.
std::filesystem::path settings_file();

/// Lines "name value". Absent files, unknown names and bad values are no problem: the defaults stand.
Settings read_settings(const std::filesystem::path& file);

/// False if it could not be written; nobody's work depends on it.
bool write_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace psm
