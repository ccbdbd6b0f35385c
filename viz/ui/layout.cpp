// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/layout.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

constexpr double kStackBelow = 16.0 / 9.0;  // width by height of a room where two such pictures are larger one above the other

int part(int whole, double fraction) { return int(std::lround(whole * fraction)); }

void place_tiles(Layout& out, const Rect& area, const std::vector<ViewId>& tiles, const LayoutSettings& settings, int splitter) {
  const glm::ivec2 size = area.size();
  const std::size_t count = tiles.size();
  const bool stacked = count == 2 && size.x < kStackBelow * size.y;
  const int left = area.min.x + std::max(0, part(size.x, settings.column) - splitter / 2), right = left + splitter;
  const int above = area.min.y + std::max(0, part(size.y, settings.row) - splitter / 2), below = above + splitter;
  const int first_row = count > 2 ? above : area.max.y;
  std::vector<Rect> places{{area.min, {left, first_row}}, {{right, area.min.y}, {area.max.x, first_row}}};
  if (count == 1) places = {area};
  if (stacked) places = {{area.min, {area.max.x, above}}, {{area.min.x, below}, area.max}};
  if (count == 3) places.push_back({{area.min.x, below}, area.max});
  if (count == 4) places.insert(places.end(), {{{area.min.x, below}, {left, area.max.y}}, {{right, below}, area.max}});
  for (std::size_t i = 0; i < count; ++i) out.views[std::size_t(tiles[i])] = places[i];
  if (count > 1 && !stacked) out.column_splitter = {{left, area.min.y}, {right, count == 3 ? above : area.max.y}};
  if (count > 2 || stacked) out.row_splitter = {{area.min.x, above}, {area.max.x, below}};
}

}  // namespace

Layout lay_out(glm::ivec2 window, const LayoutSettings& settings, const ViewSettings& view, int badge_height, int splitter) {
  Layout out;
  const int bottom = std::max(0, window.y - badge_height);
  out.badges = {{0, bottom}, window};
  Rect area{{0, 0}, {window.x, bottom}};
  if (settings.pane_shown) {
    const int pane_left = window.x - part(window.x, settings.pane);
    area.max.x = std::max(0, pane_left - splitter);
    out.pane_splitter = {{area.max.x, 0}, {pane_left, bottom}};
    out.pane = {{pane_left, 0}, {window.x, bottom}};
  }
  if (settings.lesson_shown) {
    const int right = part(window.x, settings.lesson);
    out.lesson = {{0, 0}, {std::min(right, area.max.x), bottom}};
    area.min.x = std::min(right + splitter, area.max.x);
    out.lesson_splitter = {{out.lesson.max.x, 0}, {area.min.x, bottom}};
  }
  place_tiles(out, area, view.maximised ? std::vector<ViewId>{*view.maximised} : view.tiles, settings, splitter);
  return out;
}

LayoutSettings move_splitter(Splitter which, glm::dvec2 to, glm::ivec2 window, LayoutSettings s, int badge_height) {
  const double left = s.lesson_shown ? window.x * s.lesson : 0.0;
  const double area_width = std::max(1.0, window.x * (s.pane_shown ? 1.0 - s.pane : 1.0) - left);
  if (which == Splitter::lesson) s.lesson = to.x / std::max(1, window.x);
  if (which == Splitter::pane) s.pane = 1.0 - to.x / std::max(1, window.x);
  if (which == Splitter::column) s.column = (to.x - left) / area_width;
  if (which == Splitter::row) s.row = to.y / std::max(1, window.y - badge_height);
  Settings limits;
  limits.layout = s;
  return clamped(limits).layout;
}

LayoutSettings reset_splitter(Splitter which, LayoutSettings s) {
  const LayoutSettings standard;
  if (which == Splitter::lesson) s.lesson = standard.lesson;
  if (which == Splitter::pane) s.pane = standard.pane;
  if (which == Splitter::column) s.column = standard.column;
  if (which == Splitter::row) s.row = standard.row;
  return s;
}

}  // namespace psm
