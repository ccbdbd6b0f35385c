// SPDX-License-Identifier: GPL-3.0-or-later
// Views side by side: drawn as one picture, or as a page for SVG and PDF.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "draw/emphasis.h"
#include "figure/page.h"
#include "gl/renderer.h"
#include "scene/experiment_file.h"

namespace psm {

struct SheetPanel {
  std::shared_ptr<const LoadedExperiment> loaded;
  ViewId view = ViewId::world;
  std::optional<std::string> title;  // none: the view's own
  Emphasis emphasis = {};
  glm::ivec2 top_left{0}, size{0};
  char side = 0;  // 'A' or 'B' where two techniques share the view
};

struct Sheet {
  glm::ivec2 size{1280, 720};
  double scale = 1.0;  // of line widths and type
  Theme theme = Theme::light;
  bool transparent = false;
  bool supersampled = false;   // four pixels are drawn for each
  glm::vec3 background{1.0f};  // between panels
  std::vector<SheetPanel> panels;
  int status_height = 0;  // of a line at the bottom about the last panel's light; 0: none
  std::string title;
};

/// The experiments of the panels as JSON, to find out later what a picture shows.
std::string parameters_of(const Sheet& sheet);

/// Draws sheets; keeps what the last panel needed, because the next one often needs the same. Needs a current OpenGL context.
class SheetPainter {
 public:
  SheetPainter();
  ~SheetPainter();

  Image image(const Sheet& sheet);
  Result<Page> page(const Sheet& sheet);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The file's bytes, by its ending: .png, .svg or .pdf.
Result<std::string> sheet_bytes(SheetPainter& painter, const Sheet& sheet, const std::filesystem::path& file);

}  // namespace psm
