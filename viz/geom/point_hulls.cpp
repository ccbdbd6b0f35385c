// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/point_hulls.h"

#include <algorithm>
#include <cmath>

#include "geom/convex_hull.h"
#include "geom/exact.h"

namespace psm {
namespace {

using glm::dvec3;
using Set = PointHulls::Set;

constexpr double kWorthwhile = 0.01;      // of the volume left
constexpr std::size_t kCandidates = 256;  // a detailed mesh has thousands of facets

Plane supporting(const dvec3& normal, const dvec3& point) { return Plane::through(-normal, point, 0.0, PlaneId::hull); }

/// Exactly farther along the normal.
bool farther(const dvec3& normal, const dvec3& point, const dvec3& than) {
  return point != than && exact_side(supporting(normal, than), glm::dvec4(point, 1)) < 0;
}

dvec3 farthest_point(const dvec3& normal, std::span<const dvec3> points, const dvec3& largest) {
  dvec3 best = points[0];
  double at_best = glm::dot(normal, best);
  const double rounding = 1e-15 * glm::dot(glm::abs(normal), largest);
  for (const dvec3& p : points) {
    const double at = glm::dot(normal, p);
    if (at < at_best - rounding || (at <= at_best + rounding && !farther(normal, p, best))) continue;
    best = p;
    at_best = at;
  }
  return best;
}

dvec3 largest(const dvec3& min, const dvec3& max) { return glm::max(glm::abs(min), glm::abs(max)); }

Set bounded(std::span<const dvec3> points) {
  Set set{dvec3(HUGE_VAL), dvec3(-HUGE_VAL), {}};
  for (const dvec3& p : points) {
    set.min = glm::min(set.min, p);
    set.max = glm::max(set.max, p);
  }
  return set;
}

void add_normal(PointHulls& hulls, std::span<const std::span<const dvec3>> points, const dvec3& normal) {
  hulls.normals.push_back(normal);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Set& set = hulls.sets[i];
    if (points[i].empty()) continue;
    set.farthest.push_back(farthest_point(normal, points[i], largest(set.min, set.max)));
  }
}

/// Power of two, so that nothing is rounded: products of coordinates are no lengths to calculate with.
dvec3 scaled(const dvec3& normal) {
  const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  return normal * std::ldexp(1.0, -std::ilogb(largest));
}

bool along_axis(const dvec3& n) { return (n.x != 0) + (n.y != 0) + (n.z != 0) == 1; }

struct Candidate {
  Plane plane;
  dvec3 normal;
  double gain;  // volume that it cut off when last tried: an upper bound, since what is left only shrinks
};

std::vector<Candidate> candidates(const HullFacets& hull) {
  std::vector<Candidate> out;
  for (const HullFacet& f : hull.facets) {
    const dvec3 n = scaled(f.normal);
    if (!along_axis(n)) out.push_back({supporting(n, f.corner), n, HUGE_VAL});
  }
  return out;
}

/// The plane that cuts off the most; the last tried one is it as soon as no other one's bound is higher.
Candidate* best_cut(std::vector<Candidate>& from, const ConvexBody& body, double volume) {
  const auto less = [](const Candidate& a, const Candidate& b) { return a.gain < b.gain; };
  const Candidate* tried = nullptr;
  while (!from.empty()) {
    Candidate& top = *std::max_element(from.begin(), from.end(), less);
    if (&top == tried) return &top;
    top.gain = volume - clip(body, {&top.plane, 1}).volume();
    tried = &top;
  }
  return nullptr;
}

/// The normals, and by how much the body around all points exceeds their hull.
void choose_normals(std::span<const dvec3> points, std::size_t most, std::vector<dvec3>& normals, double& excess) {
  const Set all = bounded(points);
  ConvexBody body = box_body(all.min, all.max);
  if (body.dimension < 3) return;
  const HullFacets hull = hull_facets(points, kCandidates);
  std::vector<Candidate> from = candidates(hull);
  double volume = body.volume();
  while (normals.size() < most) {
    Candidate* best = best_cut(from, body, volume);
    if (!best || !(best->gain > kWorthwhile * volume)) break;
    normals.push_back(best->normal);
    body = clip(body, {&best->plane, 1});
    volume = body.volume();
    best->gain = 0;
  }
  excess = hull.volume > 0 ? volume / hull.volume - 1 : 0;
}

}  // namespace

PointHulls point_hulls(std::span<const std::span<const dvec3>> sets, std::size_t most) {
  PointHulls hulls;
  std::vector<dvec3> points;
  for (const auto& set : sets) {
    hulls.sets.push_back(bounded(set));
    points.insert(points.end(), set.begin(), set.end());
  }
  if (points.empty()) return hulls;
  std::vector<dvec3> normals;
  choose_normals(points, most, normals, hulls.excess);
  for (const dvec3& n : normals) add_normal(hulls, sets, n);
  return hulls;
}

ConvexBody hull_body(const PointHulls& hulls, std::span<const int> chosen) {
  dvec3 min(HUGE_VAL), max(-HUGE_VAL);
  std::vector<Plane> planes;
  planes.reserve(hulls.normals.size());
  for (const int i : chosen) {
    const Set& set = hulls.sets[i];
    min = glm::min(min, set.min);
    max = glm::max(max, set.max);
  }
  std::vector<dvec3> ends;
  for (std::size_t k = 0; k < hulls.normals.size(); ++k) {
    ends.clear();
    for (const int i : chosen)
      if (!hulls.sets[i].empty()) ends.push_back(hulls.sets[i].farthest[k]);
    if (!ends.empty()) planes.push_back(supporting(hulls.normals[k], farthest_point(hulls.normals[k], ends, largest(min, max))));
  }
  return clip(box_body(min, max), planes);
}

}  // namespace psm
