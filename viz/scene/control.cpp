// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/control.h"

#include <algorithm>
#include <cmath>

#include "scene/experiment_file.h"
#include "scene/experiment_members.h"
#include "scene/light_angles.h"

namespace psm {
namespace {

using Assign = std::function<void(Experiment&, double)>;

/// The last part of a path as a component's number; nothing where it is none.
std::optional<int> component_of(const std::string& name) {
  const std::string letters = "xyz", digits = "012";
  if (name.size() != 1) return std::nullopt;
  const std::size_t letter = letters.find(name), digit = digits.find(name);
  if (letter != std::string::npos) return int(letter);
  return digit != std::string::npos ? std::optional(int(digit)) : std::nullopt;
}

/// How to set a whole member, or the component of a vector; nothing where that is no number.
struct AssignNumber {
  std::optional<int> component;

  std::optional<Assign> operator()(const NumberRef& ref) const {
    return whole([ref](Experiment& e, double value) { ref(e) = value; });
  }
  std::optional<Assign> operator()(const IntRef& ref) const {
    return whole([ref](Experiment& e, double value) { ref(e) = int(std::lround(std::clamp(value, -1e9, 1e9))); });
  }
  std::optional<Assign> operator()(const ShiftRef& ref) const {
    return whole([ref](Experiment& e, double value) { ref(e) = value; });
  }
  std::optional<Assign> operator()(const Vec2Ref& ref) const { return of_vector(ref, 2); }
  std::optional<Assign> operator()(const Vec3Ref& ref) const { return of_vector(ref, 3); }
  template <class Other>
  std::optional<Assign> operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  std::optional<Assign> whole(Assign assign) const { return component ? std::nullopt : std::optional(std::move(assign)); }
  template <class Ref>
  std::optional<Assign> of_vector(const Ref& ref, int size) const {
    if (!component || *component >= size) return std::nullopt;
    return [ref, i = *component](Experiment& e, double value) { ref(e)[i] = value; };
  }
};

Control checked(const std::string& path, const Assign& assign) {
  return [path, assign](Experiment& experiment, double value) -> std::optional<InputError> {
    if (!std::isfinite(value)) return not_allowed(path, number_text(value), "a finite number");
    Experiment changed = experiment;
    assign(changed, value);
    if (auto error = check_experiment(changed)) return error;
    experiment = std::move(changed);
    return std::nullopt;
  };
}

}  // namespace

Result<Control> find_control(const std::string& path, const Experiment& start) {
  if (path == "light.theta_deg") {
    if (start.light.type != LightType::directional)
      return InputError{path + ": the light is " + name_of(start.light.type) + "; allowed: with light.type directional"};
    const glm::dvec3 side = theta_side(start);
    return checked(path,
                   [side](Experiment& e, double degrees) { e.light.to_light = to_light_at(e, glm::radians(degrees), side); });
  }
  const std::size_t dot = path.rfind('.');
  const std::optional<int> component = dot == std::string::npos ? std::nullopt : component_of(path.substr(dot + 1));
  const Field* field = find_field(component ? path.substr(0, dot) : path);
  if (!field) return unknown_member(path);
  if (!field->applies(start)) return InputError{path + ": has no meaning for this experiment; allowed: a member that has"};
  const auto assign = std::visit(AssignNumber{component}, field->member);
  if (!assign)
    return InputError{quotable(path) +
                      ": not one number; allowed: a member that is a number, a vector's component such as light.position.x, or "
                      "light.theta_deg"};
  return checked(path, *assign);
}

}  // namespace psm
