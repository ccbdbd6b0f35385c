// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/control.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/experiment_file.h"
#include "scene/experiment_members.h"
#include "scene/light_angles.h"

namespace psm {
namespace {

/// The last part of a path as a component's number; nothing where it is none.
std::optional<int> component_of(const std::string& name) {
  const std::string letters = "xyz", digits = "012";
  if (name.size() != 1) return std::nullopt;
  const std::size_t letter = letters.find(name), digit = digits.find(name);
  if (letter != std::string::npos) return int(letter);
  return digit != std::string::npos ? std::optional(int(digit)) : std::nullopt;
}

/// A whole member, or the component of a vector; nothing where that is no number.
struct NumberOf {
  const std::string& path;
  std::optional<int> component;

  std::optional<Control> operator()(const NumberRef& ref) const {
    return whole(ref, [ref](Experiment& e, double value) { ref(e) = value; });
  }
  std::optional<Control> operator()(const IntRef& ref) const {
    return whole(ref, [ref](Experiment& e, double value) { ref(e) = int(std::lround(std::clamp(value, -1e9, 1e9))); });
  }
  std::optional<Control> operator()(const ShiftRef& ref) const {
    const auto read = [ref](Experiment& e) {
      const double* number = std::get_if<double>(&ref(e));
      return number ? *number : std::numeric_limits<double>::quiet_NaN();
    };
    return whole(read, [ref](Experiment& e, double value) { ref(e) = value; });
  }
  std::optional<Control> operator()(const Vec2Ref& ref) const { return of_vector(ref, 2); }
  std::optional<Control> operator()(const Vec3Ref& ref) const { return of_vector(ref, 3); }
  template <class Other>
  std::optional<Control> operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  std::optional<Control> whole(Control::Read read, Control::Assign assign) const {
    return component ? std::nullopt : std::optional(Control(path, std::move(read), std::move(assign)));
  }
  template <class Ref>
  std::optional<Control> of_vector(const Ref& ref, int size) const {
    if (!component || *component >= size) return std::nullopt;
    const int i = *component;
    return Control(
        path, [ref, i](Experiment& e) { return ref(e)[i]; }, [ref, i](Experiment& e, double value) { ref(e)[i] = value; });
  }
};

/// A number of the table, and the row that it is in.
struct TableNumber {
  const Field* field;
  Control control;
};

Result<TableNumber> table_number(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  const std::optional<int> component = dot == std::string::npos ? std::nullopt : component_of(path.substr(dot + 1));
  const Field* field = find_field(component ? path.substr(0, dot) : path);
  if (!field) return unknown_member(path);
  auto control = std::visit(NumberOf{path, component}, field->member);
  if (!control)
    return InputError{quotable(path) +
                      ": not one number; allowed: a member that is a number, a vector's component such as light.position.x, or "
                      "light.theta_deg"};
  return TableNumber{field, std::move(*control)};
}

}  // namespace

std::optional<InputError> Control::operator()(Experiment& experiment, double value) const {
  if (!std::isfinite(value)) return not_allowed(path_, number_text(value), "a finite number");
  Experiment changed = experiment;
  assign_(changed, value);
  if (auto error = check_experiment(changed)) return error;
  experiment = std::move(changed);
  return std::nullopt;
}

Result<Control> find_control(const std::string& path, const Experiment& start) {
  if (path == kThetaControl) {
    if (start.light.type != LightType::directional)
      return InputError{path + ": the light is " + name_of(start.light.type) + "; allowed: with light.type directional"};
    return Control(
        path, [](Experiment& e) { return glm::degrees(light_theta(e)); },
        [side = theta_side(start)](Experiment& e, double degrees) {
          e.light.to_light = to_light_at(e, glm::radians(degrees), side);
        });
  }
  auto number = table_number(path);
  if (!number) return number.error();
  if (!number->field->applies(start))
    return InputError{path + ": has no meaning for this experiment; allowed: a member that has"};
  return std::move(number->control);
}

Result<ControlRange> control_range(const std::string& path) {
  if (path == kThetaControl) return ControlRange{0.0, 180.0};
  const auto number = table_number(path);
  if (!number) return number.error();
  return ControlRange{number->field->min, number->field->max};
}

}  // namespace psm
