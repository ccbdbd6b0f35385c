// SPDX-License-Identifier: GPL-3.0-or-later
// The hard cases of shadow mapping in one table: inputs at which formulas cancel, divide by zero, jump or do not exist, each with
// its exact answer or with what must hold, computed in float, in double, and exactly.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace psm {

/// What one arithmetic gives. A value that is not a number is an answer too; `named` is the name of the reason where the program
/// gives none, or of what it says about it.
struct CaseAnswer {
  double value = std::numeric_limits<double>::quiet_NaN();
  double texels = std::numeric_limits<double>::quiet_NaN();  // error on a map of 1,024; NaN: no map is involved
  std::string named;
};

enum class Demand {
  equals,   // the exact answer, within a relative error (absolute where the answer is 0)
  texels,   // the error in texels at most the bound
  at_most,  // the value at most the bound
  above,    // the value greater than the bound
  said,     // the name in HardCase::reason stands in what the program tells the user
  refused   // the same, and there is no answer
};

/// What psmlab does, or what others do and psmlab does not; then the row exists to show the difference.
enum class Form { ours, naive };

/// How the exact answer is known: a fraction of integers, or 100 digits that round to the same double as 200 do.
enum class ExactKind { none, rational, digits };

/// The exact answer, rounded once.
struct Exact {
  double value = std::numeric_limits<double>::quiet_NaN();
  ExactKind kind = ExactKind::none;
  bool settled = true;  // digits: 100 and 200 of them round to the same double
  double seconds = 0;   // digits: one evaluation with 100
};

using Compute = std::function<CaseAnswer()>;

struct HardCase {
  int number = 0;        // in the list of hard cases, 1 to 43; 0: the conventions that hold for all of them
  std::string name;      // the case
  std::string computed;  // the quantity, its unit, and the function
  Form form = Form::ours;
  Demand demand = Demand::equals;
  double double_bound = 0;      // what double must meet
  double float_bound = 0;       // what the use of the number needs; float is held to that
  std::string reason;           // said, refused
  Exact exact;                  // of the same inputs, by a formula of its own or by the same one
  bool known_limit = false;     // ours, and it fails in every arithmetic: a limit of what psmlab does
  Compute in_float, in_double;  // in_float empty: the program has no float path here
  Compute two_stages;           // maps: in float with two matrices for each vertex, for comparison; else empty
};

/// All of them, ordered by number.
std::vector<HardCase> hard_cases();

/// Whether the answer meets the demand; `bound` is the one of the arithmetic that gave it.
bool meets(const HardCase& row, const CaseAnswer& answer, double bound);

enum class Verdict { holds, float_fails, refused, naive_fails, known_limit, broken };
const char* name_of(Verdict);

/// `broken`: double fails where psmlab must not, and nobody has said so.
Verdict judge(const HardCase& row, const CaseAnswer& in_float, const CaseAnswer& in_double);

}  // namespace psm
