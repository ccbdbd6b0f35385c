// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/member_reader.h"

#include <algorithm>

namespace psm {
namespace {

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The line of the deepest member that "light.to_light: ..." names.
int line_of_path(const JsonTree& node, const std::string& message) {
  const std::string path = message.substr(0, message.find(':'));
  for (std::size_t end = path.size(); end != std::string::npos; end = end == 0 ? std::string::npos : path.rfind('.', end - 1))
    if (const JsonTree* found = node.at(path.substr(0, end))) return found->line;
  return node.line;
}

}  // namespace

void ReadState::fail(int line, const std::string& what) {
  if (!error) error = InputError{quotable(file) + ":" + std::to_string(line) + ": " + what};
}

void MemberReader::fail(const std::string& what) const { state_.fail(node_.line, (path_.empty() ? "" : path_ + ": ") + what); }

bool MemberReader::expect(JsonTree::Kind kind, const char* what) const {
  if (!fine()) return false;
  if (node_.kind == kind) return true;
  fail(quotable(node_.to_text()) + " is not allowed; allowed: " + what);
  return false;
}

bool MemberReader::has_only(const std::vector<std::string>& allowed) const {
  if (!expect(JsonTree::Kind::object, "an object")) return false;
  for (std::size_t i = 0; i < node_.names.size(); ++i) {
    if (contains(allowed, node_.names[i])) continue;
    state_.fail(node_.items[i].line,
                (path_.empty() ? "" : path_ + ".") + quotable(node_.names[i]) + ": no such member; allowed: " + list_of(allowed));
    return false;
  }
  return true;
}

MemberReader MemberReader::member(const std::string& name, bool required) const {
  static const JsonTree nothing;
  const JsonTree* found = node_.find(name);
  const std::string path = (path_.empty() ? "" : path_ + ".") + name;
  if (!found && required && fine()) state_.fail(node_.line, path + ": is missing; allowed: a value, it is required");
  return {state_, found ? *found : nothing, path};
}

std::vector<MemberReader> MemberReader::elements() const {
  std::vector<MemberReader> out;
  if (!expect(JsonTree::Kind::array, "a list")) return out;
  for (std::size_t i = 0; i < node_.items.size(); ++i) out.emplace_back(state_, node_.items[i], path_ + "." + std::to_string(i));
  return out;
}

double MemberReader::number(double lowest, double highest) const {
  const std::string allowed = "a number in [" + number_text(lowest) + ", " + number_text(highest) + "]";
  if (!expect(JsonTree::Kind::number, allowed.c_str())) return lowest;
  if (node_.number >= lowest && node_.number <= highest) return node_.number;
  fail(node_.to_text() + " is not allowed; allowed: " + allowed);
  return lowest;
}

bool MemberReader::boolean() const { return expect(JsonTree::Kind::boolean, "true or false") && node_.boolean; }

std::string MemberReader::text() const {
  if (!expect(JsonTree::Kind::text, "a text")) return "";
  const std::string& text = node_.text;
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) fail("an empty text; allowed: some words");
  if (text.find('\0') != std::string::npos) fail("a zero character; allowed: text");
  return text;
}

std::string MemberReader::one_of(const std::vector<std::string>& allowed) const {
  const std::string name = text();
  if (fine() && !contains(allowed, name)) fail(quotable(node_.to_text()) + " is not allowed; allowed: " + list_of(allowed));
  return name;
}

Prose MemberReader::prose() const {
  const std::string source = text();
  if (!fine()) return {};
  auto blocks = parse_markdown(source);
  if (!blocks) {
    const std::string& message = blocks.error().text;
    fail(message.substr(message.find(": ") + 2));  // its line is within the text
    return {};
  }
  for (Block& block : *blocks)
    for (Inline& run : block.runs) run.line = node_.line;
  return std::move(*blocks);
}

ExperimentMembers MemberReader::experiment() const {
  if (!expect(JsonTree::Kind::object, "an object of the experiment's members")) return {};
  auto members = members_from_json(node_.to_text());
  if (members) return std::move(*members);
  state_.fail(line_of_path(node_, members.error().text), path_ + "." + members.error().text);
  return {};
}

}  // namespace psm
