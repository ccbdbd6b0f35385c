// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compared_sides.h"

#include <algorithm>
#include <cmath>

#include "app/pixels.h"
#include "draw/legend_layout.h"
#include "ui/comparison.h"

namespace psm {
namespace {

// Pixels at scale 1.
constexpr double kText = 18.0, kPadding = 5.0, kInset = 8.0, kGap = 4.0, kLine = 2.5;
constexpr double kBelowTitle = 44.0;

int px(double length, double scale) { return std::max(1, int(std::lround(length * scale))); }

int line_column(const SheetPanel& panel) {
  return std::clamp(int(std::lround(panel.loaded->experiment.view.split * panel.size.x)), 0, panel.size.x);
}

glm::vec3 ink(Theme theme) { return glm::vec3(theme == Theme::dark ? 0.92f : 0.08f); }
glm::vec3 paper(Theme theme) { return glm::vec3(theme == Theme::dark ? 0.12f : 0.98f); }

/// A plate's text in lines that stay within what it may take.
struct Lines {
  std::vector<std::string> texts;
  glm::dvec2 size{0.0};

  Lines(const SidePlate& plate, double pad, const TextSize& text_size)
      : texts(broken_lines(plate.text, plate.size.x - 2.0 * pad, text_size)) {
    for (const std::string& line : texts) {
      const glm::dvec2 extent = text_size(line);
      size = {std::max(size.x, extent.x), size.y + extent.y};
    }
  }
};

bool is_split(const SheetPanel& panel) { return panel.side && is_split(panel.view, panel.loaded->experiment.view); }

}  // namespace

glm::ivec2 shown_columns(const SheetPanel& panel) {
  if (!is_split(panel)) return {0, panel.size.x};
  const int line = line_column(panel);
  return panel.side == 'A' ? glm::ivec2(0, line) : glm::ivec2(line, panel.size.x);
}

std::vector<SidePlate> side_plates(const SheetPanel& panel, const Analysis& analysis, double scale) {
  if (!panel.side) return {};
  const glm::ivec2 columns = shown_columns(panel);
  const glm::ivec2 name = panel.top_left + glm::ivec2(columns.x + px(kInset, scale), px(kBelowTitle, scale));
  const glm::ivec2 room = panel.top_left + glm::ivec2(columns.y - px(kInset, scale), panel.size.y) - name;
  std::vector<SidePlate> plates;
  if (room.x > px(kText, scale)) plates.push_back({name, room, comparison_name(panel.side, analysis)});
  if (!is_split(panel) || panel.side != 'A') return plates;
  const int width = px(kLine, scale), x = std::clamp(columns.y - width / 2, 0, std::max(0, panel.size.x - width));
  plates.push_back({panel.top_left + glm::ivec2(x, 0), {width, panel.size.y}, ""});
  return plates;
}

ShownPart shown_part(const SheetPanel& panel, const Analysis& analysis, const FontFace& font, double scale) {
  const glm::dvec2 size = panel.size;
  ShownPart part{glm::dvec2(shown_columns(panel)) / size.x, {}};
  const double pad = px(kPadding, scale);
  const auto text_size = [&](const std::string& text) { return font.text_size(text, kText * scale); };
  for (const SidePlate& plate : side_plates(panel, analysis, scale))
    if (!plate.text.empty())
      part.covered.push_back(
          {glm::dvec2(plate.top_left - panel.top_left) / size, (Lines(plate, pad, text_size).size + 2.0 * pad) / size});
  return part;
}

void draw_plate(const SidePlate& plate, const Caption& caption, const Sheet& sheet, Image& whole) {
  const int pad = px(kPadding, sheet.scale), line_height = px(kText, sheet.scale);
  if (plate.text.empty()) return fill(whole, plate.top_left, plate.top_left + plate.size, ink(sheet.theme));
  const auto text_size = [&](const std::string& text) { return glm::dvec2(caption.width(text), line_height); };
  const Lines lines(plate, pad, text_size);
  fill(whole, plate.top_left, plate.top_left + glm::ivec2(glm::ceil(lines.size)) + 2 * pad, paper(sheet.theme));
  glm::ivec2 at = plate.top_left + pad;
  for (const std::string& line : lines.texts) caption.draw(whole, at.x, at.y, line, ink(sheet.theme)), at.y += line_height;
}

PagePanel plate_panel(const SidePlate& plate, const FontFace& font, const Sheet& sheet) {
  const double pad = px(kPadding, sheet.scale);
  const glm::dvec2 at = plate.top_left;
  const auto box = [&](const glm::dvec2& size, const glm::vec3& color) {
    return PageBox{at, size, 0.0, glm::vec4(color, 1.0f), glm::vec4(0.0f), 0.0};
  };
  if (plate.text.empty()) return {at, plate.size, {box(plate.size, ink(sheet.theme))}};
  const auto text_size = [&](const std::string& text) { return font.text_size(text, kText * sheet.scale); };
  const Lines lines(plate, pad, text_size);
  const glm::dvec2 size = lines.size + 2.0 * pad;
  PagePanel panel{at, size, {box(size, paper(sheet.theme))}};
  glm::dvec2 pen = at + pad;
  for (const std::string& line : lines.texts) {
    const glm::dvec2 extent = text_size(line);
    panel.items.push_back(PageText{pen, extent, line, ink(sheet.theme)});
    pen.y += extent.y;
  }
  return panel;
}

void add_compared_panels(Sheet& sheet, const std::shared_ptr<const LoadedExperiment>& loaded, const std::vector<ViewId>& views,
                         const std::vector<Rect>& places) {
  const ViewSettings& view = loaded->experiment.view;
  const auto second = std::make_shared<LoadedExperiment>(*loaded);
  second->experiment.shadow.technique = *view.compare;
  for (const char side : {'B', 'A'})
    for (std::size_t i = 0; i < views.size(); ++i) {
      const bool shared = is_compared(views[i]), whole = !shared || is_split(views[i], view);
      if (side == 'B' && !shared) continue;
      SheetPanel panel;
      panel.loaded = side == 'A' ? loaded : second;
      panel.view = views[i];
      panel.top_left = places[i].min;
      panel.size = places[i].size();
      panel.side = shared ? side : '\0';
      if (!whole) panel.size.x = std::max(1, (panel.size.x - px(kGap, sheet.scale)) / 2);
      if (!whole && side == 'B') panel.top_left.x = places[i].max.x - panel.size.x;
      sheet.panels.push_back(std::move(panel));
    }
}

}  // namespace psm
