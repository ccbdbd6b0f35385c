// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/json_fault.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace psm {
namespace {

using nlohmann::json;

std::string fault_of(const std::string& text) {
  try {
    [[maybe_unused]] const json tree = json::parse(text);
  } catch (const json::parse_error& error) {
    return json_fault(error.what(), text, error.byte);
  } catch (const json::out_of_range& error) {
    return json_fault(error.what(), text, text.size());
  }
  return "none";
}

TEST(JsonFault, NamesWhatStandsThereAndWhatIsAllowed) {
  const std::string values =
      " is no value; allowed: a finite number, a text in double quotes, true, false, null, a list or an object";
  const std::pair<const char*, std::string> table[] = {
      {"[1, NaN]", "NaN" + values},
      {"[nan, 1]", "nan" + values},
      {"{\"a\": -Infinity}", "-Infinity" + values},
      {"[True]", "True" + values},
      {"{\"a\": 'b'}", "'" + values},
      {"[+1]", "+1" + values},
      {"[.5]", ".5" + values},
      {"[1.]", "1." + values},
      {"[1e999]", "'1e999' is beyond the range of numbers; allowed: finite numbers"},
      {"", "it ends too early; allowed: all of it"},
      {"{\"a\": [1, 2", "it ends too early; allowed: all of it"},
      {"[1 2]", "unexpected 2; allowed: ',' or ']'"},
      {"{\"a\": 1 \"b\": 2}", "unexpected \"b\"; allowed: ',' or '}'"},
      {"{\"a\" 1}", "unexpected 1; allowed: ':'"},
      {"[1,]", "unexpected ]; allowed: '[', '{', or a value"},
      {"{} {}", "unexpected {; allowed: nothing more"},
      {"{\"a\": 1,}", "unexpected }; allowed: a name in double quotes"},
  };
  for (const auto& [text, fault] : table) EXPECT_EQ(fault_of(text), fault) << text;
}

TEST(JsonFault, IsOneLineWhateverTheText) {
  for (const char* text :
       {"[\"a\nb\"]", "[\"\\q\"]", "{\n\n  a: 1}", "\x89PNG\r\n", "[\xff]", "[\"\xc3\"]", "\n\n", "\"", "[\"a]\n"}) {
    const std::string fault = fault_of(text);
    EXPECT_EQ(fault.find('\n'), std::string::npos) << text;
    EXPECT_NE(fault.find("; allowed: "), std::string::npos) << fault;
  }
}

}  // namespace
}  // namespace psm
