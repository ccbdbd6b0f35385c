// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/json_tree.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/experiment.h"
#include "scene/experiment_members.h"
#include "scene/json_fault.h"

namespace psm {
namespace {

using nlohmann::json;

constexpr std::size_t kDeepest = 16, kMostMembers = 1000;

/// Reads the text and says how far the parser has come.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  const char** farthest;

  reference operator*() const { return *at; }
  CountingIterator& operator++() { return *farthest = ++at, *this; }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

/// Builds the tree from the parser's events.
class Builder : public nlohmann::json_sax<json> {
 public:
  Builder(const std::string& text, const char* const& farthest) : text_(text), counted_to_(text.data()), farthest_(farthest) {}

  JsonTree root;
  std::string error;  // with its line, once something was refused

  bool null() override { return add({}); }
  bool boolean(bool value) override {
    JsonTree node;
    return node.kind = JsonTree::Kind::boolean, node.boolean = value, add(std::move(node));
  }
  bool number_integer(number_integer_t value) override { return add_number(double(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add_number(double(value)); }
  bool number_float(number_float_t value, const string_t& written) override {
    return std::isfinite(value) ? add_number(value)
                                : refuse(written + " is beyond the range of numbers; allowed: finite numbers");
  }
  bool string(string_t& value) override {
    JsonTree node;
    return node.kind = JsonTree::Kind::text, node.text = std::move(value), add(std::move(node));
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonTree::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonTree::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    JsonTree& object = *open_.back();
    if (object.names.size() == kMostMembers) return refuse("more than 1000 members; allowed: up to 1000");
    if (object.find(name)) return refuse(quotable(name) + ": given twice; allowed: once");
    object.names.push_back(name);
    return true;
  }
  bool parse_error(std::size_t read, const std::string&, const nlohmann::detail::exception& said) override {
    return refuse("not JSON: " + json_fault(said.what(), text_, read));
  }

 private:
  /// The line of the last character read: the token's own, or the one that ends a number.
  int line() {
    const char* last = farthest_ > counted_to_ ? farthest_ - 1 : counted_to_;
    line_ += int(std::count(counted_to_, last, '\n'));
    counted_to_ = last;
    return line_;
  }
  bool refuse(const std::string& what) {
    if (error.empty()) error = std::to_string(line()) + ": " + what;
    return false;
  }
  JsonTree* put(JsonTree node) {
    node.line = line();
    if (open_.empty()) return root = std::move(node), &root;
    open_.back()->items.push_back(std::move(node));
    return &open_.back()->items.back();
  }
  bool add(JsonTree node) { return put(std::move(node)), true; }
  bool add_number(double value) {
    JsonTree node;
    return node.kind = JsonTree::Kind::number, node.number = value, add(std::move(node));
  }
  bool open(JsonTree::Kind kind) {
    if (open_.size() == kDeepest) return refuse("nested too deeply; allowed: 16 levels");
    JsonTree node;
    node.kind = kind;
    open_.push_back(put(std::move(node)));
    return true;
  }
  bool close() { return open_.pop_back(), true; }

  const std::string& text_;
  const char* counted_to_;
  int line_ = 1;  // there
  const char* const& farthest_;
  std::vector<JsonTree*> open_;  // a node's address holds while it is the last of its parent
};

std::string quoted(const std::string& text) { return json(text).dump(-1, ' ', false, json::error_handler_t::replace); }

}  // namespace

const JsonTree* JsonTree::find(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  const std::size_t index = std::size_t(found - names.begin());
  return index < items.size() ? &items[index] : nullptr;
}

const JsonTree* JsonTree::at(const std::string& path) const {
  const std::size_t dot = path.find('.');
  const std::string step = path.substr(0, dot);
  const JsonTree* child = nullptr;
  if (kind == Kind::array) {
    const bool is_index = !step.empty() && step.size() < 9 && step.find_first_not_of("0123456789") == std::string::npos;
    if (is_index && std::stoul(step) < items.size()) child = &items[std::stoul(step)];
  } else {
    child = find(step);
  }
  return !child || dot == std::string::npos ? child : child->at(path.substr(dot + 1));
}

std::string JsonTree::to_text() const {
  switch (kind) {
    case Kind::null:
      return "null";
    case Kind::boolean:
      return boolean ? "true" : "false";
    case Kind::number:
      return number_text(number);
    case Kind::text:
      return quoted(text);
    case Kind::array:
    case Kind::object:
      break;
  }
  std::string out;
  for (std::size_t i = 0; i < items.size(); ++i)
    out += (i > 0 ? ", " : "") + (kind == Kind::object ? quoted(names[i]) + ": " : "") + items[i].to_text();
  return kind == Kind::object ? "{" + out + "}" : "[" + out + "]";
}

Result<JsonTree> parse_json(const std::string& text) {
  const char* farthest = text.data();
  Builder builder(text, farthest);
  const CountingIterator begin{text.data(), &farthest}, end{text.data() + text.size(), &farthest};
  if (!json::sax_parse(begin, end, &builder))
    return InputError{builder.error.empty() ? "1: not JSON; allowed: JSON" : builder.error};
  return std::move(builder.root);
}

}  // namespace psm
