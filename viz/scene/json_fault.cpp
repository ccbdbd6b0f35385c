// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/json_fault.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "scene/experiment_members.h"

namespace psm {
namespace {

constexpr const char* kValues = "a finite number, a text in double quotes, true, false, null, a list or an object";

bool says(const std::string& said, const char* words) { return said.find(words) != std::string::npos; }

bool in_word(unsigned char c) { return c >= 0x80 || std::isalnum(c) || (c && std::strchr("+-._", c)); }

/// The word, the text in quotes or the sign that ends with, or goes on behind, this many bytes.
std::string token_at(const std::string& text, std::size_t read, bool is_number) {
  if (text.empty()) return "";
  std::size_t last = std::min(std::max<std::size_t>(read, 1), text.size()) - 1;
  if (is_number && last > 0 && !in_word(text[last])) --last;  // a number is over where something else follows
  if (text[last] == '"' && last > 0) {
    const std::size_t opening = text.rfind('"', last - 1);
    return opening == std::string::npos ? "\"" : text.substr(opening, last - opening + 1);
  }
  if (!in_word(text[last])) return std::string(1, text[last]);
  std::size_t first = last;
  while (first > 0 && in_word(text[first - 1])) --first;
  while (last + 1 < text.size() && in_word(text[last + 1])) ++last;
  return text.substr(first, last - first + 1);
}

/// What the parser would have taken; after an element it names the closing bracket alone.
std::string expected_in(const std::string& said) {
  const std::string mark = "; expected ";
  std::string expected = said.substr(said.find(mark) + mark.size());
  if (expected == "'}'" || expected == "']'") return "',' or " + expected;
  if (expected == "string literal") return "a name in double quotes";
  if (expected == "end of input") return "nothing more";
  if (const std::size_t at = expected.find("a literal"); at != std::string::npos) expected.replace(at, 9, "a value");
  return expected;
}

}  // namespace

std::string json_fault(const std::string& said, const std::string& text, std::size_t read) {
  const std::string too_large = "number overflow parsing ";
  if (const std::size_t at = said.find(too_large); at != std::string::npos)
    return quotable(said.substr(at + too_large.size())) + " is beyond the range of numbers; allowed: finite numbers";
  const bool is_number = says(said, "invalid number");
  const std::string token = quotable(token_at(text, read, is_number));
  if (says(said, "unexpected end of input") || read > text.size()) return "it ends too early; allowed: all of it";
  if (is_number || says(said, "invalid literal")) return token + " is no value; allowed: " + kValues;
  if (says(said, "; expected ")) return "unexpected " + token + "; allowed: " + expected_in(said);
  const std::size_t begin = said.find("invalid string");
  return (begin == std::string::npos ? "unexpected " + token : said.substr(begin, said.find("; last read") - begin)) +
         "; allowed: JSON";
}

}  // namespace psm
