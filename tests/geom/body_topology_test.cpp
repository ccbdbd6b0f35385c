// SPDX-License-Identifier: GPL-3.0-or-later
// The topology of R, H and H_R against exact arithmetic, on random and on degenerate cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "body_cases.h"
#include "exact_oracle.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4;

std::vector<Plane> joined(std::span<const Plane> a, std::span<const Plane> b) {
  std::vector<Plane> out(a.begin(), a.end());
  out.insert(out.end(), b.begin(), b.end());
  return out;
}

/// S's six planes, of a flat box too.
std::vector<Plane> box_planes(const BodyCase& c) {
  return {{1, 0, 0, -c.min.x}, {-1, 0, 0, c.max.x}, {0, 1, 0, -c.min.y},
          {0, -1, 0, c.max.y}, {0, 0, 1, -c.min.z}, {0, 0, -1, c.max.z}};
}

double size_of(const std::vector<dvec3>& points) {
  double size = 0;
  for (const dvec3& v : points) size = std::max({size, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return size;
}

/// Largest distance from a point of `a` to its nearest point of `b`.
double distance(const std::vector<dvec3>& a, const std::vector<dvec3>& b) {
  double largest = 0;
  for (const dvec3& p : a) {
    double nearest = INFINITY;
    for (const dvec3& q : b) nearest = std::min(nearest, glm::length(p - q));
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// The facets of each vertex, named as the oracle names them.
std::multiset<std::set<int>> vertex_facets(const ConvexBody& body, std::span<const Plane> planes, const OracleBody& oracle) {
  std::vector<std::set<int>> facets(body.vertices.size());
  for (std::size_t f = 0; f < body.facets.size(); ++f) {
    const auto plane = std::find_if(planes.begin(), planes.end(), [&](auto& p) { return same_definition(p, body.planes[f]); });
    EXPECT_NE(plane, planes.end());
    for (const int v : body.facets[f]) facets[v].insert(oracle.facet_of_plane[plane - planes.begin()]);
  }
  return {facets.begin(), facets.end()};
}

/// Closed, oriented, two-dimensional, and of the sphere's genus.
void expect_sphere(const ConvexBody& body) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& f : body.facets) {
    EXPECT_GE(f.size(), 3u);
    for (std::size_t k = 0; k < f.size(); ++k) ++edges[{f[k], f[(k + 1) % f.size()]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  if (body.dimension < 2) {
    EXPECT_TRUE(body.facets.empty());
    EXPECT_EQ(int(body.vertices.size()), body.dimension + 1);
    return;
  }
  EXPECT_EQ(int(body.vertices.size()) - int(edges.size() / 2) + int(body.facets.size()), 2);
}

/// Newell's normal of each facet against its plane's: the plane's points inwards.
void expect_outward(const ConvexBody& body) {
  for (std::size_t i = 0; i < body.facets.size(); ++i) {
    const auto& f = body.facets[i];
    dvec3 normal(0);
    for (std::size_t k = 1; k + 1 < f.size(); ++k)
      normal += glm::cross(body.vertices[f[k]] - body.vertices[f[0]], body.vertices[f[k + 1]] - body.vertices[f[0]]);
    EXPECT_LT(glm::dot(normal, glm::normalize(dvec3(body.planes[i]))), 0.0) << describe(body.planes[i]);
  }
}

/// `planes` define the body; they are also those of its facets.
void expect_exact(const ConvexBody& body, std::span<const Plane> planes) {
  const OracleBody oracle = exact_intersection(planes);
  EXPECT_EQ(body.dimension, oracle.dimension);
  ASSERT_EQ(body.vertices.size(), oracle.vertices.size());
  EXPECT_EQ(vertex_facets(body, planes, oracle), oracle.vertex_facets);
  const double size = size_of(oracle.vertices);
  EXPECT_LE(distance(body.vertices, oracle.vertices), 4e-12 * size);
  EXPECT_NEAR(body.volume(), exact_volume(body), 1e-11 * size * size * size);
  expect_sphere(body);
}

void expect_case_exact(const BodyCase& c) {
  SCOPED_TRACE(c.name);
  const CasePlanes p = planes_of(c);
  const std::vector<Plane> box = box_planes(c);
  {
    SCOPED_TRACE("R");
    expect_exact(receivers_of(p), joined(box, joined(p.spot, p.frustum)));
  }
  {
    SCOPED_TRACE("H");
    expect_exact(caster_body_of(p), joined(box, p.caster));
  }
}

TEST(BodyTopology, ThereAreSixtyDegenerateCases) { EXPECT_EQ(degenerate_cases().size(), 60u); }

TEST(BodyTopology, RandomBodiesAreExact) {
  for (const BodyCase& c : random_cases(100, 5)) {
    expect_case_exact(c);
    expect_outward(caster_body_of(planes_of(c)));
  }
}

TEST(BodyTopology, DegenerateBodiesAreExact) {
  for (const BodyCase& c : degenerate_cases()) expect_case_exact(c);
}

TEST(BodyTopology, CastersOfTheReceiversAreExact) {
  std::vector<BodyCase> cases = degenerate_cases();
  for (const BodyCase& c : random_cases(30, 6)) cases.push_back(c);
  for (const BodyCase& c : cases) {
    SCOPED_TRACE(c.name);
    const CasePlanes p = planes_of(c);
    const ConvexBody r = receivers_of(p);
    if (r.empty()) continue;
    const auto hull = hull_with_light(r, c.light);
    if (hull.size() > 20) continue;  // flat bodies: the test below
    expect_exact(lit_casters_of(p, c.light), joined(box_planes(c), joined(p.spot, hull)));
  }
}

/// Eliminating t from p_k.(x - t l) >= 0 over all pairs of planes gives hull(R + l) for any system of planes of R.
std::vector<Plane> hull_by_elimination(std::vector<Plane> planes, const dvec4& light) {
  planes.emplace_back(0, 0, 0, 1);
  std::vector<Plane> hull;
  for (const Plane& kept : planes) {
    if (exact_side(kept, light) >= 0 && dvec3(kept) != dvec3(0)) hull.push_back(kept);
    for (const Plane& dropped : planes)
      if (exact_side(kept, light) > 0 && exact_side(dropped, light) < 0) hull.push_back(Plane::silhouette(kept, dropped, light));
  }
  return hull;
}

TEST(BodyTopology, HullWithLightIsWhatEliminationGives) {
  std::vector<BodyCase> cases = degenerate_cases();
  for (const BodyCase& c : random_cases(300, 7)) cases.push_back(c);
  for (const BodyCase& c : cases) {
    SCOPED_TRACE(c.name);
    const CasePlanes p = planes_of(c);
    const ConvexBody lit = clip(p.scene, p.spot);
    const auto of_receivers = hull_by_elimination(joined(box_planes(c), joined(p.spot, p.frustum)), c.light);
    const auto of_frustum = joined(hull_by_elimination(p.frustum, c.light), p.spot);
    const std::pair<ConvexBody, ConvexBody> same[] = {{lit_casters_of(p, c.light), clip(lit, of_receivers)},
                                                      {caster_body_of(p), clip(p.scene, of_frustum)}};
    for (const auto& [body, eliminated] : same) {
      if (&body == &same[0].first && receivers_of(p).empty()) continue;
      EXPECT_EQ(body.dimension, eliminated.dimension);
      ASSERT_EQ(body.vertices.size(), eliminated.vertices.size());
      EXPECT_EQ(body.facets.size(), eliminated.facets.size());
      EXPECT_LE(distance(body.vertices, eliminated.vertices), 4e-12 * size_of(body.vertices));
    }
  }
}

/// Number of vertices, facets, and how many facets have how many corners.
std::vector<std::size_t> shape(const ConvexBody& b) {
  std::vector<std::size_t> out;
  for (const auto& f : b.facets) out.push_back(f.size());
  std::sort(out.begin(), out.end());
  out.push_back(b.vertices.size());
  out.push_back(std::size_t(b.dimension + 1));
  return out;
}

BodyCase scaled(BodyCase c, double by) {
  c.view.eye *= by, c.near *= by, c.far *= by, c.min *= by, c.max *= by;
  if (c.spot) c.spot->eye *= by;
  if (c.light.w == 1) c.light = dvec4(by * dvec3(c.light), 1);
  return c;
}

TEST(BodyTopology, DoesNotChangeWithPowersOfTwo) {
  std::vector<BodyCase> cases = degenerate_cases();
  for (const BodyCase& c : random_cases(50, 8)) cases.push_back(c);
  for (const BodyCase& c : cases)
    for (const double by : {0x1p-40, 0x1p-13, 0x1p20, 0x1p60}) {
      SCOPED_TRACE(c.name);
      const CasePlanes p = planes_of(c), q = planes_of(scaled(c, by));
      EXPECT_EQ(shape(receivers_of(p)), shape(receivers_of(q)));
      EXPECT_EQ(shape(caster_body_of(p)), shape(caster_body_of(q)));
      EXPECT_EQ(shape(lit_casters_of(p, c.light)), shape(lit_casters_of(q, scaled(c, by).light)));
    }
}

TEST(BodyTopology, DoesNotChangeWithTheOrderOfPlanes) {
  std::mt19937_64 rng(9);
  std::vector<BodyCase> cases = degenerate_cases();
  for (const BodyCase& c : random_cases(50, 10)) cases.push_back(c);
  for (const BodyCase& c : cases) {
    SCOPED_TRACE(c.name);
    CasePlanes p = planes_of(c);
    const ConvexBody body = caster_body_of(p);
    for (int round = 0; round < 10; ++round) {
      std::shuffle(p.caster.begin(), p.caster.end(), rng);
      const ConvexBody other = caster_body_of(p);
      EXPECT_EQ(shape(body), shape(other));
      EXPECT_LE(distance(other.vertices, body.vertices), 4e-12 * size_of(body.vertices));
    }
  }
}

TEST(BodyTopology, MoreCutsThanOneEyeCanMake) {  // far more planes and vertices than a frustum's, and than there are bits
  std::mt19937_64 rng(11);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Plane> planes;
  for (int i = 0; i < 300; ++i) planes.emplace_back(glm::normalize(dvec3{u(rng), u(rng), u(rng)}), 1.0);
  const ConvexBody body = clip(box_body(dvec3(-2), dvec3(2)), planes);
  EXPECT_EQ(body.dimension, 3);
  EXPECT_EQ(body.vertices.size(), 2 * body.facets.size() - 4);
  expect_sphere(body);
  expect_outward(body);
  EXPECT_NEAR(body.volume(), 4.19, 0.3);
}

TEST(BodyTopology, DimensionsOfTouchingBoxes) {
  const ConvexBody box = box_body(dvec3(0), dvec3(1));
  const auto clipped = [&](std::vector<Plane> planes) { return clip(box, planes); };
  EXPECT_EQ(box.dimension, 3);
  EXPECT_EQ(clipped({{0, 1, 0, -1}}).dimension, 2);
  EXPECT_EQ(clipped({{1, 1, 0, -2}}).dimension, 1);
  EXPECT_EQ(clipped({{1, 1, 1, -3}}).dimension, 0);
  EXPECT_EQ(clipped({{1, 1, 1, -3.0000000000000004}}).dimension, -1);
  EXPECT_EQ(clipped({{0, 1, 0, -1}, {1, 0, 0, -1}, {0, 0, -1, 0}}).vertices, std::vector<dvec3>{dvec3(1, 1, 0)});
  EXPECT_EQ(box_body({0, 0, 0}, {1, 0, 1}).facets.size(), 2u);
  EXPECT_EQ(box_body({0, 0, 0}, {1, 0, 0}).vertices.size(), 2u);
  EXPECT_EQ(box_body({3, 4, 5}, {3, 4, 5}).vertices, std::vector<dvec3>{dvec3(3, 4, 5)});
  EXPECT_TRUE(box_body({0, 1, 0}, {1, 0, 1}).empty());
}

/// The hull of a flat body with a light that keeps it flat: no edge to take a silhouette from.
TEST(BodyTopology, HullsOfPointsSegmentsAndPolygons) {
  const ConvexBody room = box_body(dvec3(-10), dvec3(10));
  const auto hull = [&](const dvec3& min, const dvec3& max, const dvec4& light) {
    const ConvexBody flat = box_body(min, max);
    return clip(room, hull_with_light(flat, light));
  };
  const auto expect = [](const ConvexBody& body, int dimension, const std::vector<dvec3>& vertices) {
    EXPECT_EQ(body.dimension, dimension);
    EXPECT_EQ(body.vertices.size(), vertices.size());
    EXPECT_EQ(distance(vertices, body.vertices), 0.0);
  };
  const dvec3 p(1, 2, 3);
  expect(hull(p, p, {4, 2, 3, 1}), 1, {p, {4, 2, 3}});
  expect(hull(p, p, {4, 3, 5, 1}), 1, {p, {4, 3, 5}});
  expect(hull(p, p, {p, 1}), 0, {p});
  expect(hull(p, p, {0, 1, 0, 0}), 1, {p, {1, 10, 3}});
  expect(hull(p, p, {-1, 1, 1, 0}), 1, {p, {-6, 9, 10}});
  expect(hull({-1, 2, 3}, p, {4, 2, 3, 1}), 1, {{-1, 2, 3}, {4, 2, 3}});
  expect(hull({-1, 2, 3}, p, {0, 2, 3, 1}), 1, {{-1, 2, 3}, p});
  expect(hull({-1, 2, 3}, p, {0, 5, 6, 1}), 2, {{-1, 2, 3}, p, {0, 5, 6}});
  expect(hull({-1, 2, 3}, p, {0, 0, -1, 0}), 2, {{-1, 2, 3}, p, {-1, 2, -10}, {1, 2, -10}});
  expect(hull({-1, 2, -1}, {1, 2, 1}, {3, 2, 0, 1}), 2, {{-1, 2, -1}, {1, 2, -1}, {3, 2, 0}, {1, 2, 1}, {-1, 2, 1}});
  expect(hull({-1, 2, -1}, {1, 2, 1}, {0, 5, 0, 1}), 3, {{-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}, {0, 5, 0}});
}

TEST(BodyTopology, FacetsKnowTheirPlanes) {
  BodyCase c = degenerate_cases()[13];
  ASSERT_EQ(c.name, "light behind the eye on the axis");
  c.max.y = 20;
  std::set<std::string> names;
  for (const Plane& p : caster_body_of(planes_of(c)).planes) names.insert(describe(p));
  EXPECT_EQ(names.count("light and the edge of V left and V near"), 0u);  // its sides reach the light through its far edges
  EXPECT_EQ(names.count("V far"), 1u);
  EXPECT_EQ(names.count("S max y"), 1u);
}

}  // namespace
}  // namespace psm
