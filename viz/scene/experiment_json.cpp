// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments from and to JSON, driven by the table.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/experiment_file.h"
#include "scene/experiment_members.h"
#include "scene/field_reader.h"
#include "scene/json_check.h"
#include "scene/json_node.h"

namespace psm {
namespace {

using nlohmann::ordered_json;

std::string shown(const ordered_json& json) { return quotable(json.dump()); }

/// What FieldReader reads from.
struct JsonSource {
  const ordered_json& json;

  std::optional<double> number() const {
    if (json.is_number()) return json.get<double>();
    if (json == "inf") return HUGE_VAL;
    if (json == "-inf") return -HUGE_VAL;
    return std::nullopt;
  }
  std::optional<std::string> text() const { return json.is_string() ? std::optional(json.get<std::string>()) : std::nullopt; }
  std::optional<std::vector<std::string>> names() const {
    if (!json.is_array()) return std::nullopt;
    std::vector<std::string> list;
    for (const ordered_json& name : json) {
      if (!name.is_string()) return std::nullopt;
      list.push_back(name.get<std::string>());
    }
    return list;
  }
  template <int N>
  bool vector(glm::vec<N, double>& values) const {
    if (!json.is_array() || json.size() != N) return false;
    for (int i = 0; i < N; ++i) {
      if (!json[std::size_t(i)].is_number()) return false;
      values[i] = json[std::size_t(i)].get<double>();
    }
    return true;
  }
  bool is(const std::string& word) const { return word == "null" ? json.is_null() : json == word; }
};

bool is_object_of_members(const std::string& path) {
  const auto& fields = experiment_fields();
  return std::any_of(fields.begin(), fields.end(), [&](const Field& f) { return f.path.starts_with(path + "."); });
}

std::optional<InputError> read_members(const ordered_json& object, const std::string& prefix, ExperimentMembers& members);

std::optional<InputError> read_member(const std::string& path, const ordered_json& json, ExperimentMembers& members) {
  if (const Field* field = find_field(path)) {
    if (!read_into(*field, JsonSource{json}, members.values) || check_field(*field, members.values))
      return not_allowed(path, shown(json), allowed_values(*field));
    members.set.push_back(field);
    return std::nullopt;
  }
  if (!is_object_of_members(path)) return unknown_member(path);
  if (!json.is_object()) return not_allowed(path, shown(json), "an object with members");
  return read_members(json, path + ".", members);
}

std::optional<InputError> read_members(const ordered_json& object, const std::string& prefix, ExperimentMembers& members) {
  for (const auto& [name, json] : object.items()) {
    if (prefix.empty() && name == "psmlab") {
      if (json != 1) return not_allowed("psmlab", shown(json), "1, the version of the file that this program reads");
    } else if (name.find('.') != std::string::npos) {
      return unknown_member(prefix + name);  // "camera.near" is two members, one in the other
    } else if (auto error = read_member(prefix + name, json, members)) {
      return error;
    }
  }
  return std::nullopt;
}

struct MemberNode {
  const Field& field;
  Experiment& experiment;

  JsonNode absent() const { return field.absent == "null" ? JsonNode() : JsonNode(field.absent); }
  JsonNode operator()(const NumberRef& ref) const { return ref(experiment); }
  JsonNode operator()(const IntRef& ref) const { return JsonNode::integer(ref(experiment)); }
  JsonNode operator()(const Vec2Ref& ref) const { return ref(experiment); }
  JsonNode operator()(const Vec3Ref& ref) const { return ref(experiment); }
  JsonNode operator()(const TextRef& ref) const { return ref(experiment); }
  JsonNode operator()(const ShiftRef& ref) const {
    const CameraShift& shift = ref(experiment);
    const double* value = std::get_if<double>(&shift);
    return value ? JsonNode(*value) : JsonNode(name_of(std::get<ShiftRule>(shift)));
  }
  JsonNode operator()(const TilesRef& ref) const {
    JsonNode list = JsonNode::array();
    for (const ViewId id : ref(experiment)) list.push_back(name_of(id));
    return list;
  }
  JsonNode operator()(const AutoPixelRef& ref) const {
    const auto& value = ref(experiment);
    return value ? JsonNode(*value) : absent();
  }
  JsonNode operator()(const AutoPlaneRef& ref) const {
    const auto& value = ref(experiment);
    return value ? JsonNode(*value) : absent();
  }
  JsonNode operator()(const Choice&) const { return value_text(field, experiment); }
};

/// The node at a dotted path, with the objects on the way.
JsonNode& node_at(JsonNode& root, const std::string& path) {
  const std::size_t dot = path.find('.');
  JsonNode& child = root[path.substr(0, dot)];
  if (dot == std::string::npos) return child;
  child.make_object();
  return node_at(child, path.substr(dot + 1));
}

}  // namespace

Result<ExperimentMembers> members_from_json(const std::string& json_text) {
  if (const auto error = check_json(json_text)) return *error;
  const ordered_json json = ordered_json::parse(json_text);
  if (!json.is_object()) return InputError{"not an object; allowed: an experiment, { \"psmlab\": 1, ... }"};
  ExperimentMembers members;
  if (auto error = read_members(json, "", members)) return *error;
  return members;
}

JsonNode experiment_node(const Experiment& experiment) {
  Experiment copy = experiment;
  JsonNode root = JsonNode::object();
  root["psmlab"] = JsonNode::integer(1);
  for (const Field& field : experiment_fields())
    if (field.applies(experiment)) node_at(root, field.path) = std::visit(MemberNode{field, copy}, field.member);
  return root;
}

std::string experiment_to_json(const Experiment& experiment) { return experiment_node(experiment).to_text() + "\n"; }

}  // namespace psm
