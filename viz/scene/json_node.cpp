// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/json_node.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace psm {
namespace {

/// Text that is not UTF-8 (a file's name, say) is shown with replacement characters.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string finite_text(double value) {
  std::string text = nlohmann::json(value).dump();  // shortest digits that read back as the same double
  // "1.0" reads as "1"; "-0.0" must stay, since "-0" is read as an integer, which has no sign of zero.
  if (text.size() > 2 && text.ends_with(".0") && text != "-0.0") text.resize(text.size() - 2);
  return text;
}

}  // namespace

JsonNode::JsonNode(double value) {
  if (std::isnan(value)) {
    was_nan_ = true;
  } else {
    scalar_ = std::isfinite(value) ? finite_text(value) : value > 0 ? "\"inf\"" : "\"-inf\"";
  }
}

JsonNode::JsonNode(const std::string& text) : scalar_(quoted(text)) {}

JsonNode JsonNode::integer(long long value) {
  JsonNode node;
  node.scalar_ = std::to_string(value);
  return node;
}

JsonNode JsonNode::boolean(bool value) {
  JsonNode node;
  node.scalar_ = value ? "true" : "false";
  return node;
}

JsonNode& JsonNode::operator[](const std::string& name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return items_[std::size_t(found - names_.begin())];
  names_.push_back(name);
  return items_.emplace_back();
}

std::string JsonNode::to_text() const {
  std::string out;
  write(out, "");
  return out;
}

bool JsonNode::only_scalars() const {
  return std::all_of(items_.begin(), items_.end(), [](const JsonNode& item) { return item.kind_ == Kind::scalar; });
}

void JsonNode::write(std::string& out, const std::string& indent) const {
  if (kind_ == Kind::scalar) {
    out += scalar_;
    return;
  }
  out += kind_ == Kind::array ? '[' : '{';
  write_items(out, indent);
  out += kind_ == Kind::array ? ']' : '}';
}

void JsonNode::write_items(std::string& out, const std::string& indent) const {
  const bool one_line = items_.empty() || (kind_ == Kind::array && only_scalars());
  const std::string inner = indent + "  ";
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (i > 0) out += one_line ? ", " : ",";
    if (!one_line) out += "\n" + inner;
    if (kind_ == Kind::object) out += quoted(names_[i]) + ": ";
    items_[i].write(out, inner);
  }
  if (!one_line) out += "\n" + indent;
}

void JsonNode::collect_nans(const std::string& path, std::vector<std::string>& paths) const {
  if (was_nan_) paths.push_back(path);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const std::string step = kind_ == Kind::array ? "[" + std::to_string(i) + "]" : (path.empty() ? "" : ".") + names_[i];
    items_[i].collect_nans(path + step, paths);
  }
}

std::vector<std::string> JsonNode::nan_paths() const {
  std::vector<std::string> paths;
  collect_nans("", paths);
  return paths;
}

}  // namespace psm
