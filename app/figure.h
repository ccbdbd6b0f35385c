// SPDX-License-Identifier: GPL-3.0-or-later
// The figure command.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace psm {

struct FigureArguments {
  std::optional<std::string> id;  // or a .figure.json file
  std::vector<std::string> overrides;
  std::string out;
  std::optional<std::string> size, sweep;
  std::string theme = "light", format = "png";  // format: of --all
  bool list = false, all = false, transparent = false;
};

/// Returns the exit code.
int figure(const FigureArguments& arguments);

}  // namespace psm
