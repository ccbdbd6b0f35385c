// SPDX-License-Identifier: GPL-3.0-or-later
// JSON for reading: a tree of values, each with the line it stands on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/result.h"

namespace psm {

struct JsonTree {
  enum class Kind { null, boolean, number, text, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0.0;
  std::string text;
  std::vector<std::string> names;  // of an object's items
  std::vector<JsonTree> items;
  int line = 1;

  /// Of an object: the member of this name, or null.
  const JsonTree* find(const std::string& name) const;
  /// "light_case.light_post.3": members by name, elements by index; null where the path leads nowhere.
  const JsonTree* at(const std::string& path) const;
  /// One line of JSON, for messages and for readers of JSON text.
  std::string to_text() const;
};

/// The error starts with the line: "12: ...". A member given twice and nesting beyond 16 levels are errors.
Result<JsonTree> parse_json(const std::string& text);

}  // namespace psm
