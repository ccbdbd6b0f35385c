// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/hard_cases.h"

#include <algorithm>
#include <cmath>

#include "measure/hard_case_rows.h"

namespace psm {

std::vector<HardCase> hard_cases() {
  Rows rows;
  add_float_cases(rows);
  add_warp_cases(rows);
  add_projection_cases(rows);
  add_convention_cases(rows);
  add_scene_cases(rows);
  add_caster_cases(rows);
  std::vector<HardCase> table = rows.take();
  std::stable_sort(table.begin(), table.end(), [](const HardCase& a, const HardCase& b) { return a.number < b.number; });
  return table;
}

bool meets(const HardCase& row, const CaseAnswer& answer, double bound) {
  if (row.demand == Demand::said || row.demand == Demand::refused) return answer.named == row.reason;
  if (!answer.named.empty()) return false;
  const double value = answer.value, exact = row.exact.value;
  switch (row.demand) {
    case Demand::equals:
      if (std::isinf(exact)) return value == exact;
      return std::abs(value - exact) <= bound * (exact == 0 ? 1 : std::abs(exact));
    case Demand::texels:
      return answer.texels <= bound;
    case Demand::at_most:
      return value <= bound;
    default:
      return value > bound;
  }
}

const char* name_of(Verdict v) {
  constexpr const char* names[] = {"holds", "float fails", "refused by name", "naive form fails", "known limit", "BROKEN"};
  return names[int(v)];
}

Verdict judge(const HardCase& row, const CaseAnswer& in_float, const CaseAnswer& in_double) {
  const bool float_meets = !row.in_float || meets(row, in_float, row.float_bound);
  const bool double_meets = meets(row, in_double, row.double_bound);
  if (row.form == Form::naive) return float_meets && double_meets ? Verdict::holds : Verdict::naive_fails;
  if (!double_meets) return row.known_limit ? Verdict::known_limit : Verdict::broken;
  if (!float_meets) return Verdict::float_fails;
  return row.demand == Demand::refused ? Verdict::refused : Verdict::holds;
}

}  // namespace psm
