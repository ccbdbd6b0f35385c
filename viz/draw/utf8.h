// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace psm {

/// The code points of UTF-8 text; what is malformed becomes U+FFFD.
std::u32string decode_utf8(const std::string& text);

}  // namespace psm
