// SPDX-License-Identifier: GPL-3.0-or-later
// The size of a shadow-map texel in the image, from the analytic Jacobian.
#pragma once

#include <algorithm>

#include "math/projective.h"

namespace psm {

/// m = largest extent of a texel in pixels = 1 / smallest singular value of J = d(texel)/d(pixel). `orientation`: where in the
/// image that extent points, radians from the x axis towards the y axis (upwards), in (-pi/2, pi/2].
template <class T>
struct TexelFootprint {
  T m = T(0), anisotropy = T(1), area = T(0), orientation = T(0);
};

namespace detail {

/// d(x/w, y/w)/dt of the point x moving along tangent t, in half-sizes of the window.
template <class T>
Vec2<T> projected_derivative(const Mat4<T>& matrix, const Vec3<T>& x, const Vec3<T>& t) {
  const Vec4<T> p = matrix * Vec4<T>(x, 1), d = matrix * Vec4<T>(t, 0);
  return (Vec2<T>(d) * p.w - Vec2<T>(p) * d.w) / (p.w * p.w);
}

/// The direction of the larger singular value's left singular vector of [[a, b], [c, d]].
template <class T>
T major_axis_angle(T a, T b, T c, T d) {
  const T largest = std::max(std::max(abs(a), abs(b)), std::max(abs(c), abs(d)));
  if (!(largest > T(0))) return T(0);
  a /= largest, b /= largest, c /= largest, d /= largest;
  return atan2(T(2) * (a * c + b * d), (a - c) * (a + c) + (b - d) * (b + d)) / T(2);
}

}  // namespace detail

/// At the point x of a surface with normal `normal` (any length): image of `width` x `height` pixels, map of `resolution` texels
/// a side.
template <class T>
TexelFootprint<T> texel_footprint(const Mat4<T>& clip_from_world, const Mat4<T>& map_from_world, const Vec3<T>& x,
                                  const Vec3<T>& normal, T width, T height, T resolution) {
  const Vec3<T> n = safe_normalize(normal), t1 = perpendicular(n), t2 = glm::cross(n, t1);
  const auto columns = [&](const Mat4<T>& m, T sx, T sy) {
    const Vec2<T> half{sx / T(2), sy / T(2)};
    return glm::mat<2, 2, T, glm::highp>(detail::projected_derivative(m, x, t1) * half,
                                         detail::projected_derivative(m, x, t2) * half);
  };
  const auto texel = columns(map_from_world, resolution, resolution), pixel = columns(clip_from_world, width, height);
  const T det_pixel = glm::determinant(pixel), det_texel = glm::determinant(texel);
  // J = texel * pixel^-1; its inverse pixel * texel^-1 has 1/sigma_min as its largest singular value.
  const glm::mat<2, 2, T, glm::highp> adjugate(texel[1][1], -texel[0][1], -texel[1][0], texel[0][0]);
  const auto inverse_times_det = pixel * adjugate;
  const T a = inverse_times_det[0][0], b = inverse_times_det[1][0], c = inverse_times_det[0][1], d = inverse_times_det[1][1];
  const T largest = (hypot(a + d, b - c) + hypot(a - d, b + c)) / T(2);
  const T inf = std::numeric_limits<T>::infinity();
  TexelFootprint<T> out;
  out.orientation = detail::major_axis_angle(a, b, c, d);
  if (det_texel == T(0)) return {inf, inf, inf, out.orientation};  // the receiver contains the light ray
  out.m = largest / abs(det_texel);
  out.area = abs(det_pixel / det_texel);
  const T smallest = abs(a * d - b * c) / largest;
  out.anisotropy = smallest > T(0) ? largest / smallest : inf;
  return out;
}

}  // namespace psm
