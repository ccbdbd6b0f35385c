// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <regex>
#include <string>
#include <vector>

namespace psm::testing {

/// What keeps the text from being well-formed XML, in words; empty where nothing does. Attributes are not looked into.
inline std::string unclosed_tags(const std::string& text) {
  static const std::regex tag("<(/?)([A-Za-z][A-Za-z0-9]*)((?:[^<>\"]|\"[^\"<]*\")*?)(/?)>|<[?!][^>]*>|<");
  std::vector<std::string> open;
  for (std::sregex_iterator i(text.begin(), text.end(), tag), end; i != end; ++i) {
    const std::smatch& m = *i;
    if (m.str() == "<") return "a bare '<' at " + std::to_string(m.position());
    if (!m[2].matched || m[4].length()) continue;
    if (!m[1].length()) {
      open.push_back(m[2]);
    } else if (open.empty() || open.back() != m[2].str()) {
      return "</" + m[2].str() + "> closes " + (open.empty() ? "nothing" : "<" + open.back() + ">");
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

}  // namespace psm::testing
