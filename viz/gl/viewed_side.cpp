// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/viewed_side.h"

#include <algorithm>
#include <cmath>

#include "math/projective.h"

namespace psm::gl {
namespace {

/// The largest value of the plane on the box; with `plane` negated, the smallest negated. Within `rounding`.
struct Extreme {
  double value, rounding;
};

Extreme largest_on(const glm::dvec4& plane, const Bounds& box) {
  const glm::dvec3 corner = glm::mix(box.min, box.max, glm::greaterThan(glm::dvec3(plane), glm::dvec3(0.0)));
  const glm::dvec4 terms = plane * glm::dvec4(corner, 1.0);
  // The card computes in float, from rounded positions: what is that close to the border counts as on both sides.
  return {terms.x + terms.y + terms.z + terms.w,
          1e-5 * (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w))};
}

bool all_outside(const glm::dvec4& plane, const Bounds& box) {
  const Extreme most = largest_on(plane, box);
  return most.value < -most.rounding;
}

bool all_inside(const glm::dvec4& plane, const Bounds& box) {
  const Extreme least = largest_on(-plane, box);
  return least.value < -least.rounding;
}

/// |x|, |y|, |z| <= reach * w of this side.
void add_cube(std::vector<glm::dvec4>& planes, const glm::dmat4& cube, double reach, double sign) {
  for (int i = 0; i < 3; ++i)
    for (const double way : {1.0, -1.0}) planes.push_back(sign * (reach * row(cube, 3) + way * row(cube, i)));
}

bool all_inside(const std::vector<glm::dvec4>& planes, const Bounds& box) {
  return std::all_of(planes.begin(), planes.end(), [&](const glm::dvec4& p) { return all_inside(p, box); });
}

}  // namespace

double ViewedSide::far_end(const Bounds& box) const { return largest_on(seen_.front(), box).value; }

ViewedSide::ViewedSide(const glm::dmat4& clip, double sign, const std::optional<CubeLimit>& limit) {
  const glm::dvec4 w = sign * row(clip, 3);
  seen_.push_back(w);
  for (int i = 0; i < 3; ++i)
    for (const double way : {1.0, -1.0}) seen_.push_back(w + way * sign * row(clip, i));
  uncut_ = {w, w + sign * row(clip, 2)};
  if (!limit) return;
  add_cube(seen_, limit->cube_from_world, limit->reach, sign);
  add_cube(clear_, limit->cube_from_world, limit->clear, sign);
}

Shown ViewedSide::of(const Bounds& box) const {
  if (box.empty() || std::any_of(seen_.begin(), seen_.end(), [&](const glm::dvec4& p) { return all_outside(p, box); })) return {};
  return {true, all_inside(clear_, box), all_inside(uncut_, box)};
}

}  // namespace psm::gl
