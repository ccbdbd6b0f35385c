// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/annotation.h"

#include <algorithm>

#include "draw/legend_layout.h"

namespace psm {
namespace {

constexpr double kPlateRadius = 4.0, kLeaderWidth = 1.0;  // pixels at scale 1
constexpr float kPlateOpacity = 0.85f, kRimOpacity = 0.16f, kLeaderOpacity = 0.75f;

Plate plate_around(glm::dvec2 top_left, glm::dvec2 size, const glm::vec3& text_color, const PictureFrame& frame) {
  const double margin = label_margin * frame.scale;
  return {top_left - margin, size + 2.0 * margin, kPlateRadius * frame.scale,
          glm::vec4(picture_ground(frame.theme), kPlateOpacity), glm::vec4(text_color, kRimOpacity)};
}

/// From the plate's nearest point to the anchor.
Mark leader_to(const glm::dvec2& anchor, const Plate& plate, const glm::vec3& color, const PictureFrame& frame) {
  return {glm::clamp(anchor, plate.top_left, plate.top_left + plate.size), anchor, glm::vec4(color, kLeaderOpacity),
          kLeaderWidth * frame.scale};
}

glm::dvec2 measure(const std::string& text, double, void* text_size) { return (*static_cast<const TextSize*>(text_size))(text); }

/// On a piece of ground, so that they can be read over lines; moved as far as it takes to stay on the picture.
void add_fixed_texts(const ViewPicture& picture, const PictureFrame& frame, const TextSize& text_size, Annotations& out,
                     std::vector<Occupied>& occupied) {
  constexpr float kGround = 0.7f;
  for (const DrawText& text : picture.list.texts) {
    const glm::dvec4 clip = picture.clip_from_list * text.position;
    if (!(clip.w > 0.0)) continue;
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w, size = text_size(text.text);
    const glm::dvec2 at(0.5 * (1.0 + ndc.x) * frame.size.x, 0.5 * (1.0 - ndc.y) * frame.size.y);
    const glm::dvec2 top_left = glm::clamp(glm::round(at - text.pivot * size), glm::dvec2(0.0), glm::max(frame.size - size, 0.0));
    out.plates.push_back({top_left, size, 2.0 * frame.scale, glm::vec4(picture_ground(frame.theme), kGround), glm::vec4(0.0f)});
    out.texts.push_back({top_left, size, text.text, picture_label_color(text.role, frame.theme)});
    occupied.push_back({top_left, size});
  }
}

/// A legend's heading takes no line of a low view where it fits behind the view's title; a tile's controls stand at its right.
bool heading_moves_up(const ViewPicture& picture, const PictureFrame& frame, const TextSize& text_size) {
  constexpr double kControls = 280.0;  // pixels at scale 1
  return !picture.title.empty() && !picture.legend.title.empty() && is_low(frame) &&
         text_size(picture.title + ": " + picture.legend.title).x <= frame.size.x - kControls * frame.scale;
}

/// Returns its plate.
Plate add_title(const std::vector<std::string>& lines, const PictureFrame& frame, const TextSize& text_size, Annotations& out) {
  const glm::vec3 color = picture_label_color(Role::neutral, frame.theme);
  const glm::dvec2 corner(kTitleInset * frame.scale);
  glm::dvec2 extent(0.0);
  for (const std::string& line : lines) {
    const glm::dvec2 size = text_size(line);
    out.texts.push_back({corner + glm::dvec2(0.0, extent.y), size, line, color});
    extent = {std::max(extent.x, size.x), extent.y + size.y};
  }
  return plate_around(corner, extent, color, frame);
}

}  // namespace

std::vector<std::string> title_lines(const ViewPicture& picture, const PictureFrame& frame, const TextSize& text_size) {
  if (picture.title.empty()) return {};
  if (heading_moves_up(picture, frame, text_size)) return {picture.title + ": " + picture.legend.title};
  return broken_lines(picture.title, frame.size.x - 2.0 * kTitleInset * frame.scale, text_size);
}

Annotations annotate(const ViewPicture& picture, const PictureFrame& frame, const TextSize& text_size) {
  Annotations out;
  std::vector<Occupied> occupied;
  std::vector<Plate> title, legend;
  if (const auto lines = title_lines(picture, frame, text_size); !lines.empty()) {
    title.push_back(add_title(lines, frame, text_size, out));
    occupied.push_back({title.back().top_left, title.back().size});
  }
  Legend explained = picture.legend;
  if (heading_moves_up(picture, frame, text_size)) explained.title.clear();
  if (!explained.empty()) occupied.push_back(lay_out_legend(explained, frame, text_size, out.texts, legend, out.marks));
  add_fixed_texts(picture, frame, text_size, out, occupied);
  for (const Occupied& part : picture.shown.covered) occupied.push_back({part.top_left * frame.size, part.size * frame.size});
  TextSize measured = text_size;
  for (const PlacedLabel& label : place_labels(picture.list, picture.clip_from_list, frame.size, frame.scale, measure, &measured,
                                               occupied, picture.shown.columns)) {
    const glm::vec3 color = picture_label_color(label.role, frame.theme);
    out.plates.push_back(plate_around(label.top_left, label.size, color, frame));
    if (label.leader) out.leaders.push_back(leader_to(label.anchor, out.plates.back(), color, frame));
    out.texts.push_back({label.top_left, label.size, label.text, color});
  }
  out.plates.insert(out.plates.end(), title.begin(), title.end());
  out.plates.insert(out.plates.end(), legend.begin(), legend.end());
  return out;
}

}  // namespace psm
