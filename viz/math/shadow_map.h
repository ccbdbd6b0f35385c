// SPDX-License-Identifier: GPL-3.0-or-later
// A shadow mapping is a matrix M with rows (a, b, e, c), world to map clip space, that obeys M l = (0, 0, -k, 0), k > 0, for the
// homogeneous light l. A technique chooses one plane through the light, c = 0; the axes, the window and the depth range are
// shared.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "math/enclosing_cone.h"
#include "math/projective.h"

namespace psm {

/// The light, and rows that hold for every technique: a and b pass through the light and through the receivers' centroid, b runs
/// along the projected view direction; e grows away from the light.
template <class T>
struct LightFrame {
  Vec4<T> light;  // unit direction to the light and 0, or position and 1
  Vec4<T> a, b, e;
};

template <class T>
LightFrame<T> light_frame(const Vec4<T>& light, const Vec3<T>& centroid, const Vec3<T>& view_forward, const Vec3<T>& view_up) {
  const bool directional = light.w == T(0);
  const Vec3<T> l = Vec3<T>(light);
  const Vec3<T> to_light = directional ? l : safe_normalize(l - centroid);
  const Vec3<T> origin = directional ? centroid : l;
  // A view along the light has no projected direction; the view's up vector takes over.
  Vec3<T> along = view_forward - to_light * glm::dot(view_forward, to_light);
  if (glm::length(along) <= T(8) * epsilon<T>()) along = view_up - to_light * glm::dot(view_up, to_light);
  along = glm::length(along) > T(8) * epsilon<T>() ? glm::normalize(along) : perpendicular(to_light);
  const Vec3<T> across = glm::normalize(glm::cross(along, to_light));
  const auto through = [&](const Vec3<T>& n) { return Vec4<T>(n, -glm::dot(n, origin)); };
  const Vec4<T> e = directional ? Vec4<T>(-l, glm::dot(l, centroid)) : Vec4<T>(0, 0, 0, -1);
  return {light, through(across), through(along), e};
}

/// The uniform map's plane: at infinity for a direction, else through the light across `axis`.
template <class T>
Vec4<T> uniform_plane(const Vec4<T>& light, const Vec3<T>& axis) {
  if (light.w == T(0)) return {0, 0, 0, 1};
  return Vec4<T>(axis, -glm::dot(axis, Vec3<T>(light)));
}

template <class T>
struct Range {
  T min = std::numeric_limits<T>::infinity(), max = -std::numeric_limits<T>::infinity();
  void add(T x) { min = std::min(min, x), max = std::max(max, x); }
  T size() const { return max - min; }
};

/// Range of p.x / q.x over points with q.x > 0.
template <class T>
Range<T> ratio_range(const Vec4<T>& p, const Vec4<T>& q, std::span<const Vec3<T>> points) {
  Range<T> r;
  for (const Vec3<T>& x : points) r.add(glm::dot(p, Vec4<T>(x, 1)) / glm::dot(q, Vec4<T>(x, 1)));
  return r;
}

template <class T>
Range<T> value_range(const Vec4<T>& p, std::span<const Vec3<T>> points) {
  Range<T> r;
  for (const Vec3<T>& x : points) r.add(glm::dot(p, Vec4<T>(x, 1)));
  return r;
}

/// The warp t = t_min - lambda W in the light's own (perspective) space, t = b / uniform: c = (rho + (1 - rho) tau) uniform with
/// tau = (t - t_min) / W. rho = 1 is the uniform plane, exactly.
template <class T>
Vec4<T> warped_plane(const Vec4<T>& uniform, const Vec4<T>& b, Range<T> t, T rho, T one_minus_rho) {
  if (one_minus_rho == T(0) || !(t.size() > T(0))) return uniform;
  const T W = t.size();
  return rho * uniform + one_minus_rho * ((b - t.min * uniform) / W);
}

/// PSM's plane (PSM 2002, section 3; web page, "Recipe"), without its cases. In clip space q the light is L = (k r, kappa r), r =
/// |L.xyz|, and looking at the cube's centre gives c = q.w - kappa (k.q.xyz): kappa = 0 is exactly orthographic. Where that fails
/// on the receivers (cosine to one of them below half the best possible), the aim turns towards the axis of the smallest cone
/// around them, by the least amount that does not.
template <class T>
struct PsmPlane {
  Vec4<T> plane{0};  // in world space
  T kappa = T(0);
  T turned = T(0);    // radians
  bool valid = true;  // false: the light touches the receivers after the projection
};

template <class T>
PsmPlane<T> psm_plane(const Mat4<T>& clip_from_world, const Vec4<T>& light, std::span<const Vec3<T>> receivers) {
  const Vec4<T> L = clip_from_world * light;
  const T r = glm::length(Vec3<T>(L));
  PsmPlane<T> out;
  const T scale = r > T(0) ? r : abs(L.w);
  const Vec3<T> k = r > T(0) ? Vec3<T>(L) / r : Vec3<T>(0);
  out.kappa = L.w / scale;
  const T size = abs(out.kappa), sign = L.w < T(0) ? T(-1) : T(1);
  const T reach = r / scale;  // 1, or 0 for a light at the cube's centre

  // Directions from the light, times |kappa|: finite for every kappa.
  std::vector<Vec3<T>> d;
  d.reserve(receivers.size());
  for (const Vec3<T>& x : receivers) {
    const Vec4<T> q = clip_from_world * Vec4<T>(x, 1);
    d.push_back(safe_normalize(size * (Vec3<T>(q) / q.w) - sign * reach * k));
  }
  const Vec3<T> centre = reach > T(0) ? -sign * k : Vec3<T>(0);
  const auto smallest_cosine = [&](const Vec3<T>& g) {
    T m = T(1);
    for (const Vec3<T>& x : d) m = std::min(m, glm::dot(g, x));
    return m;
  };
  Vec3<T> g = centre;
  const T at_centre = reach > T(0) ? smallest_cosine(centre) : T(-1);
  if (at_centre < T(0.5)) {  // the best possible is at most 1
    const Cone<T> cone = smallest_enclosing_cone<T>(d);
    out.valid = cone.cosine > T(0);
    if (at_centre < cone.cosine / T(2)) {
      // Along the arc from the centre to the axis every g.d_i is a sinusoid; bisect for the least turn.
      const T angle = reach > T(0) ? atan2(glm::length(glm::cross(centre, cone.axis)), glm::dot(centre, cone.axis)) : T(0);
      Vec3<T> side = cone.axis - centre * glm::dot(centre, cone.axis);
      side = glm::length(side) > T(0) ? safe_normalize(side) : perpendicular(cone.axis);
      const auto turned = [&](T t) { return centre * cos(t) + side * sin(t); };
      T lo = T(0), hi = angle;
      constexpr int kHalvings = std::numeric_limits<T>::digits + 7;  // until the angle cannot be halved any more
      for (int i = 0; i < kHalvings && reach > T(0); ++i) {
        const T mid = (lo + hi) / T(2);
        (smallest_cosine(turned(mid)) >= cone.cosine / T(2) ? hi : lo) = mid;
      }
      out.turned = hi;
      g = hi == angle ? cone.axis : turned(hi);
    }
  }
  const Vec4<T> c_clip = g == centre ? Vec4<T>(-out.kappa * k, reach) : Vec4<T>(size * g, -sign * reach * glm::dot(g, k));
  out.plane = c_clip * clip_from_world;
  return out;
}

/// What the fit had to do besides fitting.
template <class T>
struct MapFit {
  Mat4<T> map_from_world{1};
  bool padded_window = false, padded_depth = false;
  bool near_distance_used = false;  // the light is a vertex of the casters' body: depth starts at c = near_c
  T near_c = T(0);
};

/// Window (off-centre) around the receivers, depth range around the casters: x' = s a + t c, z' = s e + t c. `plane` must be
/// positive on the receivers. A light among the casters (`light_inside`) is a vertex of theirs, where c = 0: depth then starts at
/// c = near_c, a thousandth of the receivers' largest. A light outside holds all casters, unless it comes so close that a depth
/// buffer of 24 bits would have nothing left for the receivers: near_c is then a millionth. It is never more than half the
/// receivers' smallest c.
template <class T>
MapFit<T> fit_map(const LightFrame<T>& frame, Vec4<T> plane, std::span<const Vec3<T>> receivers, std::span<const Vec3<T>> casters,
                  bool light_inside = false) {
  MapFit<T> fit;
  plane /= value_range(plane, receivers).max;
  const Range<T> c_receivers = value_range(plane, receivers);
  fit.near_c = std::min(light_inside ? T(1e-3) : T(1e-6), c_receivers.min / T(2));

  Range<T> depth = ratio_range(frame.e, plane, receivers);
  for (const Vec3<T>& x : casters) {
    const T c = glm::dot(plane, Vec4<T>(x, 1));
    const bool at_light = frame.light.w != T(0) && c < fit.near_c;
    fit.near_distance_used |= at_light;
    depth.add(at_light ? T(-1) / fit.near_c : glm::dot(frame.e, Vec4<T>(x, 1)) / c);
  }
  const auto fitted_row = [&](const Vec4<T>& p, Range<T> r, bool& padded) {
    const T magnitude = std::max(abs(r.min), abs(r.max));
    const T least = std::max(T(64) * epsilon<T>() * magnitude, std::numeric_limits<T>::min());
    if (!(r.size() > least)) {  // a body without extent in this direction still gets a window
      padded = true;
      const T half = magnitude > T(0) ? magnitude * T(1e-3) : T(1);
      r = {r.min - half, r.max + half};
    }
    return (T(2) * p - (r.min + r.max) * plane) / r.size();
  };
  const Vec4<T> x = fitted_row(frame.a, ratio_range(frame.a, plane, receivers), fit.padded_window);
  const Vec4<T> y = fitted_row(frame.b, ratio_range(frame.b, plane, receivers), fit.padded_window);
  const Vec4<T> z = fitted_row(frame.e, depth, fit.padded_depth);
  fit.map_from_world = from_rows(x, y, z, plane);
  return fit;
}

/// Six maps of 90 degrees around a position light, +x -x +y -y +z -z, from `near` to `far`.
template <class T>
std::vector<Mat4<T>> cube_maps(const Vec3<T>& light, T near, T far) {
  std::vector<Mat4<T>> maps;
  for (int face = 0; face < 6; ++face) {
    Vec3<T> forward(0), up(0);
    forward[face / 2] = face % 2 == 0 ? T(1) : T(-1);
    up[face / 2 == 1 ? 2 : 1] = T(1);
    maps.push_back(perspective(T(1), T(1), near, far) * look_along(light, forward, up));
  }
  return maps;
}

}  // namespace psm
