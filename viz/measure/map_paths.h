// SPDX-License-Identifier: GPL-3.0-or-later
// One shadow map in several arithmetics: double and exact all along, and the graphics processor's floats, in which only the
// positions and the finished matrices are narrowed.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "math/shadow_map.h"
#include "math/warp.h"
#include "measure/wide.h"

namespace psm {

using std::isnan;

/// A camera with a square image, a light and receivers, in doubles that every arithmetic takes as exact.
struct MapScene {
  glm::dvec3 eye{0, 1.7, 0}, forward{0, 0, -1}, up{0, 1, 0};
  double tan_phi = 0.57735026918962576, near = 1, far = 100;
  glm::dvec4 light{0.1, 1, -0.4, 0};
  std::vector<glm::dvec3> receivers;
};

/// The frustum's corners and 12 points within, as receivers.
inline MapScene frustum_scene(MapScene s = {}) {
  const glm::dmat4 view = look_along(s.eye, s.forward, s.up);
  const glm::dvec3 right(row(view, 0)), up(row(view, 1)), forward(-row(view, 2));
  const auto add = [&](double x, double y, double z) {
    s.receivers.push_back(s.eye + z * (forward + s.tan_phi * (x * right + y * up)));
  };
  for (const double z : {s.near, s.far})
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) add(x, y, z);
  for (int i = 0; i < 12; ++i) add(0.3 * (i % 3) - 0.35, 0.4 * (i % 4) - 0.7, s.near * std::pow(s.far / s.near, (i + 0.5) / 12));
  return s;
}

enum class MapTechnique { uniform, psm, gmnpr };

template <class T>
std::vector<Vec3<T>> points_in(const std::vector<glm::dvec3>& points) {
  return std::vector<Vec3<T>>(points.begin(), points.end());
}

template <class T>
Mat4<T> view_from_world(const MapScene& s) {
  return look_along(Vec3<T>(s.eye), Vec3<T>(s.forward), Vec3<T>(s.up));
}

template <class T>
Mat4<T> clip_from_world(const MapScene& s) {
  return perspective(T(s.tan_phi), T(s.tan_phi), T(s.near), T(s.far)) * view_from_world<T>(s);
}

template <class T>
Vec4<T> unit_light(const MapScene& s) {
  const Vec4<T> light(s.light);
  return light.w == T(0) ? Vec4<T>(safe_normalize(Vec3<T>(light)), 0) : light;
}

template <class T>
LightFrame<T> frame_of(const MapScene& s) {
  Vec3<T> centroid(0);
  for (const glm::dvec3& x : s.receivers) centroid += Vec3<T>(x) / T(s.receivers.size());
  return light_frame(unit_light<T>(s), centroid, safe_normalize(Vec3<T>(s.forward)), Vec3<T>(s.up));
}

template <class T>
Vec4<T> plane_of(const MapScene& s, MapTechnique technique) {
  const std::vector<Vec3<T>> receivers = points_in<T>(s.receivers);
  const Vec4<T> light = unit_light<T>(s);
  if (technique == MapTechnique::psm) return psm_plane<T>(clip_from_world<T>(s), light, receivers).plane;
  std::vector<Vec3<T>> d;
  for (const Vec3<T>& x : receivers) d.push_back(safe_normalize(x - Vec3<T>(light)));
  const Vec4<T> uniform = uniform_plane(light, smallest_enclosing_cone<T>(d).axis);
  if (technique == MapTechnique::uniform) return uniform;
  const Vec3<T> to_light = light.w == T(0) ? Vec3<T>(light) : safe_normalize(Vec3<T>(light) - Vec3<T>(s.eye));
  const auto strength = warp_strength(
      Warp::gmnpr, WarpModel<T>::from_vectors(T(s.near), T(s.far), T(s.tan_phi), safe_normalize(Vec3<T>(s.forward)), to_light));
  const Vec4<T> b = frame_of<T>(s).b;
  return warped_plane(uniform, b, ratio_range<T>(b, uniform, receivers), strength.rho, strength.one_minus_rho);
}

template <class T>
Mat4<T> map_from_world(const MapScene& s, MapTechnique technique) {
  const std::vector<Vec3<T>> receivers = points_in<T>(s.receivers);
  return fit_map<T>(frame_of<T>(s), plane_of<T>(s, technique), receivers, receivers).map_from_world;
}

