// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure/font.h"

#include <fstream>
#include <sstream>

#include "draw/utf8.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace psm {

struct Font::State {
  std::string bytes;  // `info` points into it
  stbtt_fontinfo info{};
};

Result<Font> Font::load(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  const auto state = std::make_shared<State>();
  state->bytes = bytes.str();
  const auto* data = reinterpret_cast<const unsigned char*>(state->bytes.data());
  if (!stream || state->bytes.empty() || !stbtt_InitFont(&state->info, data, stbtt_GetFontOffsetForIndex(data, 0)))
    return InputError{file.string() + ": cannot be read as a TrueType font; install the package fonts-dejavu-core"};
  Font font;
  font.state_ = state;
  return font;
}

glm::dvec2 Font::text_size(const std::string& text, double height) const {
  double units = 0.0;
  for (const char32_t character : decode_utf8(text)) {
    int advance = 0, bearing = 0;
    stbtt_GetCodepointHMetrics(&state_->info, int(character), &advance, &bearing);
    units += advance;
  }
  return {units * stbtt_ScaleForPixelHeight(&state_->info, float(height)), height};
}

}  // namespace psm
