// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compared_sides.h"

#include <algorithm>
#include <cmath>

#include "app/pixels.h"
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

}  // namespace

bool is_split(const SheetPanel& panel) { return panel.side && is_split(panel.view, panel.loaded->experiment.view); }

glm::ivec2 shown_columns(const SheetPanel& panel) {
  if (!is_split(panel)) return {0, panel.size.x};
  const int line = line_column(panel);
  return panel.side == 'A' ? glm::ivec2(0, line) : glm::ivec2(line, panel.size.x);
}

std::vector<SidePlate> side_plates(const SheetPanel& panel, const Analysis& analysis, double scale) {
  if (!panel.side) return {};
  const glm::ivec2 columns = shown_columns(panel);
  const glm::ivec2 name = panel.top_left + glm::ivec2(columns.x + px(kInset, scale), px(kBelowTitle, scale));
  std::vector<SidePlate> plates{{name, {0, px(kText + 2.0 * kPadding, scale)}, comparison_name(panel.side, analysis)}};
  if (!is_split(panel) || panel.side != 'A') return plates;
  const int width = px(kLine, scale), x = std::clamp(columns.y - width / 2, 0, std::max(0, panel.size.x - width));
  plates.push_back({panel.top_left + glm::ivec2(x, 0), {width, panel.size.y}, ""});
  return plates;
}

void draw_plate(const SidePlate& plate, const Caption& caption, const Sheet& sheet, Image& whole) {
  const int pad = px(kPadding, sheet.scale);
  if (plate.text.empty()) return fill(whole, plate.top_left, plate.top_left + plate.size, ink(sheet.theme));
  const int width = int(std::ceil(caption.width(plate.text))) + 2 * pad;
  fill(whole, plate.top_left, plate.top_left + glm::ivec2(width, plate.size.y), paper(sheet.theme));
  caption.draw(whole, plate.top_left.x + pad, plate.top_left.y + pad, plate.text, ink(sheet.theme));
}

PagePanel plate_panel(const SidePlate& plate, const FontFace& font, const Sheet& sheet) {
  const double pad = px(kPadding, sheet.scale);
  const glm::dvec2 at = plate.top_left;
  const auto box = [&](const glm::dvec2& size, const glm::vec3& color) {
    return PageBox{at, size, 0.0, glm::vec4(color, 1.0f), glm::vec4(0.0f), 0.0};
  };
  if (plate.text.empty()) return {at, plate.size, {box(plate.size, ink(sheet.theme))}};
  const glm::dvec2 text = font.text_size(plate.text, kText * sheet.scale), size(text.x + 2.0 * pad, plate.size.y);
  return {at, size, {box(size, paper(sheet.theme)), PageText{at + pad, text, plate.text, ink(sheet.theme)}}};
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
