// SPDX-License-Identifier: GPL-3.0-or-later
// The signs of formulas: what stands for a command of TeX or for a character. Private to viz/lesson.
#pragma once

#include <string>

#include "lesson/formula.h"

namespace psm {

struct FormulaSymbol {
  const char* text;
  Formula::Role role = Formula::Role::ordinary;
  bool italic = false;
};

/// Of "alpha", which is written \alpha; null where there is none.
const FormulaSymbol* symbol_of_command(const std::string& name);
/// Of what is neither a letter nor a digit; null where there is none.
const FormulaSymbol* symbol_of_character(char c);

}  // namespace psm
