// SPDX-License-Identifier: GPL-3.0-or-later
// Edits never lead out of what an experiment file may say.
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/model.h"

namespace psm {
namespace {

/// Moves one number into the row's range; the bounds themselves step aside where they are not allowed.
struct Clamp {
  const Field& field;
  Experiment& experiment;

  double low() const { return field.open_min ? std::nextafter(field.min, HUGE_VAL) : field.min; }
  double high() const { return field.open_max ? std::nextafter(field.max, -HUGE_VAL) : field.max; }
  void number(double& x) const {
    if (field.may_be_infinite && x == HUGE_VAL) return;
    if (std::isfinite(x)) x = std::clamp(x, low(), high());
  }
  template <class Vector>
  void vector(Vector& v) const {
    for (int i = 0; i < Vector::length(); ++i) number(v[i]);
  }
  void operator()(const NumberRef& ref) const { number(ref(experiment)); }
  void operator()(const IntRef& ref) const {
    int& x = ref(experiment);
    x = int(std::clamp(double(x), low(), high()));
    if (field.odd && x % 2 == 0) x += x < high() ? 1 : -1;
  }
  void operator()(const Vec2Ref& ref) const { vector(ref(experiment)); }
  void operator()(const Vec3Ref& ref) const { vector(ref(experiment)); }
  void operator()(const ShiftRef& ref) const {
    if (double* x = std::get_if<double>(&ref(experiment))) number(*x);
  }
  void operator()(const AutoPixelRef& ref) const {
    if (auto& x = ref(experiment)) vector(*x);
  }
  void operator()(const AutoPlaneRef& ref) const {
    if (auto& x = ref(experiment)) vector(*x);
  }
  void operator()(const TilesRef&) const {}
  void operator()(const TextRef&) const {}
  void operator()(const Choice&) const {}
};

struct Copy {
  Experiment& from;
  Experiment& to;
  template <class Ref>
  void operator()(const Ref& ref) const {
    ref(to) = ref(from);
  }
  void operator()(const Choice& choice) const { choice.set(to, choice.get(from)); }
};

/// The distance that was not edited gives way; where both were, far does.
void order_near_and_far(const CameraSettings& before, CameraSettings& camera) {
  constexpr double apart = 1.001;
  if (camera.far > camera.near) return;
  if (camera.far != before.far && camera.near == before.near)
    camera.far = std::max(camera.near * apart, camera.far);
  else
    camera.near = std::min(camera.near, camera.far / apart);
  if (!(camera.far > camera.near)) camera.near = before.near, camera.far = before.far;
}

}  // namespace

void clamp_field(const Field& field, Experiment& experiment) { std::visit(Clamp{field, experiment}, field.member); }

void copy_field(const Field& field, const Experiment& from, Experiment& to) {
  Experiment source = from;  // the table's references are for writing
  std::visit(Copy{source, to}, field.member);
}

Experiment made_valid(const Experiment& before, Experiment edited) {
  for (const Field& field : experiment_fields()) {
    clamp_field(field, edited);
    if (check_field(field, edited)) copy_field(field, before, edited);
  }
  order_near_and_far(before.camera, edited.camera);
  if (!check_experiment(edited)) return edited;
  // What is left ties points and directions together: those groups fall back as a whole.
  const CameraSettings camera = edited.camera;
  edited.camera.position = before.camera.position, edited.camera.target = before.camera.target;
  edited.camera.up = before.camera.up;
  if (!check_experiment(edited)) return edited;
  edited.camera = camera;
  edited.light = before.light;
  return check_experiment(edited) ? before : edited;
}

}  // namespace psm
