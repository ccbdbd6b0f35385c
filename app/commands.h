// SPDX-License-Identifier: GPL-3.0-or-later
// What each command does, once its flags are separated. Each returns the exit code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/curves.h"

namespace psm {

/// EXPERIMENT and --set, as typed. No source: the default experiment.
struct ExperimentArguments {
  std::optional<std::string> source;
  std::vector<std::string> overrides;
};

struct RenderArguments {
  ExperimentArguments experiment;
  std::optional<std::string> views;  // none: all four
  std::string out;
  std::optional<std::string> size;  // none: the experiment's image
  std::string scale = "1", theme = "light";
};

int show_window(const ExperimentArguments& arguments);
int print_analysis(const ExperimentArguments& arguments, bool texels);
int print_curves(const CurvesText& text);
int render_views(const RenderArguments& arguments);
int list_scenes();
int write_scenes(const std::string& folder);

/// Writes to standard output; false where that fails (a closed pipe).
bool print(const std::string& text);

/// One line on standard error.
void complain(const std::string& line);

}  // namespace psm
