// SPDX-License-Identifier: GPL-3.0-or-later
// A view's texts as they stand on a picture, measured without a typeface.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "draw/annotation.h"
#include "draw/utf8.h"

namespace psm::testing {

/// About as wide and high as the typeface's.
inline glm::dvec2 text_size(const std::string& text) { return {8.0 * double(decode_utf8(text).size()), kTextHeight}; }

inline bool overlap(const TextBox& a, const TextBox& b) {
  return a.top_left.x < b.top_left.x + b.size.x && b.top_left.x < a.top_left.x + a.size.x &&
         a.top_left.y < b.top_left.y + b.size.y && b.top_left.y < a.top_left.y + a.size.y;
}

inline std::vector<TextBox> texts_on(const ViewPicture& picture, glm::ivec2 size) {
  return annotate(picture, {glm::dvec2(size), 1.0, Theme::light}, text_size).texts;
}

/// None is cut, and none stands over another.
inline void expect_readable(const std::vector<TextBox>& texts, glm::ivec2 size, const std::string& what) {
  for (std::size_t a = 0; a < texts.size(); ++a) {
    const glm::dvec2 begin = texts[a].top_left, end = begin + texts[a].size;
    EXPECT_TRUE(begin.x >= 0 && begin.y >= 0 && end.x <= size.x && end.y <= size.y)
        << what << ": " << texts[a].text << " is cut at " << size.x << " x " << size.y;
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_FALSE(overlap(texts[a], texts[b]))
          << what << ": " << texts[a].text << " over " << texts[b].text << " at " << size.x << " x " << size.y;
  }
}

}  // namespace psm::testing
