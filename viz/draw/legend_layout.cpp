// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/legend_layout.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

// Pixels at scale 1.
constexpr double kInset = 8.0, kPadding = 6.0, kSwatchWidth = 22.0, kGap = 4.0, kEntryGap = 10.0, kLineGap = 4.0, kHatch = 7.0;
constexpr double kLowView = 420.0;      // where lines of text go on beside each other: height is what it lacks
constexpr double kVeryLowView = 300.0;  // pixels at scale 1: numbers give way to the ground
constexpr float kPlateOpacity = 0.92f, kRimOpacity = 0.16f, kSwatchRim = 0.5f;

struct Item {
  glm::dvec2 at{0.0}, size{0.0};  // of swatch and text together, from the legend's own corner
  glm::dvec2 text_size{0.0};
  const LegendEntry* entry = nullptr;  // none: a line of text
  const std::string* text = nullptr;
};

/// Items in reading order: heading, colours one after the other, numbers, each on a line of its own; in a `low` view numbers go
/// on behind what stands there. Returns the extent.
glm::dvec2 flow(std::vector<Item>& items, double scale, double width, bool low) {
  glm::dvec2 pen(0.0), extent(0.0);
  double row = 0.0;
  const Item* before = nullptr;
  for (Item& item : items) {
    if (before && low && !item.entry) pen.x += kEntryGap * scale;
    const bool goes_on = before && (item.entry ? bool(before->entry) : low) && pen.x + item.size.x <= width;
    if (before && !goes_on) pen = {0.0, pen.y + row + kLineGap * scale}, row = 0.0;
    item.at = pen;
    pen.x += item.size.x + kEntryGap * scale;
    row = std::max(row, item.size.y);
    extent = glm::max(extent, item.at + item.size);
    before = &item;
  }
  return extent;
}

void hatch(std::vector<Mark>& marks, const PictureFrame& frame, glm::dvec2 corner, glm::dvec2 size, const glm::vec3& color) {
  const bool pale = glm::dot(color, glm::vec3(0.3f, 0.6f, 0.1f)) > 0.4f;
  const glm::vec4 ink(glm::vec3(pale ? 0.0f : 1.0f), 0.5f);
  for (double x = 0.5 * kHatch * frame.scale; x < size.x + size.y; x += kHatch * frame.scale) {
    // From the upper side or the right one, down to the left.
    const glm::dvec2 a(std::min(x, size.x), std::max(0.0, x - size.x)), b(std::max(0.0, x - size.y), std::min(x, size.y));
    marks.push_back({corner + a, corner + b, ink, 1.2 * frame.scale});
  }
}

/// A legend whose lines are broken where the view ends, and what that takes.
struct Flowed {
  std::vector<std::string> head, tail;
  std::vector<Item> items;
  glm::dvec2 plate{0.0};
};

Flowed flowed(const Legend& legend, const PictureFrame& frame, const TextSize& text_size) {
  const double s = frame.scale, swatch = kSwatchWidth * s, gap = kGap * s, width = frame.size.x - 2.0 * (kInset + kPadding) * s;
  Flowed out;
  if (!legend.title.empty()) out.head = broken_lines(legend.title, width, text_size);
  for (const std::string& line : legend.lines)
    for (std::string& part : broken_lines(line, width, text_size)) out.tail.push_back(std::move(part));
  const auto add_text = [&](const std::string& text) {
    const glm::dvec2 size = text_size(text);
    out.items.push_back({{}, size, size, nullptr, &text});
  };
  for (const std::string& line : out.head) add_text(line);
  for (const LegendEntry& entry : legend.entries) {
    const glm::dvec2 size = text_size(entry.text);
    out.items.push_back({{}, {swatch + gap + size.x, size.y}, size, &entry, &entry.text});
  }
  for (const std::string& line : out.tail) add_text(line);
  out.plate = flow(out.items, s, width, is_low(frame)) + 2.0 * kPadding * s;
  return out;
}

