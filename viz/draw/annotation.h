// SPDX-License-Identifier: GPL-3.0-or-later
// A view's title, labels and legend on the picture: texts on rounded plates, with leaders to what they name. Pixels, y downwards.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "draw/theme.h"
#include "draw/view.h"

namespace psm {

struct TextBox {
  glm::dvec2 top_left{0.0}, size{0.0};  // as measured
  std::string text;
  glm::vec3 color{0.0f};
};

/// A rounded box.
struct Plate {
  glm::dvec2 top_left{0.0}, size{0.0};
  double radius = 0.0;
  glm::vec4 fill{1.0f}, rim{0.0f};  // sRGB and opacity
};

struct Mark {
  glm::dvec2 a{0.0}, b{0.0};
  glm::vec4 color{0.0f};
  double width = 1.0;
};

/// Leaders go under plates, marks (hatched swatches) over them, texts over all.
struct Annotations {
  std::vector<Mark> leaders;
  std::vector<Plate> plates;
  std::vector<Mark> marks;
  std::vector<TextBox> texts;
};

/// Height of a line of text, ascent plus descent, and where a view's title begins; pixels at scale 1.
constexpr double kTextHeight = 16.0, kTitleInset = 10.0;

using TextSize = std::function<glm::dvec2(const std::string&)>;

/// The view's title as it stands in its upper left corner: with the legend's heading behind it in a low view that has room for
/// it, in as many lines as a narrow one needs.
std::vector<std::string> title_lines(const ViewPicture& picture, const PictureFrame& frame, const TextSize& text_size);

/// `text_size` measures in pixels.
Annotations annotate(const ViewPicture& picture, const PictureFrame& frame, const TextSize& text_size);

}  // namespace psm
