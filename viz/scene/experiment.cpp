// SPDX-License-Identifier: GPL-3.0-or-later
// Members of an experiment as texts, and whether they are allowed.
#include "scene/experiment.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <locale>
#include <sstream>

#include "scene/experiment_members.h"
#include "scene/experiment_names.h"

namespace psm {
namespace {

constexpr double kShortest = 1e-100;  // of a direction or a plane's normal: its square is still a double

std::string range_text(const Field& field) {
  return std::string(field.open_min ? "(" : "[") + number_text(field.min) + ", " + number_text(field.max) +
         (field.open_max ? ")" : "]");
}

std::string allowed_vector(const Field& field, const char* count) {
  return std::string(count) + " numbers in " + range_text(field) + (field.nonzero ? ", not all of them (nearly) zero" : "");
}

struct AllowedValues {
  const Field& field;
  std::string operator()(const NumberRef&) const {
    return "a number in " + range_text(field) + (field.may_be_infinite ? ", or inf" : "");
  }
  std::string operator()(const IntRef&) const { return (field.odd ? "an odd" : "a whole") + (" number in " + range_text(field)); }
  std::string operator()(const Vec2Ref&) const { return allowed_vector(field, "two"); }
  std::string operator()(const Vec3Ref&) const { return allowed_vector(field, "three"); }
  std::string operator()(const TextRef&) const { return "a built-in scene's id, or a path to a .gltf or .glb file"; }
  std::string operator()(const ShiftRef&) const {
    std::string text;
    for (const char* rule : kShiftRules) text += std::string(rule) + ", ";
    return text + "or a number in " + range_text(field);
  }
  std::string operator()(const TilesRef&) const {
    std::string text = "one to four of: ";
    for (std::size_t i = 0; i < kViews.size(); ++i) text += (i > 0 ? std::string(", ") : "") + kViews[i];
    return text + "; none twice";
  }
  std::string operator()(const AutoPixelRef&) const { return field.absent + ", or two numbers in " + range_text(field); }
  std::string operator()(const AutoPlaneRef&) const {
    return field.absent + ", or four numbers a, b, c, d in " + range_text(field) + " with a, b, c not all (nearly) zero";
  }
  std::string operator()(const Choice& choice) const {
    std::string text = "one of: ";
    for (std::size_t i = 0; i < choice.names.size(); ++i) text += (i > 0 ? ", " : "") + choice.names[i];
    return text;
  }
};

/// The rows hand out references for writing; reading through them leaves the experiment as it is.
template <class Ref>
const auto& read(const Ref& ref, const Experiment& experiment) {
  return ref(const_cast<Experiment&>(experiment));
}

template <int N>
std::string list_text(const glm::vec<N, double>& v) {
  std::string text;
  for (int i = 0; i < N; ++i) text += (i > 0 ? "," : "") + number_text(v[i]);
  return text;
}

struct ValueText {
  const Field& field;
  const Experiment& experiment;
  std::string operator()(const NumberRef& ref) const { return number_text(read(ref, experiment)); }
  std::string operator()(const IntRef& ref) const { return std::to_string(read(ref, experiment)); }
  std::string operator()(const Vec2Ref& ref) const { return list_text<2>(read(ref, experiment)); }
  std::string operator()(const Vec3Ref& ref) const { return list_text<3>(read(ref, experiment)); }
  std::string operator()(const TextRef& ref) const { return read(ref, experiment); }
  std::string operator()(const ShiftRef& ref) const {
    const CameraShift& shift = read(ref, experiment);
    const double* value = std::get_if<double>(&shift);
    return value ? number_text(*value) : name_of(std::get<ShiftRule>(shift));
  }
  std::string operator()(const TilesRef& ref) const {
    std::string text;
    for (const ViewId id : read(ref, experiment)) text += (text.empty() ? "" : ",") + std::string(name_of(id));
    return text;
  }
  std::string operator()(const AutoPixelRef& ref) const {
    const auto& value = read(ref, experiment);
    return value ? list_text<2>(*value) : field.absent;
  }
  std::string operator()(const AutoPlaneRef& ref) const {
    const auto& value = read(ref, experiment);
    return value ? list_text<4>(*value) : field.absent;
  }
  std::string operator()(const Choice& choice) const {
    const int index = choice.get(experiment);
    return index >= 0 && index < int(choice.names.size()) ? choice.names[index] : std::to_string(index);
  }
};

struct InRange {
  const Field& field;
  const Experiment& experiment;

