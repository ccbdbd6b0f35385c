// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/numbers.h"

namespace psm {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

InputError flag_error(const char* flag, const std::string& value, const std::string& allowed) {
  return {std::string(flag) + ": " + quoted_argument(value) + " is not allowed; allowed: " + allowed};
}

std::string quoted_argument(const std::string& text) {
  constexpr std::size_t most = 80;
  return "'" + one_line(text.size() > most ? text.substr(0, most) + "..." : text) + "'";
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace psm
