// SPDX-License-Identifier: GPL-3.0-or-later
// The two-dimensional warp model of GMNPR 2007, section 2: how strongly each technique warps, and the aliasing error that
// follows.
//
// Eye at the origin, view along z, frustum |y| <= z tan(phi), z in [n, f]; the light makes the angle theta in [0, pi/2] with the
// view axis. The warp axis t = z sin(theta) - y cos(theta) is perpendicular to the light. Strength is carried as rho = P_n / P_f
// = lambda / (1 + lambda) in (0, 1]: rho = 1 is the uniform map, exactly. Every form is a sum of non-negative terms wherever the
// mathematics allows it, so that the limits at pi/2, phi and 0 are exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "math/projective.h"

namespace psm {

enum class Warp { uniform, lispsm, lispsm_reference, glpr, gmnpr, gmnpr_eq4, minimax, minimax_frustum };

/// The spelling of each in CSV files.
constexpr std::string_view csv_name(Warp w) {
  constexpr std::string_view names[] = {"SSM",   "LISPSM",    "LISPSM_GENERAL", "GLPR",
                                        "GMNPR", "GMNPR_EQ4", "MINIMAX",        "MINIMAX_FRUSTUM"};
  return names[int(w)];
}

/// The configuration. S = sin(theta), C = cos(theta) tan(phi); S - C is kept apart because it cancels at theta = phi.
template <class T>
struct WarpModel {
  T n, f, theta, phi, tan_phi;
  T S, C, S_minus_C;

  /// From degrees as typed: theta - phi and 90 - theta are taken before the conversion, so that they are exact where they matter.
  static WarpModel from_degrees(T n, T f, T phi_deg, T theta_deg) {
    const T rad = half_turn<T>() / T(180);
    const T phi = phi_deg * rad, tan_phi = tan(phi);
    const T cos_theta = sin((T(90) - theta_deg) * rad);
    const T S = theta_deg > T(45) ? cos((T(90) - theta_deg) * rad) : sin(theta_deg * rad);
    return {n, f, theta_deg * rad, phi, tan_phi, S, cos_theta * tan_phi, sin((theta_deg - phi_deg) * rad) / cos(phi)};
  }

  /// From the view and light directions and the effective half angle's tangent.
  static WarpModel from_vectors(T n, T f, T tan_phi, const Vec3<T>& view_forward, const Vec3<T>& to_light) {
    const T sine = glm::length(glm::cross(view_forward, to_light)), cosine = abs(glm::dot(view_forward, to_light));
    const T length = hypot(sine, cosine), S = sine / length, C = cosine / length * tan_phi;
    return {n, f, atan2(sine, cosine), atan(tan_phi), tan_phi, S, C, S - C};
  }

  bool above_critical() const { return S_minus_C >= T(0); }                            // theta >= phi
  T W() const { return above_critical() ? (f - n) * S + (f + n) * C : T(2) * f * C; }  // t_max - t_min
  T t_min() const { return (above_critical() ? n : f) * S_minus_C; }

  // N(z) = W tau + rho W (1 - tau) on the central line y = 0, with both terms non-negative.
  T W_tau(T z) const { return above_critical() ? (z - n) * S + n * C : z * S - f * S_minus_C; }
  T W_one_minus_tau(T z) const { return (f - z) * S + f * C; }
  T N(T z, T rho) const { return W_tau(z) + rho * W_one_minus_tau(z); }

