// SPDX-License-Identifier: GPL-3.0-or-later
// JSON for writing: a tree of values in the order in which they were added.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/experiment.h"

namespace psm {

class JsonNode {
 public:
  JsonNode() = default;    // null
  JsonNode(double value);  // finite numbers round-trip; "inf", "-inf"; a NaN is null, and nan_paths() finds it
  JsonNode(const std::string& text);
  JsonNode(const char* text) : JsonNode(std::string(text)) {}
  JsonNode(const std::optional<double>& value) : JsonNode(value ? JsonNode(*value) : JsonNode()) {}
  template <int N>
  JsonNode(const glm::vec<N, double>& v) : kind_(Kind::array) {
    for (int i = 0; i < N; ++i) items_.push_back(v[i]);
  }
  static JsonNode integer(long long value);
  static JsonNode boolean(bool value);
  static JsonNode array() { return JsonNode(Kind::array); }
  static JsonNode object() { return JsonNode(Kind::object); }
  void make_object() { kind_ = Kind::object; }

  /// Of an object: the member of this name, added as null if there is none.
  JsonNode& operator[](const std::string& name);
  void push_back(JsonNode item) { items_.push_back(std::move(item)); }

  /// Two-space indented; an array of scalars stays on one line. Ends without a newline.
  std::string to_text() const;

  /// The JSON paths at which a NaN was turned into null.
  std::vector<std::string> nan_paths() const;

 private:
  enum class Kind { scalar, array, object };
  explicit JsonNode(Kind kind) : kind_(kind) {}
  void write(std::string& out, const std::string& indent) const;
  void write_items(std::string& out, const std::string& indent) const;
  bool only_scalars() const;
  void collect_nans(const std::string& path, std::vector<std::string>& paths) const;

  Kind kind_ = Kind::scalar;
  std::string scalar_ = "null";
  bool was_nan_ = false;
  std::vector<std::string> names_;  // of an object's items
  std::vector<JsonNode> items_;
};

/// All members that apply, under "psmlab": 1.
JsonNode experiment_node(const Experiment& experiment);

}  // namespace psm
