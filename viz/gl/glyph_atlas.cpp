// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/glyph_atlas.h"

#include <cmath>

#include "draw/font_face.h"
#include "draw/utf8.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STBRP_STATIC
#define STB_RECT_PACK_IMPLEMENTATION
#include <stb/stb_rect_pack.h>
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace psm::gl {
namespace {

constexpr char32_t kMissing = 0x25A1;
constexpr int kOversampleX = 2, kFirstSide = 512, kLargestSide = 8192;

Glyph make_glyph(const stbtt_packedchar& packed, int side) {
  Glyph glyph;
  glyph.min = {packed.xoff, packed.yoff};
  glyph.max = {packed.xoff2, packed.yoff2};
  glyph.atlas_min = glm::vec2(packed.x0, packed.y0) / float(side);
  glyph.atlas_max = glm::vec2(packed.x1, packed.y1) / float(side);
  glyph.advance = packed.xadvance;
  return glyph;
}

}  // namespace

GlyphAtlas::GlyphAtlas(const std::string& font, int pixel_size) {
  int side = kFirstSide;
  while (!bake(font, pixel_size, side) && side < kLargestSide) side *= 2;
}

bool GlyphAtlas::bake(const std::string& font, int pixel_size, int side) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(font.data());
  stbtt_fontinfo info;
  if (font.empty() || !stbtt_InitFont(&info, bytes, stbtt_GetFontOffsetForIndex(bytes, 0)))
    fail("psmlab: the font for labels is not a TrueType font");
  int ascent = 0, descent = 0, line_gap = 0;
  stbtt_GetFontVMetrics(&info, &ascent, &descent, &line_gap);
  const double unit = stbtt_ScaleForPixelHeight(&info, float(pixel_size));
  ascent_ = std::round(ascent * unit);
  height_ = pixel_size;

  std::vector<std::uint8_t> coverage(std::size_t(side) * std::size_t(side));
  stbtt_pack_context pack;
  if (!stbtt_PackBegin(&pack, coverage.data(), side, side, 0, 1, nullptr)) return false;
  stbtt_PackSetOversampling(&pack, kOversampleX, 1);
  stbtt_PackSetSkipMissingCodepoints(&pack, 1);
  bool fits = true;
  for (const auto& [first, last] : kTextRanges) {
    std::vector<stbtt_packedchar> packed(std::size_t(last - first + 1));
    fits = stbtt_PackFontRange(&pack, bytes, 0, float(pixel_size), int(first), int(packed.size()), packed.data()) && fits;
    for (std::size_t i = 0; i < packed.size(); ++i) {
      const int character = int(first + i);
      if (stbtt_FindGlyphIndex(&info, character) != 0) glyphs_[char32_t(character)] = make_glyph(packed[i], side);
    }
  }
  stbtt_PackEnd(&pack);
  upload(coverage, side);
  return fits;
}

void GlyphAtlas::upload(const std::vector<std::uint8_t>& coverage, int side) {
  glBindTexture(GL_TEXTURE_2D, texture_.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, side, side, 0, GL_RED, GL_UNSIGNED_BYTE, coverage.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

const Glyph& GlyphAtlas::glyph(char32_t character) const {
  static const Glyph kNothing{};
  if (const auto found = glyphs_.find(character); found != glyphs_.end()) return found->second;
  const auto missing = glyphs_.find(kMissing);
  return missing != glyphs_.end() ? missing->second : kNothing;
}

glm::dvec2 GlyphAtlas::text_size(const std::string& text) const {
  double width = 0.0;
  for (const char32_t character : decode_utf8(text)) width += glyph(character).advance;
  return {std::ceil(width), height_};
}

}  // namespace psm::gl
