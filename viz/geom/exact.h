// SPDX-License-Identifier: GPL-3.0-or-later
// The second stage of every decision: planes in exact arithmetic (CGAL, private to exact.cpp), made when first asked for.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "geom/plane.h"

namespace psm {

class ExactPlanes {
 public:
  /// The planes must outlive this object; more may be added at their end before each call.
  ExactPlanes();
  ~ExactPlanes();

  using Three = std::array<int, 3>;
  /// Sign of the determinant of planes corner[0..2] and p: the side of the corner as seen from p, if the corner's x.w > 0.
  int side(std::span<const Plane* const> planes, const Three& corner, int p);
  /// The corner's coordinates, each within two units in the last place.
  glm::dvec3 vertex(std::span<const Plane* const> planes, const Three& corner);

 private:
  struct Table;
  std::unique_ptr<Table> table_;
};

bool exactly_without_normal(const Plane& p);

}  // namespace psm
