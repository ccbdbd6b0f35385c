// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/experiment_members.h"

#include <algorithm>
#include <cmath>

#include "scene/experiment_file.h"
#include "scene/field_reader.h"

namespace psm {
namespace {

/// What FieldReader reads from. A vector is "0,1,-0.2", or the same in brackets and with blanks, as it is copied from a file.
struct TextSource {
  const std::string& typed;

  std::optional<double> number() const { return number_from_text(typed); }
  std::optional<std::string> text() const { return typed; }
  std::optional<std::vector<std::string>> names() const {
    std::vector<std::string> list;
    for (std::size_t start = 0; start <= typed.size();) {
      const std::size_t end = std::min(typed.find(',', start), typed.size());
      list.push_back(typed.substr(start, end - start));
      start = end + 1;
    }
    return list;
  }
  template <int N>
  bool vector(glm::vec<N, double>& values) const {
    std::string rest = typed;
    rest.erase(std::remove(rest.begin(), rest.end(), ' '), rest.end());
    if (rest.size() >= 2 && rest.front() == '[' && rest.back() == ']') rest = rest.substr(1, rest.size() - 2);
    for (int i = 0; i < N; ++i) {
      const std::size_t comma = rest.find(',');
      if ((comma == std::string::npos) != (i == N - 1)) return false;
      const auto number = number_from_text(rest.substr(0, comma));
      if (!number) return false;
      values[i] = *number;
      if (comma != std::string::npos) rest.erase(0, comma + 1);
    }
    return true;
  }
  bool is(const std::string& word) const { return typed == word; }
};

/// Reads one override into `experiment`, range checked; the row that it set.
Result<const Field*> read_override(Experiment& experiment, const std::string& path_and_value) {
  const std::size_t equals = path_and_value.find('=');
  if (equals == std::string::npos || equals == 0)
    return InputError{quotable(path_and_value) + ": no value; allowed: PATH=VALUE, such as light.to_light=0,1,-0.2"};
  const std::string path = path_and_value.substr(0, equals), value = path_and_value.substr(equals + 1);
  const Field* field = find_field(path);
  if (!field) return unknown_member(path);
  if (!read_into(*field, TextSource{value}, experiment) || check_field(*field, experiment))
    return not_allowed(path, value.empty() ? "an empty value" : quotable(value), allowed_values(*field));
  return field;
}

void copy_member(const Field& field, const Experiment& from, Experiment& to) {
  std::visit(
      [&](const auto& member) {
        if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Choice>) {
          member.set(to, member.get(from));
        } else {
          member(to) = member(const_cast<Experiment&>(from));
        }
      },
      field.member);
}

}  // namespace

Experiment scene_experiment(const std::string& source, const Scene& scene) {
  Experiment experiment;
  experiment.scene.source = source;
  if (scene.camera) experiment.camera = *scene.camera;
  if (scene.light) experiment.light = *scene.light;
  return experiment;
}

bool ExperimentMembers::has(const std::string& path) const {
  return std::any_of(set.begin(), set.end(), [&](const Field* field) { return field->path == path; });
}

void ExperimentMembers::copy_to(Experiment& experiment) const {
  for (const Field* field : set) copy_member(*field, values, experiment);
}

void ExperimentMembers::add(const ExperimentMembers& over) {
  over.copy_to(values);
  for (const Field* field : over.set)
    if (!has(field->path)) set.push_back(field);
}

Result<ExperimentMembers> members_from_overrides(const std::vector<std::string>& overrides) {
  ExperimentMembers members;
  for (const std::string& text : overrides) {
    const auto field = read_override(members.values, text);
    if (!field) return field.error();
    members.set.push_back(*field);
  }
  return members;
}

std::optional<InputError> set_field(Experiment& experiment, const std::string& path_and_value) {
  Experiment changed = experiment;
  const auto field = read_override(changed, path_and_value);
  if (!field) return field.error();
  if (auto error = check_experiment(changed)) return error;
  experiment = std::move(changed);
  return std::nullopt;
}

std::string quotable(const std::string& text) {
  constexpr std::size_t most = 80;
  std::size_t length = std::min(text.size(), most);
  const auto continues_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  while (length < text.size() && length > 0 && continues_character(text[length])) --length;
  std::string line = text.substr(0, length);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return length < text.size() ? line + "..." : line;
}

InputError not_allowed(const std::string& path, const std::string& value, const std::string& allowed) {
  return {path + ": " + value + " is not allowed; allowed: " + allowed};
}

InputError unknown_member(const std::string& path) {
  // The deepest object of the path that exists, and the names in it.
  std::string parent = path;
  std::vector<std::string> names;
  while (names.empty()) {
    const std::size_t dot = parent.rfind('.');
    parent = dot == std::string::npos ? "" : parent.substr(0, dot);
    const std::string prefix = parent.empty() ? "" : parent + ".";
    for (const Field& field : experiment_fields()) {
      if (!field.path.starts_with(prefix)) continue;
      const std::string name = field.path.substr(prefix.size(), field.path.find('.', prefix.size()) - prefix.size());
      if (names.empty() || names.back() != name) names.push_back(name);
    }
  }
  std::string allowed;
  for (const std::string& name : names) allowed += (allowed.empty() ? "" : ", ") + (parent.empty() ? name : parent + "." + name);
  return {quotable(path) + ": no such member; allowed: " + allowed};
}

}  // namespace psm
