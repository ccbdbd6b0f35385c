// SPDX-License-Identifier: GPL-3.0-or-later
// The camera that most map cases share, and how far two maps are apart; private to viz/measure.
#pragma once

#include "measure/hard_case_rows.h"

namespace psm {

// Double follows extended within this many texels wherever w runs over less than four orders of magnitude.
constexpr double kDoubleTexels = 1e-9;
// Float keeps a map that moves with its light within this many texels; anything larger flickers.
constexpr double kFlicker = 0.1;

inline MapScene lit_by(const glm::dvec4& light) {
  MapScene s;
  s.light = light;
  return frustum_scene(s);
}

inline auto map_builder(const MapScene& s, MapTechnique technique) {
  return [s, technique](auto t) { return map_from_world<decltype(t)>(s, technique); };
}

/// By how many texels the map of `b` differs from that of `a`, on the receivers of `a`.
template <class T>
CaseAnswer jump(const MapScene& a, const MapScene& b, MapTechnique ta = MapTechnique::psm, MapTechnique tb = MapTechnique::psm) {
  const double d =
      texel_distance(map_points<T>(map_builder(a, ta), a, a.receivers), map_points<T>(map_builder(b, tb), b, a.receivers));
  return answer(d, d);
}

}  // namespace psm
