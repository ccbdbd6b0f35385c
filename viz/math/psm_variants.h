// SPDX-License-Identifier: GPL-3.0-or-later
// What the 2002 paper and its web page do where psmlab has one rule: the virtual camera shift, the light divided by its w with
// the depth test reversed, the second map beyond the infinity plane, and the recipe that looks at the cube's centre. They are
// here to be compared with.
#pragma once

#include <optional>

#include "math/shadow_map.h"

namespace psm {

/// Least distance by which the eye must move back (PSM 2002, section 4.2) so that every vertex of H has depth at least `near`.
template <class T>
T shift_in_front(std::span<const T> depths, T near) {
  T shift = T(0);
  for (const T d : depths) shift = std::max(shift, near - d);
  return shift;
}

/// The same so that every vertex lies inside the shifted frustum; (x, y, depth) per vertex in view space, depth positive in
/// front.
template <class T>
T shift_inside(std::span<const Vec3<T>> vertices, T near, T tan_phi_x, T tan_phi_y) {
  T shift = T(0);
  for (const Vec3<T>& v : vertices) shift = std::max({shift, near - v.z, abs(v.x) / tan_phi_x - v.z, abs(v.y) / tan_phi_y - v.z});
  return shift;
}

/// A mapping that breaks the rule M l = (0, 0, -k, 0), k > 0.
template <class T>
struct VariantMap {
  Mat4<T> map_from_world{1};
  bool reversed_depth = false;  // the farthest hit survives: the light is inverted
  bool degenerate_up = false;   // recipe: up = (0, 0, 1) lies along the view from the light
  bool behind_light = false;    // recipe: part of the cube is behind the light's camera, and its w is not positive
  T smallest_w = T(0);          // over the cube's corners, relative to the largest
};

/// The row z with z/c = -1 and 1 at the ends of this range of -w/c, the depth of the cube's space seen from the light: linear
/// along every ray, 0 on the infinity plane, negative in front of the eye and positive behind it.
template <class T>
Vec4<T> cube_depth_row(const Vec4<T>& w, const Vec4<T>& c, const Range<T>& depth) {
  return (T(-2) * w - (depth.min + depth.max) * c) / depth.size();
}

/// Divided PSM (PSM 2002, section 3.1): the light as the point L.xyz / L.w of the cube's space, depth growing away from that
/// point; where L.w < 0 the light is inverted, so that depth falls along the true rays. `plane` is the one-rule plane (the two
/// agree), `depths` the points whose depth the map must hold; those behind the eye, and those
/// nearer to the light than the fit's near distance, are lost.
template <class T>
VariantMap<T> divided_map(const LightFrame<T>& frame, const Vec4<T>& plane, const Mat4<T>& clip_from_world,
                          std::span<const Vec3<T>> receivers, std::span<const Vec3<T>> depths) {
  VariantMap<T> out;
  const Vec4<T> L = clip_from_world * frame.light;
  const MapFit<T> one_rule = fit_map(frame, plane, receivers, receivers, true);
  out.map_from_world = one_rule.map_from_world;
  out.reversed_depth = L.w < T(0);
  const Vec4<T> c = row(one_rule.map_from_world, 3), w = row(clip_from_world, 3);
  if (L.w == T(0)) {  // directional in the cube's space: the one rule is the paper's rule
    out.map_from_world = fit_map(frame, plane, receivers, depths).map_from_world;
    return out;
  }
  std::vector<Vec3<T>> in_front;
  for (const Vec3<T>& x : depths)
    if (glm::dot(w, Vec4<T>(x, 1)) > T(0) && glm::dot(c, Vec4<T>(x, 1)) > one_rule.near_c) in_front.push_back(x);
  Range<T> depth = ratio_range<T>(-w, c, receivers);
  for (const Vec3<T>& x : in_front) depth.add(-glm::dot(w, Vec4<T>(x, 1)) / glm::dot(c, Vec4<T>(x, 1)));
  if (!(depth.size() > T(0))) depth = {depth.min - T(1), depth.max + T(1)};
  const Vec4<T> z = cube_depth_row(w, c, depth);
  out.map_from_world = from_rows(row(one_rule.map_from_world, 0), row(one_rule.map_from_world, 1), z, c);
  return out;
}

/// The other solution of PSM 2002, section 4.2: no camera shift, but two maps that share u and v and meet in the infinity plane.
/// `front` is the divided map, up to that plane. `beyond` looks from the light to the other side, at what stands behind the eye.
/// That happens for an inverted light only, and then all of it lies between the light and the plane: a receiver, always in front,
/// is lit if both maps say so, and of `beyond` it asks no more than whether anything is there.
template <class T>
struct TwoMaps {
  VariantMap<T> front;
  std::optional<Mat4<T>> beyond;  // keeps the rule M l = (0, 0, -k, 0), k > 0; none where no point of `depths` is behind the eye
};

template <class T>
TwoMaps<T> two_maps(const LightFrame<T>& frame, const Vec4<T>& plane, const Mat4<T>& clip_from_world,
                    std::span<const Vec3<T>> receivers, std::span<const Vec3<T>> depths) {
  TwoMaps<T> out{divided_map(frame, plane, clip_from_world, receivers, depths), {}};
  const Mat4<T> front = out.front.map_from_world;
  const Vec4<T> c = row(front, 3), w = row(clip_from_world, 3);
  const Range<T> w_range = value_range(w, depths);
  if (!out.front.reversed_depth || !(w_range.min < T(0))) return out;
  // The light itself is a vertex of the casters' body, where c = 0: as in fit_map, depth begins at a near distance from it.
  const T near_c = fit_map(frame, plane, receivers, receivers, true).near_c;
  T farthest = T(0);
  for (const Vec3<T>& x : depths)
    farthest = std::max(farthest, -glm::dot(w, Vec4<T>(x, 1)) / std::max(glm::dot(c, Vec4<T>(x, 1)), near_c));
  const Range<T> in_front{ratio_range<T>(-w, c, receivers).min, T(0)}, behind{T(0), farthest};
  out.front.map_from_world = from_rows(row(front, 0), row(front, 1), cube_depth_row(w, c, in_front), c);
  out.beyond = from_rows(row(front, 0), row(front, 1), -cube_depth_row(w, c, behind), c);
  return out;
}

/// The web page's recipe: gluLookAt(L, origin, up = (0, 0, 1)) and a square opening angle around the cube (directional: a square
/// window), in the space after `clip_from_world`.
template <class T>
VariantMap<T> recipe_map(const Mat4<T>& clip_from_world, const Vec4<T>& light) {
  VariantMap<T> out;
  const Vec4<T> L = clip_from_world * light;
  const bool directional = abs(L.w) <= T(4) * epsilon<T>() * glm::length(Vec3<T>(L));
  const Vec3<T> eye = directional ? T(4) * safe_normalize(Vec3<T>(L)) : Vec3<T>(L) / L.w;
  out.reversed_depth = !directional && L.w < T(0);
  const Vec3<T> forward = glm::length(eye) > T(0) ? safe_normalize(-eye) : Vec3<T>(0, 0, 1);
  out.degenerate_up = glm::length(glm::cross(forward, Vec3<T>(0, 0, 1))) <= T(4) * epsilon<T>();
  const Mat4<T> view = look_along(eye, forward, Vec3<T>(0, 0, 1));

  T opening = T(0);
  Range<T> depth;
  for (int i = 0; i < 8; ++i) {
    const Vec4<T> corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1, 1);
    const Vec4<T> v = view * corner;
    const T side = std::max(abs(v.x), abs(v.y)), z = -v.z;
    depth.add(z);
    if (directional)
      opening = std::max(opening, side);
    else if (z > T(0))
      opening = std::max(opening, side / z);
  }
  out.smallest_w = directional ? T(1) : depth.min / depth.max;
  out.behind_light = !directional && !(depth.min > T(0));
  const T near = directional || depth.min > T(1e-3) * depth.max ? depth.min : T(1e-3) * depth.max;
  Mat4<T> projection = perspective(opening, opening, near, depth.max);
  if (directional) {
    projection = Mat4<T>(1);
    projection[0][0] = projection[1][1] = T(1) / opening;
    projection[2][2] = T(-2) / depth.size();
    projection[3][2] = -(depth.min + depth.max) / depth.size();
  }
  out.map_from_world = projection * view * clip_from_world;
  return out;
}

}  // namespace psm
