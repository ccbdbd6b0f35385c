// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas in the part of TeX that lessons use, as a small tree.
#pragma once

#include <string>
#include <vector>

#include "scene/result.h"

namespace psm {

struct Formula {
  enum class Kind {
    row,       // parts side by side
    symbol,    // `text`
    space,     // `width` in em
    fraction,  // parts: numerator, denominator
    root,      // parts: what is under it
    scripts,   // parts: base, below, above; a row without parts where there is none
    hat,       // parts: what is under it
    bar,
    fenced  // parts: content; `text` and `right` are its fences, "." for none
  };
  /// What decides the space around a symbol.
  enum class Role { ordinary, binary, relation, opening, closing, punctuation, function };

  Kind kind = Kind::row;
  Role role = Role::ordinary;
  std::string text, right;
  bool italic = false, bold = false;
  double width = 0.0;
  std::vector<Formula> parts;
};

/// The error says what is wrong and what is allowed, without a place.
Result<Formula> parse_formula(const std::string& tex);

}  // namespace psm
