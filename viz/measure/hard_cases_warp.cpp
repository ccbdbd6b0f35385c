// SPDX-License-Identifier: GPL-3.0-or-later
// Cases 1 to 10, 12, 31, 32, 35 and 37: the two-dimensional model of GMNPR 2007. n = 1, f = 100, phi = 30 degrees unless stated.
#include <cmath>

#include "measure/hard_case_rows.h"

namespace psm {
namespace {

// A few roundings of double, for sums of non-negative terms.
constexpr double kFewUlps = 16 * 2.220446049250313e-16;

template <class T>
WarpModel<T> model_at(double theta_deg, double f = 100) {
  return WarpModel<T>::from_degrees(T(1), T(given(f)), T(30), T(given(theta_deg)));
}

template <class T>
WarpError<T> error_at(const WarpModel<T>& m, T rho) {
  return warp_error(m, rho, m.tan_phi);
}

template <class T>
WarpError<T> error_of(Warp warp, const WarpModel<T>& m) {
  return error_at(m, warp_strength(warp, m).rho);
}

/// lambda, or the technique's refusal.
template <class T>
CaseAnswer lambda_of(Warp warp, const WarpModel<T>& m) {
  const auto strength = warp_strength(warp, m);
  if (!strength.exists) return named(warp == Warp::glpr ? "glpr_needs_theta_above_phi" : "lambda_not_positive");
  return answer(double(strength.lambda()));
}

void add_regular_angles(Rows& rows) {
  rows.equals(1, "theta = 90 deg", "lambda of GMNPR", exactly(1, 9), kFewUlps,
              [](auto t) { return warp_strength(Warp::gmnpr, model_at<decltype(t)>(90)).lambda(); });
  rows.equals(1, "theta = 90 deg", "F(n) / F(f) of GMNPR", exactly(1), kFewUlps, [](auto t) {
    const auto e = error_of(Warp::gmnpr, model_at<decltype(t)>(90));
    return e.F_near / e.F_far;
  });
  rows.equals(2, "theta = phi, from above", "lambda of GMNPR, Eq. 4", exactly(1, 20), kFewUlps,
              [](auto t) { return warp_strength(Warp::gmnpr, model_at<decltype(t)>(30)).lambda(); });
  // One rounding below phi moves theta by 1.2e-16 of itself and lambda by no more than that times (pi/2) / (lambda ...) ~ 4.
  rows.equals(2, "theta = phi, from below", "lambda of GMNPR, Eq. 7, one rounding below phi", exactly(1, 20), 4 * kFewUlps,
              [](auto t) {
                using T = decltype(t);
                const auto m = WarpModel<T>::from_degrees(T(1), T(100), T(30), std::nextafter(given(T(30)), T(0)));
                return m.above_critical() ? T(-1) : warp_strength(Warp::gmnpr, m).lambda();
              });
  rows.refuses(2, "theta = phi", "lambda of GLPR", "glpr_needs_theta_above_phi",
               [](auto t) { return lambda_of(Warp::glpr, model_at<decltype(t)>(30)); });
}

void add_critical_angle(Rows& rows) {
  rows.at_most(3, "theta = phi +- 1e-12 rad", "jump of lambda of GMNPR over the step", 1e-12, 1e-12, [](auto t) {
    using T = decltype(t);
    return abs(warp_strength(Warp::gmnpr, model_at<T>(30 + 1e-12 * kDegrees)).lambda() -
               warp_strength(Warp::gmnpr, model_at<T>(30 - 1e-12 * kDegrees)).lambda());
  });
  // theta - phi is exact in degrees (Sterbenz), so that only the typed angle's own rounding remains: extended takes the same one.
  // In float the two angles are the same number.
  rows.follows(3, "theta = phi + 1e-12 rad", "lambda of GLPR, from degrees", kFewUlps,
               [](auto t) { return lambda_of(Warp::glpr, model_at<decltype(t)>(30 + 1e-12 * kDegrees)); });
  const Wide<100> theta = half_turn<Wide<100>>() / Wide<100>(6) + Wide<100>(1e-12);
  const glm::dvec2 light(double(sin(theta)), -double(cos(theta)));
  // From vectors sin(theta) - cos(theta) tan(phi) cancels: 3 roundings of 1/2 over 1e-12 / cos(phi).
  rows.equals(
      3, "the same, from vectors", "lambda of GLPR, S - C cancels", in_digits([](auto t) {
        using T = decltype(t);
        const T s = sin(T(1e-12)), phi = half_turn<T>() / T(6);
        return s / (T(100) * sin(T(2) * phi + T(1e-12)) - s);
      }),
      1e-3, [light](auto t) {
        using T = decltype(t);
        const Vec3<T> to_light(T(0), T(given(light.x)), T(given(light.y)));
        return lambda_of(Warp::glpr, WarpModel<T>::from_vectors(T(1), T(100), T(0.57735026918962576), {0, 0, -1}, to_light));
      });
}

void add_light_along_the_view(Rows& rows) {
  rows.equals(4, "theta = 0", "largest |1 - rho| of the techniques", exactly(0), 0, [](auto t) {
    using T = decltype(t);
    T largest(0);
    for (const Warp w : {Warp::lispsm, Warp::lispsm_reference, Warp::gmnpr, Warp::minimax, Warp::minimax_frustum})
      largest = std::max(largest, warp_strength(w, model_at<T>(0)).one_minus_rho);
    return largest;
  });
  rows.equals(4, "theta = 0, any axis", "E(n) of the uniform map, 2 f / n", exactly(200), kFewUlps,
              [](auto t) { return model_at<decltype(t)>(0).E(1, 1); });
  rows.follows(5, "theta = 1e-12 rad", "1 - rho of GMNPR", 4 * kFewUlps,
               [](auto t) { return warp_strength(Warp::gmnpr, model_at<decltype(t)>(1e-12 * kDegrees)).one_minus_rho; });
  rows.follows(5, "theta = 1e-12 rad", "largest E on the central line, finite", kFewUlps,
               [](auto t) { return error_of(Warp::gmnpr, model_at<decltype(t)>(1e-12 * kDegrees)).E_max_line; });
  rows.at_most(10, "theta -> pi - theta", "|change of lambda| of GMNPR at 20 and 75 deg", 0, 0, [](auto t) {
    using T = decltype(t);
    T largest(0);
    for (const double deg : {20.0, 75.0}) {
      const T y = T(std::sin(deg / kDegrees)), z = T(std::cos(deg / kDegrees));
      const auto lambda = [&](T depth) {
        return warp_strength(Warp::gmnpr, WarpModel<T>::from_vectors(T(1), T(100), T(0.5), {0, 0, -1}, {0, y, depth})).lambda();
      };
      largest = std::max(largest, abs(lambda(z) - lambda(-z)));
    }
    return largest;
  });
}

/// tan(theta0) = tan(phi) sqrt f / (sqrt f + sqrt n): below it Eq. 4 is negative.
Exact theta0_deg() {
  return in_digits([](auto t) {
    using T = decltype(t);
    return atan(T(10) / (T(11) * sqrt(T(3)))) * degrees<T>();
  });
}

void add_where_techniques_end(Rows& rows) {
  const Exact theta0 = theta0_deg();
  rows.equals(6, "theta0 = 27.6934 deg", "theta0, where Eq. 4 ends, deg", theta0, kFewUlps, [](auto t) {
    using T = decltype(t);
    const T root = sqrt(given(T(100))), tangent = std::tan(given(T(30)) / degrees<T>()) * root / (root + T(1));
    return std::atan(tangent) * degrees<T>();
  });
  // 1e-9 degrees are 280,000 roundings of double and a fiftieth of one in float.
  rows.refuses(6, "theta0 - 1e-9 deg", "lambda of Eq. 4", "lambda_not_positive",
               [theta0](auto t) { return lambda_of(Warp::gmnpr_eq4, model_at<decltype(t)>(theta0.value - 1e-9)); });
  rows.above(6, "theta0 + 1e-9 deg", "lambda of Eq. 4", 0,
             [theta0](auto t) { return lambda_of(Warp::gmnpr_eq4, model_at<decltype(t)>(theta0.value + 1e-9)); });
  rows.above(7, "f = 800, theta = 20 deg", "F_max of GMNPR over that of the uniform map", 1, [](auto t) {
    using T = decltype(t);
    const auto m = model_at<T>(20, 800);
    return error_of(Warp::gmnpr, m).F_max / error_at(m, T(1)).F_max;
  });
}

void add_extreme_ranges(Rows& rows) {
  // lambda = (sqrt(fn) + n) / (f - n) at 90 degrees; f - n is exact here, and the root's rounding is all there is. Float has no
  // 1.000001: the nearest is 4.6 % farther from 1.
  const double f = 1.000001;
  rows.equals(8, "f = 1.000001, theta = 90 deg", "lambda of GMNPR",
              in_digits([f](auto t) { return (sqrt(decltype(t)(f)) + 1) / (decltype(t)(f) - 1); }), kFewUlps,
              [f](auto t) { return warp_strength(Warp::gmnpr, model_at<decltype(t)>(90, f)).lambda(); });
  rows.equals(8, "f = 1.000001, theta = 90 deg", "rho of GMNPR, which is what maps are made of",
              in_digits([f](auto t) { return 1 / sqrt(decltype(t)(f)); }), kFewUlps,
              [f](auto t) { return warp_strength(Warp::gmnpr, model_at<decltype(t)>(90, f)).rho; });
  rows.equals(9, "f = 1e8, theta = 90 deg", "lambda of GMNPR", exactly(1, 9999), kFewUlps,
              [](auto t) { return warp_strength(Warp::gmnpr, model_at<decltype(t)>(90, 1e8)).lambda(); });
  // n and f are rounded once each when they are scaled.
  for (const double scale : {1e-6, 1e6}) {
    HardCase& row = rows.at_most(12, scale < 1 ? "n, f times 1e-6" : "n, f times 1e6",
                                 "largest relative change of rho and E_max of GMNPR", 1e-14, 1e-5, [scale](auto t) {
                                   using T = decltype(t);
                                   T largest(0);
                                   for (const double deg : {10.0, 30.0, 55.0, 90.0}) {
                                     const auto a = model_at<T>(deg),
                                                b = WarpModel<T>::from_degrees(T(scale), T(100 * scale), T(30), T(deg));
                                     const T p = warp_strength(Warp::gmnpr, a).rho, q = warp_strength(Warp::gmnpr, b).rho;
                                     const T E = error_at(a, p).E_max_line, G = error_at(b, q).E_max_line;
                                     largest = std::max({largest, abs(q / p - 1), abs(G / E - 1)});
                                   }
                                   return largest;
                                 });
    if (scale > 1) row.exact = exactly(0);  // nothing is rounded
  }
}

void add_shifts(Rows& rows) {
  // At 90 degrees F(n) = rho W / (n tan phi) and F(f) = W / (rho f tan phi), rho = (n + delta) / (f + delta).
  for (const int shift : {5, 20})
    rows.equals(31, shift == 5 ? "shift by 5, theta = 90 deg" : "shift by 20, theta = 90 deg", "F_max",
                in_digits([](auto t) { return sqrt(decltype(t)(3)) * 17325 / 1000; }), kFewUlps, [shift](auto t) {
                  using T = decltype(t);
                  return error_at(model_at<T>(90), T(1 + shift) / T(100 + shift)).F_max;
                });
  for (const int shift : {0, 5, 10}) {
    const char* names[] = {"shift by 0 (PSM), theta = 90 deg", "shift by 5, theta = 90 deg",
                           "shift by 10 (LiSPSM), theta = 90 deg"};
    rows.equals(32,
                names[shift == 0   ? 0
                      : shift == 5 ? 1
                                   : 2],
                "storage factor, (f - n) / (n tan phi)", in_digits([](auto t) { return sqrt(decltype(t)(3)) * 99; }), kFewUlps,
                [shift](auto t) {
                  using T = decltype(t);
                  return error_at(model_at<T>(90), T(1 + shift) / T(100 + shift)).storage_factor;
                });
  }
}

void add_degenerate_ranges(Rows& rows) {
  rows.equals(35, "zero-depth body, n = f", "rho of LiSPSM, psmlab: nothing to warp", exactly(1), 0, [](auto t) {
    using T = decltype(t);
    return warp_strength(Warp::lispsm_reference, WarpModel<T>::from_degrees(given(T(5)), given(T(5)), T(30), T(90))).rho;
  });
  Rows::naive(rows.above(35, "zero-depth body, z0 = z1 = 5", "P_n = d / (sqrt(z1/z0) - 1), as engines do", 0, [](auto t) {
    using T = decltype(t);
    const T z0 = given(T(5)), z1 = given(T(5));
    return (z1 - z0) / (sqrt(z1 / z0) - T(1));
  }));
  rows.equals(37, "z0 = -1, z1 = 100", "rho of LiSPSM with z0 held at the near distance 0.1",
              in_digits([](auto t) { return sqrt(decltype(t)(0.1) / 100); }), 1e-15, [](auto t) {
                using T = decltype(t);
                const T z0 = std::max(given(T(-1)), T(0.1));
                return sqrt(z0 / given(T(100)));
              });
  Rows::naive(rows.above(37, "z0 = -1, z1 = 100", "sqrt(z0 z1): NaN passes the guard `if (x >= inf)`", 0, [](auto t) {
    using T = decltype(t);
    return sqrt(given(T(-1)) * T(100));
  }));
}

}  // namespace

void add_warp_cases(Rows& rows) {
  add_regular_angles(rows);
  add_critical_angle(rows);
  add_light_along_the_view(rows);
  add_where_techniques_end(rows);
  add_extreme_ranges(rows);

  add_shifts(rows);
  add_degenerate_ranges(rows);
}

}  // namespace psm
