// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/share_text.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace psm {
namespace {

const std::string kScheme = "psmlab:";

bool is_plain(unsigned char c) { return c < 0x80 && (std::isalnum(c) || (c && std::strchr("-._~/,:+", c))); }

std::string escaped(const std::string& text) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string out;
  for (const unsigned char c : text) {
    if (is_plain(c))
      out += char(c);
    else
      (out += '%') += {digits[c >> 4], digits[c & 15]};
  }
  return out;
}

Result<std::string> unescaped(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    const std::string digits = text.substr(i + 1, 2);
    if (digits.size() < 2 || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
      return InputError{quotable("%" + digits) + ": no such escape; allowed: %25 for %, and two hexadecimal digits for others"};
    out += char(std::stoi(digits, nullptr, 16));
    i += 2;
  }
  return out;
}

/// Without blanks at its ends, and without the line breaks that a mail may have put in.
std::string one_piece(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }), text.end());
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string> pieces(const std::string& text, char separator) {
  std::vector<std::string> out;
  for (std::size_t start = 0, end = 0; end != std::string::npos; start = end + 1) {
    end = text.find(separator, start);
    out.push_back(text.substr(start, end == std::string::npos ? end : end - start));
  }
  return out;
}

std::optional<InputError> given_twice(const ExperimentMembers& members) {
  for (auto at = members.set.begin(); at != members.set.end(); ++at)
    if (std::find(members.set.begin(), at, *at) != at) return InputError{(*at)->path + ": given twice; allowed: once"};
  return std::nullopt;
}

}  // namespace

std::string share_text(const Experiment& experiment, const Scene& scene) {
  const Experiment plain = scene_experiment(experiment.scene.source, scene);
  std::string text = kScheme + escaped(experiment.scene.source);
  char separator = '?';
  for (const Field& field : experiment_fields()) {
    const std::string value = value_text(field, experiment);
    if (!field.applies(experiment) || value == value_text(field, plain)) continue;
    ((text += separator) += field.path + "=") += escaped(value);
    separator = '&';
  }
  return text;
}

bool is_share_text(const std::string& text) { return one_piece(text.substr(0, 256)).starts_with(kScheme); }

Result<ExperimentMembers> members_from_pairs(const std::string& pairs) {
  std::vector<std::string> overrides;
  for (const std::string& pair : pairs.empty() ? std::vector<std::string>() : pieces(pairs, '&')) {
    if (pair.empty())
      return InputError{"member " + std::to_string(overrides.size() + 1) + " of \"" + quotable(pairs) +
                        "\" is empty; allowed: PATH=VALUE, with one & between two of them"};
    const auto plain = unescaped(pair);
    if (!plain) return plain.error();
    overrides.push_back(*plain);
  }
  auto members = members_from_overrides(overrides);
  if (members)
    if (auto error = given_twice(*members)) return *error;
  return members;
}

Result<ExperimentMembers> members_from_share_text(const std::string& text) {
  const std::string rest = one_piece(text).substr(kScheme.size());
  const std::size_t query = rest.find('?');
  if (rest.find('&') < query)
    return InputError{quotable(rest) + ": & before any ?; allowed: psmlab:SCENE?PATH=VALUE&PATH=VALUE, %26 for & in a path"};
  const auto source = unescaped(rest.substr(0, query));
  if (!source) return source.error();
  auto members = members_from_pairs(query == std::string::npos ? "" : rest.substr(query + 1));
  if (!members) return members;
  if (members->has("scene.source")) return InputError{"scene.source: given twice; allowed: once, before the ?"};
  const Field* field = find_field("scene.source");
  if (!source->empty()) members->values.scene.source = *source;
  members->set.push_back(field);
  if (check_field(*field, members->values)) return not_allowed(field->path, quotable(*source), allowed_values(*field));
  return members;
}

}  // namespace psm
