// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/point_hulls.h"

#include <gtest/gtest.h>

#include <random>

namespace psm {
namespace {

using glm::dvec3;
using Points = std::vector<dvec3>;

int exact_side_of(const Plane& p, const dvec3& x) { return exact_side(p, glm::dvec4(x, 1)); }

Points cloud(std::mt19937_64& rng, int count, const dvec3& middle, double radius) {
  std::uniform_real_distribution<double> in(-1, 1);
  Points out;
  while (int(out.size()) < count) {
    const dvec3 p{in(rng), in(rng), in(rng)};
    if (glm::length(p) <= 1) out.push_back(middle + radius * p);
  }
  return out;
}

PointHulls hulls_of(const std::vector<Points>& sets, std::size_t most = kHullPlanes) {
  return point_hulls(std::vector<std::span<const dvec3>>(sets.begin(), sets.end()), most);
}

void expect_holds(const ConvexBody& body, const Points& points) {
  for (const Plane& plane : body.planes)
    for (const dvec3& p : points) EXPECT_GE(exact_side_of(plane, p), 0) << describe(plane);
}

Points cube_corners(double by = 1) {
  Points out;
  for (int i = 0; i < 8; ++i) out.push_back(by * dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  return out;
}

/// Turned so that no plane lies along an axis.
Points turned(Points points) {
  const dvec3 axis = glm::normalize(dvec3(1, 2, 3));
  for (dvec3& p : points)
    p = p * std::cos(0.7) + glm::cross(axis, p) * std::sin(0.7) + axis * (glm::dot(axis, p) * (1 - std::cos(0.7)));
  return points;
}

// Every plane holds every chosen point, decided exactly; the body is inside the box of the points, and the smaller the fewer.
TEST(PointHulls, HoldsTheChosenPointsExactlyAndNoMoreThanTheirBox) {
  std::mt19937_64 rng(7);
  for (const double scale : {1.0, 1e-6, 1e6}) {
    const std::vector<Points> sets = {cloud(rng, 300, scale * dvec3(-3, 0, 1), scale),
                                      {},
                                      cloud(rng, 200, scale * dvec3(4, 2, -1), 0.5 * scale),
                                      cloud(rng, 100, scale * dvec3(0, 5, 0), 0.2 * scale)};
    const PointHulls hulls = hulls_of(sets);
    EXPECT_EQ(hulls.sets.size(), 4u);
    EXPECT_LE(hulls.normals.size(), kHullPlanes);
    double last = 0;
    for (const std::vector<int>& chosen : std::vector<std::vector<int>>{{3}, {1, 3}, {2, 3}, {0, 1, 2, 3}}) {
      const ConvexBody body = hull_body(hulls, chosen);
      dvec3 min(1e300), max(-1e300);
      for (const int i : chosen) {
        expect_holds(body, sets[std::size_t(i)]);
        for (const dvec3& p : sets[std::size_t(i)]) min = glm::min(min, p), max = glm::max(max, p);
      }
      EXPECT_LE(body.volume(), box_body(min, max).volume());
      EXPECT_GE(body.volume(), last * (1 - 1e-12));
      last = body.volume();
    }
  }
}

TEST(PointHulls, AHullOfFewFacetsIsTheBodyItself) {
  const std::vector<Points> sets = {turned(cube_corners())};
  const PointHulls hulls = hulls_of(sets);
  const ConvexBody body = hull_body(hulls, std::vector<int>{0});
  expect_holds(body, sets[0]);
  EXPECT_EQ(hulls.normals.size(), 6u);
  EXPECT_NEAR(body.volume(), 8.0, 1e-12);
  EXPECT_NEAR(hulls.excess, 0.0, 1e-12);
}

// A ball's hull has hundreds of facets: the bound on their number holds, and the excess is the one that the volumes give.
TEST(PointHulls, ADetailedHullIsReplacedByFewPlanesAroundIt) {
  std::mt19937_64 rng(8);
  Points ball = cloud(rng, 2000, dvec3(0), 1);
  for (dvec3& p : ball) p = glm::normalize(p);
  const std::vector<Points> sets = {ball};
  double last = 1e300;
  for (const std::size_t most : {0u, 4u, 8u, 12u}) {
    const PointHulls hulls = hulls_of(sets, most);
    EXPECT_LE(hulls.normals.size(), most);
    EXPECT_GE(hulls.excess, 0.0);
    EXPECT_LT(hulls.excess, last);
    last = hulls.excess;
    const ConvexBody body = hull_body(hulls, std::vector<int>{0});
    expect_holds(body, ball);
    EXPECT_NEAR(body.volume() / (1 + hulls.excess), 4.18879, 0.1);  // the hull's own volume, a little less than the ball's
  }
}

TEST(PointHulls, FlatSegmentPointAndNothing) {
  const Points aslant = {{0, 0, 0}, {2, 0, 2}, {2, 3, 2}, {0, 3, 0}, {1, 1, 1}};
  const struct {
    Points points;
    int dimension;
  } cases[] = {{{}, -1},
               {{{1, 2, 3}}, 0},
               {{{1, 2, 3}, {1, 2, 3}}, 0},
               {{{1, 2, 3}, {5, 2, 3}}, 1},
               {{{0, 1, 0}, {4, 1, 0}, {4, 1, 3}, {0, 1, 3}}, 2},
               {aslant, 2},
               {{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}, 2}};
  for (const auto& c : cases) {
    const std::vector<Points> sets = {c.points};
    const ConvexBody body = hull_body(hulls_of(sets), std::vector<int>{0});
    EXPECT_EQ(body.dimension, c.dimension) << c.points.size();
    expect_holds(body, c.points);
  }
}

}  // namespace
}  // namespace psm