  bool number(double x) const {
    if (field.may_be_infinite && x == HUGE_VAL) return true;
    return (field.open_min ? x > field.min : x >= field.min) && (field.open_max ? x < field.max : x <= field.max);
  }
  template <int N>
  bool vector(const glm::vec<N, double>& v, int nonzero_components) const {
    double largest = 0.0;
    for (int i = 0; i < N; ++i) {
      if (!number(v[i])) return false;
      if (i < nonzero_components) largest = std::max(largest, std::abs(v[i]));
    }
    return !field.nonzero || largest >= kShortest;
  }
  bool operator()(const NumberRef& ref) const { return number(read(ref, experiment)); }
  bool operator()(const IntRef& ref) const {
    const int value = read(ref, experiment);
    return number(value) && !(field.odd && value % 2 == 0);
  }
  bool operator()(const Vec2Ref& ref) const { return vector<2>(read(ref, experiment), 2); }
  bool operator()(const Vec3Ref& ref) const { return vector<3>(read(ref, experiment), 3); }
  bool operator()(const TextRef& ref) const {
    const std::string& text = read(ref, experiment);
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    return !text.empty() && text.size() <= 4096 && std::none_of(text.begin(), text.end(), is_control);
  }
  bool operator()(const ShiftRef& ref) const {
    const CameraShift& shift = read(ref, experiment);
    const double* value = std::get_if<double>(&shift);
    return !value || number(*value);
  }
  bool operator()(const TilesRef& ref) const {
    const std::vector<ViewId>& tiles = read(ref, experiment);
    for (std::size_t i = 0; i < tiles.size(); ++i)
      if (std::count(tiles.begin(), tiles.end(), tiles[i]) > 1) return false;
    return !tiles.empty() && tiles.size() <= kMostTiles;
  }
  bool operator()(const AutoPixelRef& ref) const {
    const auto& value = read(ref, experiment);
    return !value || vector<2>(*value, 2);
  }
  bool operator()(const AutoPlaneRef& ref) const {
    const auto& value = read(ref, experiment);
    return !value || vector<4>(*value, 3);
  }
  bool operator()(const Choice& choice) const {
    const int index = choice.get(experiment);
    return index >= 0 && index < int(choice.names.size());
  }
};

/// Unit vector without overflow or underflow on the way.
glm::dvec3 direction(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return glm::normalize(v / largest);
}

std::optional<InputError> check_camera(const CameraSettings& camera) {
  if (!(camera.far > camera.near))
    return not_allowed("camera.far", number_text(camera.far),
                       "a number greater than camera.near (" + number_text(camera.near) + "), or inf");
  if (camera.position == camera.target)
    return not_allowed("camera.target", list_text<3>(camera.target), "a point other than camera.position");
  const glm::dvec3 sine = glm::cross(direction(camera.target - camera.position), direction(camera.up));
  if (!(glm::length(sine) > 1e-9))
    return not_allowed("camera.up", list_text<3>(camera.up),
                       "a direction that is not parallel to the view direction from camera.position to camera.target");
  return std::nullopt;
}

}  // namespace

std::string allowed_values(const Field& field) { return std::visit(AllowedValues{field}, field.member); }

std::string value_text(const Field& field, const Experiment& experiment) {
  return std::visit(ValueText{field, experiment}, field.member);
}

std::string number_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char text[40];
  for (int digits = 15; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

std::optional<double> number_from_text(const std::string& text) {
  if (text == "inf") return HUGE_VAL;
  if (text == "-inf") return -HUGE_VAL;
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos) return std::nullopt;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return value;
}

std::optional<InputError> check_field(const Field& field, const Experiment& experiment) {
  if (std::visit(InRange{field, experiment}, field.member)) return std::nullopt;
  return not_allowed(field.path, value_text(field, experiment), allowed_values(field));
}

std::optional<InputError> check_experiment(const Experiment& experiment) {
  for (const Field& field : experiment_fields())
    if (field.applies(experiment))
      if (auto error = check_field(field, experiment)) return error;
  if (auto error = check_camera(experiment.camera)) return error;
  const LightSettings& light = experiment.light;
  if (light.type == LightType::spot && light.position == light.target)
    return not_allowed("light.target", list_text<3>(light.target), "a point other than light.position");
  return std::nullopt;
}

bool shifts_camera(Technique technique) {
  return technique == Technique::psm || technique == Technique::psm_divided || technique == Technique::psm_recipe;
}

}  // namespace psm
