// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a value that was read, from JSON or from text, into a member of an experiment. Private to experiment_*.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/experiment.h"

namespace psm {

/// Visits Field::member; false where the value is not of the member's kind, whose range is not looked at. Source has
///   number() -> optional<double>; text() -> optional<string>; names() -> optional<vector<string>>;
///   vector(glm::vec<N, double>&) -> bool; is(word) -> bool, whether it is this word for "no value".
template <typename Source>
struct FieldReader {
  const Field& field;
  const Source source;
  Experiment& experiment;

  bool operator()(const NumberRef& ref) const { return put(source.number(), ref); }
  bool operator()(const IntRef& ref) const {
    const auto number = source.number();
    if (!number || std::trunc(*number) != *number || std::abs(*number) > 1e9) return false;
    ref(experiment) = int(*number);
    return true;
  }
  bool operator()(const Vec2Ref& ref) const { return source.vector(ref(experiment)); }
  bool operator()(const Vec3Ref& ref) const { return source.vector(ref(experiment)); }
  bool operator()(const TextRef& ref) const { return put(source.text(), ref); }
  bool operator()(const ShiftRef& ref) const {
    const auto text = source.text();
    const auto rule = text ? shift_rule_from_name(*text) : std::nullopt;
    return rule ? put(rule, ref) : put(source.number(), ref);
  }
  bool operator()(const TilesRef& ref) const {
    const auto names = source.names();
    if (!names) return false;
    std::vector<ViewId> tiles;
    for (const std::string& name : *names) {
      const auto view = view_from_name(name);
      if (!view) return false;
      tiles.push_back(*view);
    }
    ref(experiment) = tiles;
    return true;
  }
  bool operator()(const AutoPixelRef& ref) const { return put_or_nothing(ref(experiment)); }
  bool operator()(const AutoPlaneRef& ref) const { return put_or_nothing(ref(experiment)); }
  bool operator()(const Choice& choice) const {
    const auto text = source.text();
    const auto found = text ? std::find(choice.names.begin(), choice.names.end(), *text) : choice.names.end();
    if (found == choice.names.end()) return false;
    choice.set(experiment, int(found - choice.names.begin()));
    return true;
  }

 private:
  template <typename T, typename Ref>
  bool put(const std::optional<T>& value, const Ref& ref) const {
    if (value) ref(experiment) = *value;
    return value.has_value();
  }
  template <int N>
  bool put_or_nothing(std::optional<glm::vec<N, double>>& member) const {
    glm::vec<N, double> value;
    const bool is_value = source.vector(value);
    if (!is_value && !source.is(field.absent)) return false;
    member = is_value ? std::optional(value) : std::nullopt;
    return true;
  }
};

template <typename Source>
bool read_into(const Field& field, const Source& source, Experiment& experiment) {
  return std::visit(FieldReader<Source>{field, source, experiment}, field.member);
}

}  // namespace psm
