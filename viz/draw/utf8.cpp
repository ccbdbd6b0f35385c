// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/utf8.h"

namespace psm {
namespace {

/// How many bytes follow a first byte, and the bits it gives; -1: it cannot be a first byte.
int continuation(unsigned char lead, char32_t& bits) {
  if (lead < 0x80) return bits = lead, 0;
  if ((lead & 0xE0) == 0xC0) return bits = lead & 0x1F, 1;
  if ((lead & 0xF0) == 0xE0) return bits = lead & 0x0F, 2;
  if ((lead & 0xF8) == 0xF0) return bits = lead & 0x07, 3;
  return -1;
}

}  // namespace

std::u32string decode_utf8(const std::string& text) {
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    char32_t code = 0xFFFD;
    const int more = continuation(static_cast<unsigned char>(text[i]), code);
    ++i;
    for (int k = 0; k < more; ++k, ++i) {
      if (i >= text.size() || (text[i] & 0xC0) != 0x80) {
        code = 0xFFFD;
        break;
      }
      code = (code << 6) | (static_cast<unsigned char>(text[i]) & 0x3F);
    }
    out.push_back(more < 0 ? U'\xFFFD' : code);
  }
  return out;
}

}  // namespace psm
