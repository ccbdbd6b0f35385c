// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/json_check.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "scene/experiment_members.h"
#include "scene/json_fault.h"

namespace psm {
namespace {

using nlohmann::ordered_json;

/// Thrown inside the parser's callback, and caught where the parser is called.
struct Refused {
  InputError error;
};

/// Follows the parser, to refuse what the tree would no longer show (a member given twice) or should not hold (deep nesting).
class ParseGuard {
 public:
  bool operator()(int, ordered_json::parse_event_t event, ordered_json& parsed) {
    using Event = ordered_json::parse_event_t;
    if (event == Event::object_start || event == Event::array_start) enter();
    if (event == Event::object_end || event == Event::array_end) levels_.pop_back();
    if (event == Event::key) name(parsed.get<std::string>());
    return true;
  }

  std::string path() const {
    std::string text;
    for (const Level& level : levels_)
      if (!level.current.empty()) text += (text.empty() ? "" : ".") + level.current;
    return quotable(text);
  }

 private:
  struct Level {
    std::set<std::string> names;
    std::string current;
  };

  void enter() {
    constexpr std::size_t deepest = 16;
    if (levels_.size() == deepest)
      throw Refused{{(path().empty() ? "the file" : path()) + ": nested too deeply; allowed: 16 levels"}};
    levels_.emplace_back();
  }
  void name(const std::string& text) {
    levels_.back().current = text;
    if (!levels_.back().names.insert(text).second) throw Refused{{path() + ": given twice; allowed: once"}};
  }

  std::vector<Level> levels_;
};

/// The parser's message without its own identifier, "[json.exception.parse_error.101] ".
std::string parser_message(const std::exception& error) {
  const std::string text = error.what();
  const std::size_t end = text.find("] ");
  std::string line = text.starts_with("[json") && end != std::string::npos ? text.substr(end + 2) : text;
  if (line.size() > 200) line = line.substr(0, 200) + "...";
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  return line;
}

}  // namespace

std::optional<InputError> check_json(const std::string& text) {
  ParseGuard guard;
  try {
    [[maybe_unused]] const ordered_json tree = ordered_json::parse(text, std::ref(guard));
    return std::nullopt;
  } catch (const Refused& refused) {
    return refused.error;
  } catch (const ordered_json::out_of_range& error) {
    return InputError{guard.path() + ": " + parser_message(error) + "; allowed: finite numbers, and \"inf\" for camera.far"};
  } catch (const ordered_json::parse_error& error) {
    const auto end = text.begin() + std::ptrdiff_t(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    return InputError{"not JSON: line " + std::to_string(line) + ": " + json_fault(error.what(), text, error.byte)};
  }
}

}  // namespace psm