// ---- what the graphics processor does with it -------------------------------------------------------------------------

/// Positions as uploaded: relative to the middle of their box, in units of its half diagonal.
struct LocalSpace {
  glm::dvec3 origin{0};
  double unit = 1;

  glm::vec3 narrowed(const glm::dvec3& x) const { return glm::vec3((x - origin) / unit); }
  glm::dmat4 world_from_local() const { return glm::scale(glm::translate(glm::dmat4(1), origin), glm::dvec3(unit)); }
};

inline LocalSpace local_space(const std::vector<glm::dvec3>& points) {
  glm::dvec3 lo = points.front(), hi = lo;
  for (const glm::dvec3& x : points) lo = glm::min(lo, x), hi = glm::max(hi, x);
  const double half = glm::length(hi - lo) / 2;
  return {lo + (hi - lo) / 2.0, half > 0 ? half : 1.0};
}

/// A projective matrix means the same at any size; its largest entry becomes 1, so that floats hold it.
inline glm::mat4 narrowed(const glm::dmat4& m) {
  double largest = 0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) largest = std::max(largest, std::abs(m[c][r]));
  return glm::mat4(m / largest);
}

enum class FloatPath {
  composed,            // one matrix from the uploaded positions to the map: what psmlab does
  through_view,        // two matrices for each vertex: to view space, and from there to the map
  through_clip,        // the same by way of clip space, as the 2002 paper draws its pipeline
  world,               // as composed, but positions stay in world space
  world_through_view,  // the two stages from positions in world space
  world_through_clip
};

/// Clip-space positions in the map, for positions in world space.
inline std::vector<glm::vec4> float_clip_points(const glm::dmat4& map, const MapScene& s, const std::vector<glm::dvec3>& points,
                                                FloatPath path) {
  const LocalSpace local = path >= FloatPath::world ? LocalSpace{} : local_space(points);
  const bool by_view = path == FloatPath::through_view || path == FloatPath::world_through_view;
  const bool by_clip = path == FloatPath::through_clip || path == FloatPath::world_through_clip;
  const bool two_stages = by_view || by_clip;
  const glm::dmat4 stage = by_view ? view_from_world<double>(s) : clip_from_world<double>(s);
  const glm::mat4 first(two_stages ? stage * local.world_from_local() : glm::dmat4(1));
  const glm::mat4 last = narrowed(two_stages ? map * glm::inverse(stage) : map * local.world_from_local());
  std::vector<glm::vec4> out;
  for (const glm::dvec3& x : points) {
    const glm::vec4 p(local.narrowed(x), 1);
    out.push_back(two_stages ? last * (first * p) : last * p);
  }
  return out;
}

/// (u, v, depth) in the map, each in [-1, 1], of a matrix that `build` makes in any arithmetic: build(T{}).
template <class T, class Build>
std::vector<Vec3<T>> map_points(const Build& build, const MapScene& s, const std::vector<glm::dvec3>& points,
                                FloatPath path = FloatPath::composed) {
  std::vector<Vec3<T>> out;
  if constexpr (std::is_same_v<T, float>) {
    for (const glm::vec4& q : float_clip_points(build(double{}), s, points, path)) out.push_back(glm::vec3(q) / q.w);
  } else {
    const Mat4<T> map = build(T{});
    for (const glm::dvec3& x : points) {
      const Vec4<T> q = map * Vec4<T>(Vec3<T>(x), 1);
      out.push_back(Vec3<T>(q) / q.w);
    }
  }
  return out;
}

constexpr double kTexelsPerUnit = 512;  // of a map of 1,024 texels: u and v run over [-1, 1]

/// Largest distance in texels; NaN where a coordinate is not a number. Rounded once at the end, where T or U is wide.
template <class T, class U>
double texel_distance(const std::vector<Vec3<T>>& a, const std::vector<Vec3<U>>& b) {
  using Number = std::conditional_t<!std::is_arithmetic_v<T>, T, std::conditional_t<!std::is_arithmetic_v<U>, U, double>>;
  Number largest(0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Number d = hypot(Number(a[i].x) - Number(b[i].x), Number(a[i].y) - Number(b[i].y));
    if (!(d <= largest)) largest = d;
    if (isnan(largest)) break;
  }
  return double(Number(kTexelsPerUnit) * largest);
}

}  // namespace psm
