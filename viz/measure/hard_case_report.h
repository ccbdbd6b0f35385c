// SPDX-License-Identifier: GPL-3.0-or-later
// The table of hard cases, run and timed on this machine, as text, CSV or JSON.
#pragma once

#include <string>
#include <vector>

#include "measure/hard_cases.h"

namespace psm {

struct MeasuredCase {
  HardCase row;
  CaseAnswer in_float, in_double, two_stages;
  double float_seconds = 0, double_seconds = 0;  // one evaluation: the median of several batches; float 0 where there is none
  Verdict verdict = Verdict::holds;
};

std::vector<MeasuredCase> measure_hard_cases();

/// What the numbers were made with.
struct Machine {
  std::string cpu, compiler;
};

std::string hard_cases_text(const std::vector<MeasuredCase>& cases, const Machine& machine);
std::string hard_cases_csv(const std::vector<MeasuredCase>& cases, const Machine& machine);
std::string hard_cases_json(const std::vector<MeasuredCase>& cases, const Machine& machine);

}  // namespace psm
