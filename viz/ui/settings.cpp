// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "scene/experiment_file.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

/// Reads `value` only where the whole word is a number.
void take_number(const std::string& word, double& value) {
  char* end = nullptr;
  const double read = std::strtod(word.c_str(), &end);
  if (!word.empty() && end == word.c_str() + word.size() && std::isfinite(read)) value = read;
}

void take_int(const std::string& word, int& value) {
  double number = value;
  take_number(word, number);
  value = int(std::clamp(number, -1e6, 1e6));
}

void take(Settings& s, const std::string& name, const std::string& word) {
  if (name == "scale_percent") take_int(word, s.scale_percent);
  if (name == "font_px") take_int(word, s.font_px);
  if (name == "theme" && word == "dark") s.theme = Theme::dark;
  if (name == "theme" && word == "light") s.theme = Theme::light;
  if (name == "visible_points" && word == "depth") s.points_from = PointsSource::depth;
  if (name == "visible_points" && word == "rays") s.points_from = PointsSource::rays;
  if (name == "reduced_motion") s.reduced_motion = word != "0";
  if (name == "hovering") s.hovering = word != "0";
  if (name == "matrix_language") s.matrix_language = matrix_language_from_name(word).value_or(s.matrix_language);
  if (name == "clip_convention") s.clip_convention = clip_convention_from_name(word).value_or(s.clip_convention);
  if (name == "lesson") take_number(word, s.layout.lesson);
  if (name == "pane") take_number(word, s.layout.pane);
  if (name == "column") take_number(word, s.layout.column);
  if (name == "row") take_number(word, s.layout.row);
  if (name == "quiz_right") take_int(word, s.quiz.right);
  if (name == "quiz_answers") take_int(word, s.quiz.answers);
  if (name == "start_card") s.start_card = word != "0";
  if (name == "pane_shown") s.layout.pane_shown = word != "0";
}

}  // namespace

Settings clamped(Settings s) {
  s.scale_percent = std::clamp(s.scale_percent, 75, 300);
  s.font_px = std::clamp(s.font_px, 12, 32);
  s.layout.pane = std::clamp(s.layout.pane, 0.15, 0.6);
  s.layout.lesson = std::clamp(s.layout.lesson, 0.2, 0.6);
  s.layout.column = std::clamp(s.layout.column, 0.1, 0.9);
  s.layout.row = std::clamp(s.layout.row, 0.1, 0.9);
  s.quiz.answers = std::max(0, s.quiz.answers);
  s.quiz.right = std::clamp(s.quiz.right, 0, s.quiz.answers);
  return s;
}

fs::path settings_file() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config && fs::path(config).is_absolute()) return fs::path(config) / "psmlab" / "settings.txt";
  const char* home = std::getenv("HOME");
  return home && *home ? fs::path(home) / ".config" / "psmlab" / "settings.txt" : fs::path();
}

Settings read_settings(const fs::path& file) {
  Settings settings;
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string name, value;
    if (words >> name >> value) take(settings, name, value);
  }
  return clamped(settings);
}

bool write_settings(const Settings& s, const fs::path& file) {
  if (file.empty()) return false;
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "scale_percent " << s.scale_percent << "\nfont_px " << s.font_px << "\ntheme "
      << (s.theme == Theme::dark ? "dark" : "light") << "\nvisible_points "
      << (s.points_from == PointsSource::depth ? "depth" : "rays") << "\nreduced_motion " << int(s.reduced_motion)
      << "\nhovering " << int(s.hovering) << "\nmatrix_language " << name_of(s.matrix_language) << "\nclip_convention "
      << name_of(s.clip_convention) << "\nlesson " << s.layout.lesson << "\npane " << s.layout.pane << "\ncolumn "
      << s.layout.column << "\nrow " << s.layout.row << "\npane_shown " << int(s.layout.pane_shown) << "\nquiz_right "
      << s.quiz.right << "\nquiz_answers " << s.quiz.answers << "\nstart_card " << int(s.start_card) << "\n";
  return !write_file_atomically(file, out.str());
}

}  // namespace psm
