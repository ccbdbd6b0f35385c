// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/font_face.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <fstream>
#include <iterator>

#include "draw/utf8.h"

namespace psm {

struct FontFace::Font {
  std::string bytes;
  stbtt_fontinfo info{};
  bool usable = false;
  int height = 1;  // ascent plus descent, in the font's units
};

FontFace::FontFace(std::string bytes) : font_(std::make_unique<Font>()) {
  font_->bytes = std::move(bytes);
  const auto* data = reinterpret_cast<const unsigned char*>(font_->bytes.data());
  if (font_->bytes.size() < 12) return;
  const int offset = stbtt_GetFontOffsetForIndex(data, 0);
  font_->usable = offset >= 0 && stbtt_InitFont(&font_->info, data, offset) != 0;
  if (!font_->usable) return;
  int ascent = 0, descent = 0, gap = 0;
  stbtt_GetFontVMetrics(&font_->info, &ascent, &descent, &gap);
  font_->height = ascent - descent;
}

Result<FontFace> FontFace::load(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  FontFace font(std::string(std::istreambuf_iterator<char>(stream), {}));
  if (!font.font_->usable)
    return InputError{file.string() + ": cannot be read as a TrueType font; install the package fonts-dejavu-core"};
  return font;
}

FontFace::~FontFace() = default;
FontFace::FontFace(FontFace&&) noexcept = default;

bool FontFace::has(char32_t point) const {
  const bool in_range = std::any_of(std::begin(kTextRanges), std::end(kTextRanges),
                                    [&](const auto& range) { return point >= range[0] && point <= range[1]; });
  return in_range && font_->usable && stbtt_FindGlyphIndex(&font_->info, int(point)) != 0;
}

double FontFace::width(const std::string& text) const {
  if (!font_->usable) return 0.0;
  double units = 0.0;
  for (const char32_t point : decode_utf8(text)) {
    int advance = 0, bearing = 0;
    stbtt_GetCodepointHMetrics(&font_->info, int(point), &advance, &bearing);
    units += advance;
  }
  return units / font_->height;
}

Reach FontFace::reach(const std::string& text) const {
  Reach reach;
  if (!font_->usable) return reach;
  for (const char32_t point : decode_utf8(text)) {
    int left = 0, low = 0, right = 0, high = 0;
    if (stbtt_GetCodepointBox(&font_->info, int(point), &left, &low, &right, &high) == 0) continue;
    reach.above = std::max(reach.above, double(high) / font_->height);
    reach.below = std::max(reach.below, -double(low) / font_->height);
  }
  return reach;
}

}  // namespace psm
