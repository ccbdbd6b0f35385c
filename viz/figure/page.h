// SPDX-License-Identifier: GPL-3.0-or-later
// A page of a few kinds of things: what SVG and PDF are written from. Lengths in pixels at 96 to the inch, y downwards; colours
// are sRGB and opacity, 0 to 1.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "draw/image.h"
#include "scene/result.h"

namespace psm {

/// Straight, with butt ends; its opacity goes from a's to b's.
struct PageLine {
  glm::dvec2 a{0.0}, b{0.0};
  glm::vec3 color{0.0f};
  double opacity_a = 1.0, opacity_b = 1.0, width = 1.0;
  double dash_on = 0.0, dash_off = 0.0;  // 0: solid
};

struct PagePolygon {
  std::vector<glm::dvec2> corners;
  glm::vec4 fill{0.0f};
};

/// With rounded corners: a disc where `radius` is half its size.
struct PageBox {
  glm::dvec2 top_left{0.0}, size{0.0};
  double radius = 0.0;
  glm::vec4 fill{0.0f}, rim{0.0f};
  double rim_width = 0.0;
};

/// One line in the page's typeface, centred in its box; `size` as measured with it, so that the height gives the type's size.
struct PageText {
  glm::dvec2 top_left{0.0}, size{0.0};
  std::string text;
  glm::vec3 color{0.0f};
};

struct PageImage {
  glm::dvec2 top_left{0.0}, size{0.0};
  Image image;
};

using PageItem = std::variant<PageLine, PagePolygon, PageBox, PageText, PageImage>;

/// Items in painter's order, cut off at the panel's border; their places are the page's.
struct PagePanel {
  glm::dvec2 top_left{0.0}, size{0.0};
  std::vector<PageItem> items;
};

struct Page {
  glm::dvec2 size{0.0};
  std::optional<glm::vec3> background;  // none: transparent
  std::vector<PagePanel> panels;
  std::string title;
  std::string parameters;  // JSON: what the page was made from, for the file's metadata
};

/// Of DejaVu Sans, in which pages are set: the line's height is ascent plus descent.
constexpr double kEmPerHeight = 0.859, kAscentPerHeight = 0.797;

std::string page_svg(const Page& page);

/// Nothing where this program can write PDF; else why not, in one line: it was built without Cairo.
std::optional<InputError> pdf_missing();
Result<std::string> page_pdf(const Page& page);

}  // namespace psm
