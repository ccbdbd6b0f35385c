// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measure.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/numbers.h"
#include "measure/hard_case_report.h"

namespace psm {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = __VERSION__;  // names itself
#else
constexpr const char* kCompiler = "GCC " __VERSION__;
#endif

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (const std::size_t colon = line.find(": "); line.rfind("model name", 0) == 0 && colon != std::string::npos)
      return one_line(line.substr(colon + 2));
  return "unknown processor";
}

}  // namespace

int measure(const MeasureArguments& arguments) {
  if (!arguments.hard_cases) {
    complain("measure: only --hard-cases is built so far; allowed: psmlab measure --hard-cases [--csv or --json]");
    return kBadInput;
  }
  if (arguments.csv && arguments.json) {
    complain("--csv, --json: both were given; allowed: one of them");
    return kBadInput;
  }
#ifdef __OPTIMIZE__
  const char* build = "";
#else
  const char* build = ", not optimised";
#endif
  const Machine machine{cpu_name(), std::string(kCompiler) + build};
  const auto cases = measure_hard_cases();
  const auto format = arguments.csv ? hard_cases_csv : arguments.json ? hard_cases_json : hard_cases_text;
  if (print(format(cases, machine)) && std::fflush(stdout) == 0) return kDone;
  complain(std::string("standard output: cannot be written: ") + std::strerror(errno ? errno : EIO));
  return kOtherFailure;
}

}  // namespace psm
