// SPDX-License-Identifier: GPL-3.0-or-later
// text.md as blocks and inline runs. md4c parses; what lessons do not use is an error with its line.
#pragma once

#include <string>
#include <vector>

#include "scene/result.h"

namespace psm {

/// A piece of text of one kind. `text`: words, code, a path of the analysis' JSON (live), or a formula in TeX.
struct Inline {
  enum class Kind { words, code, live, formula, display_formula, line_break };
  Kind kind = Kind::words;
  std::string text;
  bool emphasis = false, strong = false;
  std::string link;  // where it leads; empty: nowhere
  int line = 0;
  bool operator==(const Inline&) const = default;
};

/// A paragraph or heading; an item of a list has a marker and stands `indent` levels deep.
struct Block {
  int heading = 0;     // 1 to 3; 0: a paragraph
  int indent = 0;      // of lists, one for each level
  std::string marker;  // "•", "1."; empty for an item's further paragraphs and outside lists
  bool quote = false;
  std::vector<Inline> runs;
  int line = 0;
  bool operator==(const Block&) const = default;
};

/// The error starts with the line: "12: ...".
Result<std::vector<Block>> parse_markdown(const std::string& text);

/// The words of a block, formulas and code as they are written.
std::string plain_text(const Block& block);

}  // namespace psm
