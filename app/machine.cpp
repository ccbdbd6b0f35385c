// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machine.h"

#include <fstream>

#include "app/numbers.h"

namespace psm {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = __VERSION__;  // names itself
#else
constexpr const char* kCompiler = "GCC " __VERSION__;
#endif

#ifdef __OPTIMIZE__
constexpr const char* kBuild = "";
#else
constexpr const char* kBuild = ", not optimised";
#endif

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (const std::size_t colon = line.find(": "); line.rfind("model name", 0) == 0 && colon != std::string::npos)
      return one_line(line.substr(colon + 2));
  return "unknown processor";
}

}  // namespace

Machine this_machine() { return {cpu_name(), std::string(kCompiler) + kBuild}; }

}  // namespace psm
