// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace psm {

/// What is wrong with a text that is not JSON, in words for whoever wrote it: "NaN is no value; allowed: a finite number, ...".
/// `said`: the parser's own message; `read`: how many bytes of the text it had read by then.
std::string json_fault(const std::string& said, const std::string& text, std::size_t read);

}  // namespace psm
