// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/convex_body.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace psm {
namespace {

using Rng = std::mt19937_64;
double uniform(Rng& rng, double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); }
glm::dvec3 random_point(Rng& rng) { return {uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)}; }
double at(const Plane& p, const glm::dvec3& v) { return glm::dot(p, glm::dvec4(v, 1)); }

ConvexBody random_body(Rng& rng) {
  std::vector<Plane> planes;
  for (int i = 0; i < 6; ++i) {
    const glm::dvec3 n = glm::normalize(random_point(rng));
    planes.push_back({n, uniform(rng, 0.1, 0.9)});
  }
  return clip(box_body(glm::dvec3(-1), glm::dvec3(1)), planes);
}

bool contains(std::span<const Plane> planes, const glm::dvec3& v, double tolerance) {
  for (const Plane& p : planes)
    if (at(p, v) < -tolerance * glm::length(glm::dvec3(p))) return false;
  return true;
}

TEST(ConvexBody, BoxHasVolumeCentroidAndOutwardFacets) {
  const ConvexBody b = box_body({-1, 0, 2}, {3, 1, 5});
  EXPECT_DOUBLE_EQ(b.volume(), 12.0);
  EXPECT_NEAR(glm::length(b.centroid() - glm::dvec3(1, 0.5, 3.5)), 0.0, 1e-14);
}

TEST(ConvexBody, ClippingKeepsAClosedSurfaceOnItsPlanes) {
  Rng rng(1);
  for (int round = 0; round < 300; ++round) {
    const ConvexBody b = random_body(rng);
    ASSERT_FALSE(b.empty());
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t i = 0; i < b.facets.size(); ++i)
      for (std::size_t k = 0; k < b.facets[i].size(); ++k) {
        const int v = b.facets[i][k];
        EXPECT_NEAR(at(b.planes[i], b.vertices[v]), 0.0, 1e-13);
        ++edges[{v, b.facets[i][(k + 1) % b.facets[i].size()]}];
      }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
    EXPECT_EQ(int(b.vertices.size()) - int(edges.size() / 2) + int(b.facets.size()), 2);
    for (const auto& v : b.vertices) EXPECT_TRUE(contains(b.planes, v, 1e-12));
  }
}

TEST(ConvexBody, HalvesAddUp) {
  Rng rng(2);
  for (int round = 0; round < 200; ++round) {
    const ConvexBody b = random_body(rng);
    const Plane p{glm::normalize(random_point(rng)), uniform(rng, -0.5, 0.5)};
    const Plane q = -p;
    EXPECT_NEAR(clip(b, {&p, 1}).volume() + clip(b, {&q, 1}).volume(), b.volume(), 1e-13);
  }
}

TEST(ConvexBody, EmptyTouchingAndFlatAreResults) {
  const ConvexBody box = box_body(glm::dvec3(0), glm::dvec3(1));
  const Plane beyond{0, 1, 0, -2}, touching{0, 1, 0, -1};
  EXPECT_TRUE(clip(box, {&beyond, 1}).empty());
  const ConvexBody face = clip(box, {&touching, 1});
  EXPECT_EQ(face.vertices.size(), 4u);
  EXPECT_EQ(face.volume(), 0.0);
  const ConvexBody flat = box_body({0, 0, 0}, {1, 0, 1});
  const Plane half{1, 0, 0, -0.5};
  const ConvexBody flat_half = clip(flat, {&half, 1});
  EXPECT_FALSE(flat_half.empty());
  EXPECT_NEAR(glm::length(flat_half.centroid() - glm::dvec3(0.75, 0, 0.5)), 0.0, 1e-14);
}

// hull(B + l) holds B, every segment from B to the light, and nothing that no such segment can explain: a point of the hull
// lies on a ray from the light that meets B.
TEST(ConvexBody, HullWithLightHoldsTheRaysAndNoMore) {
  Rng rng(3);
  for (int round = 0; round < 300; ++round) {
    const ConvexBody b = random_body(rng);
    const bool direction = round % 2 == 0;
    const glm::dvec3 l = glm::normalize(random_point(rng)) * (direction ? 1.0 : uniform(rng, 2, 5));
    const auto hull = hull_with_light(b, {l, direction ? 0.0 : 1.0});
    for (const auto& v : b.vertices)
      for (const double s : {0.0, 0.3, 0.9}) EXPECT_TRUE(contains(hull, direction ? v + 10.0 * s * l : v + s * (l - v), 1e-12));
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 x = random_point(rng) * 3.0;
      bool explained = false;  // walk away from the light and look for B
      const glm::dvec3 away = glm::normalize(direction ? -l : x - l);
      double lo = 0, hi = 20;
      for (const Plane& p : b.planes) {
        const double at_x = at(p, x), slope = glm::dot(glm::dvec3(p), away);
        if (slope > 0)
          lo = std::max(lo, -at_x / slope);
        else if (slope < 0)
          hi = std::min(hi, -at_x / slope);
        else if (at_x < 0)
          hi = -1;
      }
      explained = lo <= hi;
      if (direction || glm::dot(x - l, b.centroid() - l) > 0 || explained) {
        EXPECT_EQ(contains(hull, x, 1e-9), explained);
      }
    }
  }
}

}  // namespace
}  // namespace psm
