// SPDX-License-Identifier: GPL-3.0-or-later
// Members of JSON objects as values of the kinds that lessons are made of. The first error stays, with file, line and path;
// after it everything reads as its default. Private to viz/lesson.
#pragma once

#include <string>
#include <vector>

#include "lesson/json_tree.h"
#include "lesson/lesson.h"

namespace psm {

/// What the first error was, if there was one.
struct ReadState {
  std::string file;
  std::optional<InputError> error;

  void fail(int line, const std::string& what);
};

/// A node and the path that leads to it.
class MemberReader {
 public:
  MemberReader(ReadState& state, const JsonTree& node, std::string path) : state_(state), node_(node), path_(std::move(path)) {}

  bool fine() const { return !state_.error; }
  int line() const { return node_.line; }
  ReadState& state() const { return state_; }
  const JsonTree& node() const { return node_; }
  /// "PATH: what", with the line.
  void fail(const std::string& what) const;

  /// The node is an object with these members only.
  bool has_only(const std::vector<std::string>& allowed) const;
  bool has(const std::string& name) const { return node_.find(name) != nullptr; }
  /// The member, or a null of the object's line. Fails where it is missing and `required`.
  MemberReader member(const std::string& name, bool required = false) const;
  std::vector<MemberReader> elements() const;  // of an array

  // The node itself as a value of this kind.
  double number(double lowest, double highest) const;
  bool boolean() const;
  std::string text() const;  // not empty
  std::string one_of(const std::vector<std::string>& allowed) const;
  Prose prose() const;
  ExperimentMembers experiment() const;

 private:
  bool expect(JsonTree::Kind kind, const char* what) const;

  ReadState& state_;
  const JsonTree& node_;
  std::string path_;
};

}  // namespace psm
