// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as data: NAME.figure.json says which views of which experiments stand side by side, and where the figure comes from.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "scene/experiment.h"
#include "scene/result.h"

namespace psm {

struct FigurePanel {
  ViewId view = ViewId::world;
  std::optional<std::string> title;  // none: the view's own
  std::string experiment;            // JSON: the figure's members, with the panel's own over them
  std::vector<Role> hidden;          // the figure's, or the panel's own instead
};

struct FigureFile {
  std::string id;      // NAME
  std::string title;   // what it shows, one line
  std::string source;  // the text that it follows
  int columns = 1;
  glm::ivec2 panel_size{640, 480};  // pixels at scale 1
  std::vector<FigurePanel> panels;  // row by row
};

/// Errors name the file, the place and what is allowed; the experiments' own members are not looked into.
Result<FigureFile> read_figure(const std::filesystem::path& file);

/// The folder's *.figure.json, by name.
std::vector<std::filesystem::path> figure_files(const std::filesystem::path& folder);

}  // namespace psm
