// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/text_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "gl/theme.h"

namespace psm::gl {
namespace {

constexpr double kTextSize = 16.0, kSmallestText = 8.0, kLargestText = 128.0;  // pixels at scale 1; pixels
constexpr double kTitleInset = 10.0, kPlateRadius = 4.0, kLeaderWidth = 1.0;   // pixels at scale 1
constexpr float kPlateOpacity = 0.85f, kRimOpacity = 0.16f, kLeaderOpacity = 0.75f;
constexpr std::size_t kMostAtlases = 4;  // a scale slider must not fill the card

std::string read_font(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (!stream) fail("psmlab: " + file.string() + ": the font for labels cannot be read; install the package fonts-dejavu-core");
  return bytes.str();
}

struct Plate {
  glm::dvec2 top_left, size;
};

Plate plate_around(glm::dvec2 top_left, glm::dvec2 size, double scale) {
  return {top_left - label_margin * scale, size + 2.0 * label_margin * scale};
}

void add_plate(std::vector<ShapeVertex>& to, const Plate& plate, const glm::vec3& text_color, const PictureFrame& frame) {
  append_plate(to, frame, plate.top_left, plate.size, kPlateRadius * frame.scale,
               glm::vec4(ground_color(frame.theme), kPlateOpacity), glm::vec4(text_color, kRimOpacity));
}

/// From the plate's nearest point to the anchor.
void add_leader(std::vector<LineVertex>& to, const PlacedLabel& label, const Plate& plate, const glm::vec3& color,
                const PictureFrame& frame) {
  const glm::dvec2 start = glm::clamp(label.anchor, plate.top_left, plate.top_left + plate.size);
  const auto upwards = [&](glm::dvec2 p) { return glm::dvec2(p.x, frame.size.y - p.y); };
  append_screen_line(to, frame, upwards(start), upwards(label.anchor), glm::vec4(color, kLeaderOpacity),
                     kLeaderWidth * frame.scale);
}

}  // namespace

TextPass::TextPass(const std::filesystem::path& shaders, const std::filesystem::path& font)
    : program_(shaders, "text", "text"),
      stream_(sizeof(Vertex),
              {{0, 3, offsetof(Vertex, position)}, {1, 2, offsetof(Vertex, atlas)}, {2, 4, offsetof(Vertex, color)}}),
      font_(read_font(font)) {}

GlyphAtlas& TextPass::atlas(double scale) {
  const int size = int(std::lround(std::clamp(kTextSize * scale, kSmallestText, kLargestText)));
  const auto found = atlases_.find(size);
  if (found != atlases_.end()) return found->second;
  if (atlases_.size() >= kMostAtlases) atlases_.clear();
  return atlases_.try_emplace(size, font_, size).first->second;
}

std::vector<TextBox> TextPass::layout(const ViewPicture& picture, const PictureFrame& frame, std::vector<ShapeVertex>& plates,
                                      std::vector<LineVertex>& leaders, std::vector<LineVertex>& marks) {
  std::vector<TextBox> boxes;
  const auto measure = [](const std::string& text, double scale, void* self) {
    return static_cast<TextPass*>(self)->text_size(text, scale);
  };
  Plate title_plate{};
  if (!picture.title.empty()) {
    const glm::dvec2 top_left(kTitleInset * frame.scale), size = text_size(picture.title, frame.scale);
    title_plate = plate_around(top_left, size, frame.scale);
    boxes.push_back({top_left, size, picture.title, glm::vec4(label_color(Role::neutral, frame.theme), 1.0f)});
  }
  std::vector<Occupied> occupied;
  if (!picture.title.empty()) occupied.push_back({title_plate.top_left, title_plate.size});
  std::vector<ShapeVertex> legend_plates;
  if (!picture.legend.empty()) {
    const auto size_of = [&](const std::string& text) { return text_size(text, frame.scale); };
    occupied.push_back(lay_out_legend(picture.legend, frame, size_of, boxes, legend_plates, marks));
  }
  for (const PlacedLabel& label :
       place_labels(picture.list, picture.clip_from_list, frame.size, frame.scale, measure, this, occupied)) {
    const Plate plate = plate_around(label.top_left, label.size, frame.scale);
    const glm::vec3 color = label_color(label.role, frame.theme);
    if (label.leader) add_leader(leaders, label, plate, color, frame);
    add_plate(plates, plate, color, frame);
    boxes.push_back({label.top_left, label.size, label.text, glm::vec4(color, 1.0f)});
  }
  if (!picture.title.empty()) add_plate(plates, title_plate, label_color(Role::neutral, frame.theme), frame);
  plates.insert(plates.end(), legend_plates.begin(), legend_plates.end());
  return boxes;
}

void TextPass::append_text(std::vector<Vertex>& to, const TextBox& box, const GlyphAtlas& glyphs,
                           const PictureFrame& frame) const {
  const glm::dvec2 start = box.top_left + 0.5 * (box.size - glyphs.text_size(box.text));
  glm::dvec2 pen = glm::round(start + glm::dvec2(0.0, glyphs.ascent()));
  for (const char32_t character : decode_utf8(box.text)) {
    const Glyph& glyph = glyphs.glyph(character);
    const auto corner = [&](double right, double down) {
      const glm::dvec2 at = pen + glm::mix(glm::dvec2(glyph.min), glm::dvec2(glyph.max), glm::dvec2(right, down));
      const glm::dvec2 device = at / frame.size * 2.0 - 1.0;
      return Vertex{glm::vec3(device.x, -device.y, -1.0), glm::mix(glyph.atlas_min, glyph.atlas_max, glm::vec2(right, down)),
                    box.color};
    };
    const std::array<Vertex, 4> corners{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    for (const int i : {0, 1, 2, 0, 2, 3}) to.push_back(corners[std::size_t(i)]);
    pen.x += glyph.advance;
  }
}

void TextPass::draw(const std::vector<TextBox>& boxes, const PictureFrame& frame) {
  if (boxes.empty()) return;
  const GlyphAtlas& glyphs = atlas(frame.scale);
  std::vector<Vertex> vertices;
  for (const TextBox& box : boxes) append_text(vertices, box, glyphs, frame);
  program_.use();
  program_.set("u_atlas", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, glyphs.texture());
  stream_.upload(std::span<const Vertex>(vertices));
  stream_.draw_triangles();
}

}  // namespace psm::gl
