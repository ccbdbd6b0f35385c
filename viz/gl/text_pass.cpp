// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/text_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "draw/utf8.h"

namespace psm::gl {
namespace {

constexpr double kSmallestText = 8.0, kLargestText = 128.0;  // pixels
constexpr std::size_t kMostAtlases = 4;                      // a scale slider must not fill the card

std::string read_font(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (!stream) fail("psmlab: " + file.string() + ": the font for labels cannot be read; install the package fonts-dejavu-core");
  return bytes.str();
}

}  // namespace

TextPass::TextPass(const std::filesystem::path& shaders, const std::filesystem::path& font)
    : program_(shaders, "text", "text"),
      stream_(sizeof(Vertex),
              {{0, 3, offsetof(Vertex, position)}, {1, 2, offsetof(Vertex, atlas)}, {2, 4, offsetof(Vertex, color)}}),
      font_(read_font(font)) {}

GlyphAtlas& TextPass::atlas(double scale) {
  const int size = int(std::lround(std::clamp(kTextHeight * scale, kSmallestText, kLargestText)));
  const auto found = atlases_.find(size);
  if (found != atlases_.end()) return found->second;
  if (atlases_.size() >= kMostAtlases) atlases_.clear();
  return atlases_.try_emplace(size, font_, size).first->second;
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
                    glm::vec4(box.color, 1.0f)};
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