/// What of the legend fits a quarter of the view: all, or fewer numbers, the last line first, or the colours alone, which may
/// take half of it. Numbers beside colours may not take more than a fifth of a very low view's height: the colours of the ground
/// lie there.
Legend fitting(Legend legend, const PictureFrame& frame, const TextSize& text_size) {
  const auto too_large = [&](double part) {
    const glm::dvec2 plate = flowed(legend, frame, text_size).plate;
    return plate.x * plate.y > part * frame.size.x * frame.size.y;
  };
  const auto hides_colors = [&] {
    return frame.size.y < kVeryLowView * frame.scale && !legend.entries.empty() &&
           flowed(legend, frame, text_size).plate.y > 0.2 * frame.size.y;
  };
  while (!legend.lines.empty() && (hides_colors() || too_large(0.25))) legend.lines.pop_back();
  if (too_large(0.25)) legend.title.clear();
  if (too_large(0.5)) legend.entries.clear();
  return legend;
}

/// Of the places where several blanks stand together the last one with all before it on one line; failing that, the first one.
std::size_t phrase_end(const std::string& text, double width, const TextSize& text_size) {
  std::size_t end = text.find("  ");
  for (std::size_t at = end; at != std::string::npos; at = text.find("  ", text.find_first_not_of(' ', at)))
    if (text_size(text.substr(0, at)).x <= width) end = at;
  return end;
}

}  // namespace

bool is_low(const PictureFrame& frame) { return frame.size.y < kLowView * frame.scale; }

std::vector<std::string> broken_lines(const std::string& text, double width, const TextSize& text_size) {
  if (text_size(text).x <= width) return {text};
  const std::size_t phrase = phrase_end(text, width, text_size);
  const std::size_t next = phrase == std::string::npos ? phrase : text.find_first_not_of(' ', phrase);
  if (phrase > 0 && next != std::string::npos) {
    std::vector<std::string> lines = broken_lines(text.substr(0, phrase), width, text_size);
    for (std::string& line : broken_lines(text.substr(next), width, text_size)) lines.push_back(std::move(line));
    return lines;
  }
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at + 1), text.size());
    const std::string word = text.substr(at, end - at);
    const std::size_t letter = word.find_first_not_of(' ');  // none in blanks that follow each other
    if (lines.back().empty() || text_size(lines.back() + word).x <= width)
      lines.back() += word;
    else if (letter != std::string::npos)
      lines.push_back(word.substr(letter));
    at = end;
  }
  return lines;
}

Occupied lay_out_legend(const Legend& asked, const PictureFrame& frame, const TextSize& text_size, std::vector<TextBox>& texts,
                        std::vector<Plate>& plates, std::vector<Mark>& marks) {
  const Legend legend = fitting(asked, frame, text_size);
  if (legend.empty()) return {};
  const double s = frame.scale, swatch = kSwatchWidth * s, gap = kGap * s;
  const Flowed parts = flowed(legend, frame, text_size);
  const glm::dvec2 plate = parts.plate, corner(kInset * s, frame.size.y - kInset * s - plate.y), origin = corner + kPadding * s;
  const glm::vec3 ink = picture_label_color(Role::text, frame.theme);
  plates.push_back({corner, plate, 4.0 * s, glm::vec4(picture_ground(frame.theme), kPlateOpacity), glm::vec4(ink, kRimOpacity)});
  for (const Item& item : parts.items) {
    const glm::dvec2 at = origin + item.at;
    if (item.entry) {
      const glm::dvec2 size(swatch, std::round(0.8 * item.size.y)), top(at.x, at.y + 0.5 * (item.size.y - size.y));
      plates.push_back({top, size, 1.0 * s, glm::vec4(item.entry->color, 1.0f), glm::vec4(ink, kSwatchRim)});
      if (item.entry->hatched) hatch(marks, frame, top, size, item.entry->color);
    }
    texts.push_back({{at.x + (item.entry ? swatch + gap : 0.0), at.y}, item.text_size, *item.text, ink});
  }
  return {corner, plate};
}

}  // namespace psm
