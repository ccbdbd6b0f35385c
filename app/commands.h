// SPDX-License-Identifier: GPL-3.0-or-later
// What each command does, once its flags are separated. Each returns the exit code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/curves.h"
#include "scene/experiment_file.h"

namespace psm {

/// EXPERIMENT and --set, as typed. No source: the default experiment.
struct ExperimentArguments {
  std::optional<std::string> source;
  std::vector<std::string> overrides;
};

struct RenderArguments {
  ExperimentArguments experiment;
  std::optional<std::string> lesson;  // instead of an experiment: a step of a lesson
  bool animation = false;             // of that step
  std::optional<std::string> views;   // none: the step's, or the first four
  std::string out;
  std::optional<std::string> size;  // none: the experiment's image
  std::string scale = "1", theme = "light";
  bool transparent = false;
  std::optional<std::string> sweep;
};

/// `lesson`: a lesson to open, "/3" behind it for its third step; empty: none.
int show_window(const ExperimentArguments& arguments, const std::string& lesson, bool present);
int print_analysis(const ExperimentArguments& arguments, bool texels);
int print_matrices(const ExperimentArguments& arguments, const std::string& language, const std::string& convention);
int print_curves(const CurvesText& text);
int render_views(const RenderArguments& arguments);
int list_scenes();
int write_scenes(const std::string& folder);

/// "1280x720"; errors start with "--size".
Result<glm::ivec2> parse_size(const std::string& text);

/// "world, cube, ...": what --view takes.
std::string view_names();

/// Errors start with the file or the flag.
Result<LoadedExperiment> load(const ExperimentArguments& arguments);

/// An error where `asker` (a flag, a command) would trace more rays than it may, one for each pixel of the image.
std::optional<InputError> check_rays(const ImageSettings& image, const std::string& asker);

/// Each says it in one line and returns the exit code: bad input; anything else; whether standard output took the result.
int bad_input(const InputError& error);
int other_failure(const InputError& error);
int finish_printing(bool printed);

/// Writes to standard output; false where that fails (a closed pipe).
bool print(const std::string& text);

/// One line on standard error.
void complain(const std::string& line);

}  // namespace psm
