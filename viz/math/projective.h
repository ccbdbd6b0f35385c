// SPDX-License-Identifier: GPL-3.0-or-later
// Projective maps: right-handed, column vectors, OpenGL clip space. Planes are row vectors, so that plane * matrix pulls back.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace psm {

template <class T>
using Vec2 = glm::vec<2, T, glm::highp>;
template <class T>
using Vec3 = glm::vec<3, T, glm::highp>;
template <class T>
using Vec4 = glm::vec<4, T, glm::highp>;
template <class T>
using Mat4 = glm::mat<4, 4, T, glm::highp>;

// Called without std::, so that numbers of more than machine precision bring their own.
using std::abs, std::sqrt, std::sin, std::cos, std::tan, std::atan, std::atan2, std::hypot, std::isinf;

/// Pi, rounded to T.
template <class T>
T half_turn() {
  return T(4) * atan(T(1));
}

/// Rounding unit of T.
template <class T>
constexpr T epsilon() {
  return std::numeric_limits<T>::epsilon();
}

/// A matrix from its rows.
template <class T>
Mat4<T> from_rows(const Vec4<T>& x, const Vec4<T>& y, const Vec4<T>& z, const Vec4<T>& w) {
  return glm::transpose(Mat4<T>(x, y, z, w));
}

template <class T>
Vec4<T> row(const Mat4<T>& m, int i) {
  return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

/// Unit vector; components are scaled first, so that lengths near the ends of T's range survive. The zero vector stays zero.
template <class T>
Vec3<T> safe_normalize(const Vec3<T>& v) {
  const T largest = std::max(abs(v.x), std::max(abs(v.y), abs(v.z)));
  if (!(largest > T(0))) return Vec3<T>(0);
  const Vec3<T> scaled = v / largest;
  return scaled / glm::length(scaled);
}

/// Any unit vector perpendicular to the unit vector `n`: the axis least aligned with n, projected.
template <class T>
Vec3<T> perpendicular(const Vec3<T>& n) {
  const Vec3<T> a = glm::abs(n);
  Vec3<T> axis(0);
  axis[a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2] = T(1);
  return glm::normalize(axis - n * glm::dot(axis, n));
}

/// Symmetric perspective with depth in [-1, 1]; `f` may be infinite, and then the far face is at z = 1 = the infinity plane.
template <class T>
Mat4<T> perspective(T tan_phi_x, T tan_phi_y, T n, T f) {
  Mat4<T> m(0);
  m[0][0] = T(1) / tan_phi_x;
  m[1][1] = T(1) / tan_phi_y;
  m[2][2] = isinf(f) ? T(-1) : -(f + n) / (f - n);
  m[3][2] = isinf(f) ? T(-2) * n : T(-2) * f * n / (f - n);
  m[2][3] = T(-1);
  return m;
}

/// View matrix of a camera at `eye`: x right, y up, looking along -z.
template <class T>
Mat4<T> look_along(const Vec3<T>& eye, const Vec3<T>& forward, const Vec3<T>& up) {
  const Vec3<T> z = -safe_normalize(forward);
  Vec3<T> x = glm::cross(safe_normalize(up), z);
  x = glm::length(x) > T(4) * epsilon<T>() ? glm::normalize(x) : perpendicular(z);
  const Vec3<T> y = glm::cross(z, x);
  return from_rows<T>({x, -glm::dot(x, eye)}, {y, -glm::dot(y, eye)}, {z, -glm::dot(z, eye)}, {0, 0, 0, 1});
}

/// Angle in [0, pi/2] between two lines, accurate at both ends.
template <class T>
T line_angle(const Vec3<T>& v, const Vec3<T>& l) {
  return atan2(glm::length(glm::cross(v, l)), abs(glm::dot(v, l)));
}

}  // namespace psm
