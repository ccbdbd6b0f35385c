// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/refine.h"

#include <cmath>

namespace psm {
namespace {

/// An unevaluated sum, |low| at most half a unit of high (T. J. Dekker 1971).
struct Double2 {
  double high = 0, low = 0;
};

Double2 sum(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
Double2 product(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}
/// Sums and products to 2^-100 of the largest term: all that a residual needs.
Double2 operator+(const Double2& a, const Double2& b) {
  const Double2 s = sum(a.high, b.high);
  return sum(s.high, s.low + (a.low + b.low));
}
Double2 operator*(const Double2& a, double b) {
  const Double2 p = product(a.high, b);
  return {p.high, p.low + a.low * b};
}
Double2 operator*(const Double2& a, const Double2& b) {
  const Double2 p = product(a.high, b.high);
  return {p.high, p.low + (a.high * b.low + a.low * b.high)};
}
Double2 operator-(const Double2& a) { return {-a.high, -a.low}; }

/// For x.w = 0 or 1, with which products are exact.
Double2 value(const Plane& p, const glm::dvec4& x) {
  if (p.edge) {
    const auto& [kept, dropped, light] = *p.edge;
    return value(kept, light) * value(dropped, x) + -(value(dropped, light) * value(kept, x));
  }
  Double2 out{p.offset * x.w, 0};
  for (int k = 0; k < 3; ++k)
    if (p[k] != 0) out = out + sum(x[k], -p.anchor[k] * x.w) * p[k];
  return out;
}

}  // namespace

glm::dvec3 refined(const std::array<const Plane*, 3>& planes, const glm::dvec3& x) {
  const glm::dvec3 a(*planes[0]), b(*planes[1]), c(*planes[2]);
  const glm::dvec4 at(x, 1);
  const glm::dvec3 bc = glm::cross(b, c);
  const glm::dvec3 step = value(*planes[0], at).high * bc + value(*planes[1], at).high * glm::cross(c, a) +
                          value(*planes[2], at).high * glm::cross(a, b);
  return x - step / glm::dot(a, bc);
}

}  // namespace psm
