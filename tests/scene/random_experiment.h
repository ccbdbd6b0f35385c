// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments drawn from the ranges of the table, so that a new row is covered as soon as it exists.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "scene/experiment.h"

namespace psm::testing {

class RandomExperiment {
 public:
  explicit RandomExperiment(unsigned seed) : random_(seed) {}

  /// Every member random and within its range; the scene is the default one. Passes check_experiment.
  Experiment operator()() {
    Experiment experiment;
    do {
      for (const Field& field : experiment_fields()) std::visit(Draw{*this, field, experiment}, field.member);
    } while (check_experiment(experiment));
    return experiment;
  }

  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

 private:
  struct Draw {
    RandomExperiment& source;
    const Field& field;
    Experiment& experiment;
    void operator()(const NumberRef& ref) const {
      ref(experiment) = field.may_be_infinite && source.below(3) == 0 ? HUGE_VAL : source.number(field);
    }
    void operator()(const IntRef& ref) const {
      int& value = ref(experiment);
      do value = std::uniform_int_distribution<int>(int(field.min), int(field.max))(source.random_);
      while (field.odd && value % 2 == 0);
    }
    void operator()(const Vec2Ref& ref) const { source.vector<2>(field, ref(experiment)); }
    void operator()(const Vec3Ref& ref) const { source.vector<3>(field, ref(experiment)); }
    void operator()(const TextRef&) const {}
    void operator()(const ShiftRef& ref) const {
      ref(experiment) = source.below(2) == 0 ? CameraShift(ShiftRule(source.below(3))) : source.number(field);
    }
    void operator()(const TilesRef& ref) const {
      std::vector<ViewId> views(kAllViews.begin(), kAllViews.end());
      std::shuffle(views.begin(), views.end(), source.random_);
      views.resize(std::size_t(1 + source.below(int(kMostTiles))));
      ref(experiment) = views;
    }
    void operator()(const AutoPixelRef& ref) const {
      glm::dvec2 pixel;
      source.vector<2>(field, pixel);
      ref(experiment) = source.below(2) == 0 ? std::nullopt : std::optional<glm::dvec2>(pixel);
    }
    void operator()(const AutoPlaneRef& ref) const {
      glm::dvec4 plane;
      source.vector<4>(field, plane);
      ref(experiment) = source.below(2) == 0 ? std::nullopt : std::optional<glm::dvec4>(plane);
    }
    void operator()(const Choice& choice) const { choice.set(experiment, source.below(int(choice.names.size()))); }
  };

  /// Magnitudes of every order, the bounds themselves, and both zeros.
  double number(const Field& field) {
    const int kind = below(10);
    if (kind == 0 && !field.open_min) return field.min;
    if (kind == 1 && !field.open_max) return field.max;
    if (kind == 2 && field.min < 0) return -0.0;
    const double magnitude = std::ldexp(std::uniform_real_distribution<double>(0.5, 1.0)(random_), below(80) - 40);
    const double value = field.min < 0 && below(2) == 0 ? -magnitude : magnitude;
    const double inside = std::uniform_real_distribution<double>(0.01, 0.99)(random_);
    return value > field.min && value < field.max ? value : field.min + inside * (field.max - field.min);
  }
  template <int N>
  void vector(const Field& field, glm::vec<N, double>& v) {
    for (int i = 0; i < N; ++i) v[i] = number(field);
    if (field.nonzero) v[below(std::min(N, 3))] = 1.0;
  }

  std::mt19937 random_;
};

}  // namespace psm::testing
