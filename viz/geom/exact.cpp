// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/exact.h"

#include <CGAL/Mpzf.h>

#include "geom/filter.h"
#ifndef CGAL_HAS_MPZF
#include <CGAL/MP_Float.h>
#endif

#include <cmath>
#include <optional>
#include <vector>

namespace psm {
namespace {

#ifdef CGAL_HAS_MPZF
using Exact = CGAL::Mpzf;
#else
using Exact = CGAL::MP_Float;  // where there is no GMP (WebAssembly)
#endif

using Exact4 = std::array<Exact, 4>;

int sign_of(const Exact& x) { return int(CGAL::sign(x)); }

Exact value_at(const Exact4& p, const glm::dvec4& x) {
  Exact sum = p[0] * Exact(x.x) + p[1] * Exact(x.y) + p[2] * Exact(x.z);
  return x.w == 0 ? sum : x.w == 1 ? Exact(sum + p[3]) : Exact(sum + p[3] * Exact(x.w));
}

Exact4 exact_plane(const Plane& p) {
  if (p.edge) {
    const Exact4 i = exact_plane(p.edge->kept), j = exact_plane(p.edge->dropped);
    const Exact a = value_at(i, p.edge->light), b = value_at(j, p.edge->light);
    Exact4 out;
    for (int k = 0; k < 4; ++k) out[k] = a * j[k] - b * i[k];
    return out;
  }
  Exact4 out{Exact(p.x), Exact(p.y), Exact(p.z), Exact(p.offset)};
  for (int k = 0; k < 3; ++k)
    if (p.anchor[k] != 0) out[3] = out[3] - out[k] * Exact(p.anchor[k]);
  return out;
}

Exact minor(const Exact4& a, const Exact4& b, int i, int j) { return a[i] * b[j] - a[j] * b[i]; }

/// x with x.q = det(a, b, c, q).
Exact4 exact_corner(const Exact4& a, const Exact4& b, const Exact4& c) {
  const Exact xy = minor(a, b, 0, 1), xz = minor(a, b, 0, 2), xw = minor(a, b, 0, 3);
  const Exact yz = minor(a, b, 1, 2), yw = minor(a, b, 1, 3), zw = minor(a, b, 2, 3);
  return {c[2] * yw - c[1] * zw - c[3] * yz, c[0] * zw - c[2] * xw + c[3] * xz, c[1] * xw - c[0] * yw - c[3] * xy,
          c[0] * yz - c[1] * xz + c[2] * xy};
}

}  // namespace

struct ExactPlanes::Table {
  std::vector<std::optional<Exact4>> planes;
  Three last{-1, -1, -1};  // neighbouring questions are often about one corner
  Exact4 last_corner;

  const Exact4& at(std::span<const Plane* const> from, int i) {
    if (planes.size() < from.size()) planes.resize(from.size());
    if (!planes[i]) planes[i] = exact_plane(*from[i]);
    return *planes[i];
  }
  const Exact4& corner(std::span<const Plane* const> from, const Three& c) {
    if (c == last) return last_corner;
    planes.reserve(from.size());
    at(from, c[0]), at(from, c[1]), at(from, c[2]);
    last = c;
    return last_corner = exact_corner(*planes[c[0]], *planes[c[1]], *planes[c[2]]);
  }
};

ExactPlanes::ExactPlanes() = default;
ExactPlanes::~ExactPlanes() = default;

int ExactPlanes::side(std::span<const Plane* const> planes, const Three& corner, int p) {
  if (!table_) table_ = std::make_unique<Table>();
  const Exact4& x = table_->corner(planes, corner);
  const Exact4& q = table_->at(planes, p);
  return sign_of(x[0] * q[0] + x[1] * q[1] + x[2] * q[2] + x[3] * q[3]);
}

glm::dvec3 ExactPlanes::vertex(std::span<const Plane* const> planes, const Three& corner) {
  if (!table_) table_ = std::make_unique<Table>();
  const Exact4& x = table_->corner(planes, corner);
  const double w = CGAL::to_double(x[3]);
  return {CGAL::to_double(x[0]) / w, CGAL::to_double(x[1]) / w, CGAL::to_double(x[2]) / w};
}

int exact_side(const Plane& p, const glm::dvec4& light) {
  // The filter: n.(l - w anchor) + w offset, a few roundings of the terms below.
  if (!p.edge) {
    if (light.w == 1 && glm::dvec3(light) == p.anchor) return (p.offset > 0) - (p.offset < 0);
    const glm::dvec3 n(p), l(light), a = light.w * p.anchor;
    const double value = glm::dot(n, l - a) + light.w * p.offset;
    const double bound = 1e-15 * (glm::dot(absolute(n), absolute(l) + absolute(a)) + std::abs(light.w * p.offset));
    if (value > bound && bound > 1e-290) return 1;
    if (value < -bound && bound > 1e-290) return -1;
  }
  return sign_of(value_at(exact_plane(p), light));
}

bool exactly_without_normal(const Plane& p) {
  const Exact4 e = exact_plane(p);
  return sign_of(e[0]) == 0 && sign_of(e[1]) == 0 && sign_of(e[2]) == 0;
}

}  // namespace psm