  /// E = F sin(theta): the error of a surface whose footprint carries the sine (correction to Eq. 1); finite at theta = 0.
  T E(T z, T rho) const {
    const T N_z = N(z, rho);
    return N_z / (rho * W()) * (N_z / (z * tan_phi));
  }
  /// The paper's F (Eq. 2) on the central line.
  T F(T z, T rho) const { return E(z, rho) / S; }
};

/// Warp strength; both rho and 1 - rho to full precision.
template <class T>
struct WarpStrength {
  bool exists = true;  // false: the technique's lambda is not positive here
  T rho = T(1), one_minus_rho = T(0);
  T lambda() const { return one_minus_rho == T(0) ? std::numeric_limits<T>::infinity() : rho / one_minus_rho; }
};

namespace detail {

/// rho = a / (a + b) from a and b; does not exist unless a > 0.
template <class T>
WarpStrength<T> strength_of(T a, T b) {
  const T sum = a + b;
  return {a > T(0) && sum > T(0), a / sum, b / sum};
}

/// The weaker warp (the larger rho) of two, at most uniform.
template <class T>
WarpStrength<T> weaker(const WarpStrength<T>& x, const WarpStrength<T>& y) {
  const WarpStrength<T>& w = x.one_minus_rho <= y.one_minus_rho ? x : y;
  return w.one_minus_rho > T(0) ? w : WarpStrength<T>{};
}

template <class T>
WarpStrength<T> equation_4(const WarpModel<T>& m) {
  const T g = sqrt(m.f) * sqrt(m.n);
  if (m.above_critical()) return strength_of(g * m.S + m.n * m.S_minus_C, m.W());
  // lambda_2 = (f + g) / (2 f) tan(theta)/tan(phi) - 1/2, over the common factor 2 f C.
  return strength_of(g * m.S + m.f * m.S_minus_C, m.W());
}

template <class T>
WarpStrength<T> minimax_line(const WarpModel<T>& m) {
  const T mu_side = m.above_critical() ? m.n * m.C : m.n * m.S - m.f * m.S_minus_C;
  const T rest = m.above_critical() ? (m.f - m.n) * (m.S + m.C) : T(2) * (m.f - m.n) * m.S;
  const WarpStrength<T> eq4 = equation_4(m);
  const WarpStrength<T> limit = strength_of(mu_side, rest);
  return !eq4.exists ? limit : !limit.exists ? eq4 : weaker(eq4, limit);
}

template <class T>
WarpStrength<T> minimax_whole_frustum(const WarpModel<T>& m) {
  const T g = sqrt(m.f) * sqrt(m.n), plus = m.S + m.C;
  WarpStrength<T> r1, r2;
  if (m.above_critical()) {
    const T d1 = (m.f + g) * plus, d2 = (m.f - m.n) * plus;
    r1 = {true, (g * plus + m.n * m.S_minus_C) / d1, m.W() / d1};
    r2 = {true, T(2) * m.n * m.C / d2, (d2 - T(2) * m.n * m.C) / d2};
  } else {
    const T d1 = (m.f + g) * plus, d2 = (m.f - m.n) * plus;
    r1 = {true, (g * plus + m.f * m.S_minus_C) / d1, T(2) * m.f * m.C / d1};
    r2 = {true, (m.n * plus - m.f * m.S_minus_C) / d2, T(2) * (m.f * m.S - m.n * plus) / d2};
  }
  return weaker(r1, r2);
}

}  // namespace detail

/// The strength that a technique chooses (rows of the table in GMNPR 2007, sections 3 and 4; LiSPSM is its Eq. 9).
template <class T>
WarpStrength<T> warp_strength(Warp technique, const WarpModel<T>& m) {
  const T g = sqrt(m.f) * sqrt(m.n);
  if (technique == Warp::uniform || !(m.f > m.n)) return {};
  switch (technique) {
    case Warp::lispsm:
      return detail::strength_of(m.n + g, m.W() * m.S);
    case Warp::lispsm_reference: {  // N = d / (sqrt(z1 / z0) - 1), as the authors' code does it
      const T rho = sqrt(m.n / (m.n + m.W() * m.S));
      return {true, rho, m.W() * m.S / (m.n + m.W() * m.S) / (T(1) + rho)};
    }
    case Warp::glpr:
      return detail::strength_of(m.above_critical() ? m.n * m.S_minus_C : m.f * m.S_minus_C, m.W());
    case Warp::gmnpr: {
      if (m.above_critical()) return detail::equation_4(m);
      const T q = tan(half_turn<T>() / T(4) * (m.theta / m.phi));
      return detail::strength_of(sqrt(m.n), T(2) * sqrt(m.f) * q);
    }
    case Warp::gmnpr_eq4:
      return detail::equation_4(m);
    case Warp::minimax:
      return detail::minimax_line(m);
    case Warp::minimax_frustum:
      return detail::minimax_whole_frustum(m);
    default:
      return {};
  }
}

/// Errors over the depth range. F_near, F_far, F_max, F_min, z_at_min: on the central line; E_max_frustum and storage_factor:
/// over the whole frustum (of square cross-section tan_phi_x = tan_phi unless given).
template <class T>
struct WarpError {
  T F_near, F_far, F_max, F_min, z_at_min;
  T E_max_line, E_max_frustum, storage_factor;
};

template <class T>
WarpError<T> warp_error(const WarpModel<T>& m, T rho, T tan_phi_x) {
  WarpError<T> e{};
  e.F_near = m.F(m.n, rho);
  e.F_far = m.F(m.f, rho);
  e.F_max = std::max(e.F_near, e.F_far);
  // N(z) = A z + B has N^2 / z smallest at z = B / A.
  const T A = m.S * (T(1) - rho), B = rho * m.f * (m.S + m.C) - m.t_min();
  e.z_at_min = A > T(0) ? std::clamp(B / A, m.n, m.f) : m.f;
  e.F_min = m.F(e.z_at_min, rho);
  e.E_max_line = std::max(m.E(m.n, rho), m.E(m.f, rho));

  // Along y = -z tan(phi), where N is largest for its z: t = z (S + C). Along y = +z tan(phi) it is smallest: t = z (S - C).
  const T W = m.W();
  const auto N_at = [&](T t_over_z, T z) { return (T(1) - rho) * (z * t_over_z - m.t_min()) + rho * W; };
  T widest = T(0);  // max |x| / N over the corners
  for (const T& z : {m.n, m.f}) {
    const T N_far_side = N_at(m.S + m.C, z), N_near_side = N_at(m.S_minus_C, z);
    e.E_max_frustum = std::max(e.E_max_frustum, N_far_side / (rho * W) * (N_far_side / (z * m.tan_phi)));
    widest = std::max(widest, z * tan_phi_x / std::min(N_far_side, N_near_side));
  }
  T delta_x = T(0);
  for (const T& z : {m.n, m.f}) delta_x = std::max(delta_x, widest * N_at(m.S + m.C, z) / (z * tan_phi_x));
  e.storage_factor = delta_x * e.E_max_frustum;
  return e;
}

}  // namespace psm
