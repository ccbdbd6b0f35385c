// SPDX-License-Identifier: GPL-3.0-or-later
// best_plane: the limit for any single map of this scene, found by search. A plane through the light has two degrees of freedom:
// c = u + p a + q b with the uniform plane u and the map's axes a and b, which vanish at the receivers' centroid.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/analysis_stages.h"
#include "scene/texel_sampling.h"
#include "scene/visible_receivers.h"

namespace psm {
namespace {

using glm::dmat3, glm::dvec2, glm::dvec3, glm::dvec4;

constexpr double kPercentile = 0.95;

/// What is minimised, and where: p and q in units in which a/u and b/u reach 1 on the receivers.
struct Search {
  const Stages& s;
  const Analysis& a;
  std::span<const dvec3> receivers;
  std::vector<SurfacePoint> points;
  double unit_p = 1, unit_q = 1;

  dvec4 plane(dvec2 at) const { return s.uniform + unit_p * at.x * s.frame.a + unit_q * at.y * s.frame.b; }

  /// Infinite where the plane cuts the receivers.
  double cost(dvec2 at) const {
    const dvec4 c = plane(at);
    const Range<double> r = value_range(c, receivers);
    if (!(r.min > 1e-6 * r.max)) return std::numeric_limits<double>::infinity();
    const auto fit = fit_map<double>(s.frame, c, receivers, {}, s.light_in_scene);
    return texel_percentile(points, fit.map_from_world, a, kPercentile);
  }

  /// (p, q) of a plane through the light that is positive at the centroid.
  dvec2 coordinates(const dvec4& c) const {
    const dvec3 &across = dvec3(s.frame.a), &along = dvec3(s.frame.b);
    dvec3 of;  // multiples of u, a, b
    if (s.light.w == 0) {
      of = {0, glm::dot(dvec3(c), across), glm::dot(dvec3(c), along)};
      of.x = c.w - of.y * s.frame.a.w - of.z * s.frame.b.w;
    } else {
      of = glm::inverse(dmat3(dvec3(s.uniform), across, along)) * dvec3(c);
    }
    return {of.y / of.x / unit_p, of.z / of.x / unit_q};
  }
};

double largest_ratio(const dvec4& p, const dvec4& u, std::span<const dvec3> receivers) {
  const Range<double> r = ratio_range(p, u, receivers);
  return std::max(std::abs(r.min), std::abs(r.max));
}

/// Nelder and Mead's simplex of three points, in place; their costs fall.
struct Simplex {
  std::array<dvec2, 3> at;
  std::array<double, 3> cost;

  void sort() {
    for (const int i : {0, 1, 0})
      if (cost[i + 1] < cost[i]) std::swap(cost[i], cost[i + 1]), std::swap(at[i], at[i + 1]);
  }
  void step(const Search& f) {
    sort();
    const dvec2 middle = (at[0] + at[1]) / 2.0;
    const auto trial = [&](double t) { return middle + t * (at[2] - middle); };
    double t = -1, c = f.cost(trial(-1));
    if (c < cost[0]) {
      if (const double further = f.cost(trial(-2)); further < c) t = -2, c = further;
    } else if (!(c < cost[1])) {
      const double inward = c < cost[2] ? -0.5 : 0.5;
      t = inward, c = f.cost(trial(inward));
      if (!(c < cost[2])) return shrink(f);
    }
    at[2] = trial(t), cost[2] = c;
  }
  void shrink(const Search& f) {
    for (int i : {1, 2}) at[i] = (at[0] + at[i]) / 2.0, cost[i] = f.cost(at[i]);
  }
};

struct Found {
  dvec2 at{0};
  double cost = std::numeric_limits<double>::infinity();
};

/// Smaller steps where the start lies close to a plane that cuts the receivers.
Found refine(const Search& f, Found start) {
  const Range<double> c = value_range(f.plane(start.at), f.receivers);
  const double size = 0.25 * std::min(1.0, c.min / c.max * 4);
  Simplex simplex{{start.at, start.at + dvec2(size, 0), start.at + dvec2(0, size)}, {start.cost, 0, 0}};
  for (int i : {1, 2}) simplex.cost[i] = f.cost(simplex.at[i]);
  for (int i = 0; i < 50; ++i) simplex.step(f);
  simplex.sort();
  return {simplex.at[0], simplex.cost[0]};
}

/// The planes of all other techniques for the same scene.
std::vector<dvec4> other_planes(Stages& s, const Analysis& a, std::span<const dvec3> receivers) {
  std::vector<dvec4> planes;
  Analysis ignored = a;
  for (const Technique t : {Technique::uniform, Technique::psm, Technique::lispsm, Technique::lispsm_reference, Technique::glpr,
                            Technique::gmnpr, Technique::minimax, Technique::minimax_frustum, Technique::plane_optimal})
    planes.push_back(technique_plane(t, s, ignored, receivers));
  return planes;
}

std::vector<SurfacePoint> points_for(const Stages& s, Analysis& a) {
  if (!s.served.empty()) return s.served;
  note(a, "best_plane_from_bounds", "No visible points were given: faces of the receivers' body stand in for them.");
  std::vector<SurfacePoint> points = face_points(s.view, a);
  return points.empty() ? sample_receivers(s.view, a) : points;
}

}  // namespace

dvec4 best_plane(Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  Search f{.s = s, .a = a, .receivers = receivers, .points = points_for(s, a)};
  if (f.points.empty()) return s.uniform;
  const auto unit = [&](const dvec4& p) {
    const double r = largest_ratio(p, s.uniform, receivers);
    return r > 0 ? 1 / r : 1.0;
  };
  f.unit_p = unit(s.frame.a), f.unit_q = unit(s.frame.b);

  std::vector<Found> starts;
  for (const dvec4& plane : other_planes(s, a, receivers)) {
    const dvec2 at = f.coordinates(plane);
    if (std::isfinite(at.x) && std::isfinite(at.y)) starts.push_back({at, f.cost(at)});
  }
  std::sort(starts.begin(), starts.end(), [](const Found& x, const Found& y) { return x.cost < y.cost; });
  Found best = starts.front();
  for (std::size_t i = 0; i < std::min<std::size_t>(3, starts.size()); ++i) {
    const Found refined = std::isfinite(starts[i].cost) ? refine(f, starts[i]) : starts[i];
    if (refined.cost < best.cost) best = refined;
  }
  note(a, "best_plane_found",
       "Smallest 95th percentile of m, in pixels, that the search over planes found on the " + std::to_string(f.points.size()) +
           " points it was given; limit: the best of the other techniques there.",
       best.cost, starts.front().cost);
  return f.plane(best.at);
}

}  // namespace psm
