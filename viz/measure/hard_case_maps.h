// SPDX-License-Identifier: GPL-3.0-or-later
// The camera that most map cases share, and how far two maps are apart; private to viz/measure.
#pragma once

#include "measure/hard_case_rows.h"

namespace psm {

// Double follows the exact map within this many texels wherever w runs over less than four orders of magnitude.
constexpr double kDoubleTexels = 1e-9;
// Float keeps a map that moves with its light within this many texels; anything larger flickers.
constexpr double kFlicker = 0.1;

inline MapScene lit_by(const glm::dvec4& light) {
  MapScene s;
  s.light = light;
  return frustum_scene(s);
}

/// v.(x - e): how far x lies in front of the eye. Without a root, so that rationals can have it; T: any number.
template <class T>
T depth_of(const glm::dvec3& x, const MapScene& s) {
  T depth(0);
  for (int i = 0; i < 3; ++i) depth = depth + T(s.forward[i]) * (T(x[i]) - T(s.eye[i]));
  return depth;
}

inline auto map_builder(const MapScene& s, MapTechnique technique) {
  return [s, technique](auto t) { return map_from_world<decltype(t)>(s, technique); };
}

/// By how many texels the map of `b` differs from that of `a`, on the receivers of `a`.
template <class T>
CaseAnswer jump(const MapScene& a, const MapScene& b, FloatPath path, MapTechnique tb = MapTechnique::psm) {
  const double d = texel_distance(map_points<T>(map_builder(a, MapTechnique::psm), a, a.receivers, path),
                                  map_points<T>(map_builder(b, tb), b, a.receivers, path));
  return answer(d, d);
}

}  // namespace psm
