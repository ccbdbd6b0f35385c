// SPDX-License-Identifier: GPL-3.0-or-later
// psmlab report: the speed-against-error study as a folder with rows, plots and one page.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace psm {

struct ReportArguments {
  std::string out;
  bool quick = false;
  std::optional<std::string> shard;  // "I/N", as typed
  std::vector<std::string> merge;    // folders of other reports; none: measure
};

int report(const ReportArguments& arguments);

}  // namespace psm
