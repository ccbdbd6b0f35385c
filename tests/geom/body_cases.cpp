// SPDX-License-Identifier: GPL-3.0-or-later
#include "body_cases.h"

#include <limits>
#include <random>

namespace psm {
namespace {

using glm::dvec3, glm::dvec4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The straight camera: at the origin, along -z, half angles of 45 degrees. Planes and corners are exact: (±1, ±1, -1) at
// depth 1, (±100, ±100, -100) at depth 100.
ViewFrame straight() { return {}; }

BodyCase straight_case(std::string name, dvec4 light, dvec3 min = {-150, -20, -120}, dvec3 max = {150, 0.5, 12}) {
  return {.name = std::move(name), .view = straight(), .min = min, .max = max, .light = light};
}

void add_positions(std::vector<BodyCase>& out) {
  const std::pair<const char*, dvec3> positions[] = {{"light inside V", {0, 0, -10}},
                                                     {"light on V's left plane", {-10, 0, -10}},
                                                     {"light on V's left plane, above V", {-10, 20, -10}},
                                                     {"light on V's near plane, in the window", {0.5, 0.25, -1}},
                                                     {"light on V's near plane, outside the window", {5, 0, -1}},
                                                     {"light on V's far plane", {7, 0, -100}},
                                                     {"light on a side edge", {-10, -10, -10}},
                                                     {"light on a near edge", {-1, 0.25, -1}},
                                                     {"light on a far edge", {0, 100, -100}},
                                                     {"light on a near corner", {-1, -1, -1}},
                                                     {"light on a far corner", {100, 100, -100}},
                                                     {"light at the eye", {0, 0, 0}},
                                                     {"light in the camera plane", {3, 4, 0}},
                                                     {"light behind the eye on the axis", {0, 0, 5}},
                                                     {"light behind the eye on two planes", {1, 1, 1}},
                                                     {"light beyond far on an edge's line", {200, 200, -200}}};
  for (const auto& [name, p] : positions) out.push_back(straight_case(name, dvec4(p, 1)));
}

void add_directions(std::vector<BodyCase>& out) {
  const std::pair<const char*, dvec3> directions[] = {{"sun ahead along the axis", {0, 0, -1}},
                                                      {"sun behind along the axis", {0, 0, 1}},
                                                      {"sun straight up", {0, 1, 0}},
                                                      {"sun to the right", {1, 0, 0}},
                                                      {"sun in the image plane", {0.5, 1, 0}},
                                                      {"sun in the left plane", {-1, 3, -1}},
                                                      {"sun along a side edge, ahead", {1, 1, -1}},
                                                      {"sun along a side edge, behind", {-1, 1, 1}}};
  for (const auto& [name, d] : directions) out.push_back(straight_case(name, dvec4(d, 0)));
}

void add_flat_scenes(std::vector<BodyCase>& out) {
  const dvec3 ground_min(-50, -1, -80), ground_max(50, -1, 20);
  out.push_back(straight_case("flat ground, sun up", {0, 1, 0, 0}, ground_min, ground_max));
  out.push_back(straight_case("flat ground, sun in the ground", {1, 0, 2, 0}, ground_min, ground_max));
  out.push_back(straight_case("flat ground, light above", {3, 5, -7, 1}, ground_min, ground_max));
  out.push_back(straight_case("flat ground, light in the ground", {3, -1, 7, 1}, ground_min, ground_max));
  out.push_back(straight_case("flat wall on the near plane", {3, 5, 7, 1}, {-3, -3, -1}, {3, 3, -1}));
  out.push_back(straight_case("flat wall on the far plane", {0, 5, -40, 1}, {-300, -3, -100}, {300, 3, -100}));
  out.push_back(straight_case("scene is a segment", {0.3, 1, 0.2, 0}, {-30, 2, -20}, {30, 2, -20}));
  out.push_back(straight_case("scene is a segment through the light", {5, 2, -20, 1}, {-30, 2, -20}, {30, 2, -20}));
}

void add_touching(std::vector<BodyCase>& out) {
  const dvec4 sun(0.3, 1, 0.2, 0), lamp(2, 9, 3, 1);
  out.push_back(straight_case("scene is a point inside V", sun, {1, 2, -20}, {1, 2, -20}));
  out.push_back(straight_case("scene is a point on V's corner", lamp, {1, 1, -1}, {1, 1, -1}));
  out.push_back(straight_case("scene touches V's near corner", {1, 1, 0, 0}, {1, 1, -3}, {4, 5, -1}));
  out.push_back(straight_case("scene touches V's near face", {0, 0, -1, 0}, {-4, -4, -1}, {4, 4, 3}));
  out.push_back(straight_case("scene touches V's side edge in a point", {0, 2, -9, 1}, {5, 5, -5}, {9, 9, -2}));
  out.push_back(straight_case("scene beside V", {1, 0, 0, 0}, {20, -1, -5}, {30, 1, -2}));
  out.push_back(straight_case("scene away from V and light", sun, {-9, -9, 5}, {9, 9, 20}));
}

void add_slabs(std::vector<BodyCase>& out) {
  const dvec4 sun(0.3, 1, 0.2, 0);
  out.push_back(straight_case("ground 1e-9 thick", sun, {-50, -1, -80}, {50, -1 + 1e-9, 20}));
  out.push_back(straight_case("ground 1e-9 thick, light in it", {3, -1 + 5e-10, 7, 1}, {-50, -1, -80}, {50, -1 + 1e-9, 20}));
  out.push_back(straight_case("wall 1e-9 beyond the near plane", sun, {-3, -3, -1 - 1e-9}, {3, 3, -1}));
  BodyCase thin = straight_case("depth range 1e-9", sun);
  thin.far = 1 + 1e-9;
  out.push_back(thin);
}

BodyCase scaled(BodyCase c, double by, const std::string& name) {
  c.name += name;
  c.view.eye *= by;
  c.near *= by;
  c.far *= by;
  c.min *= by;
  c.max *= by;
  if (c.light.w == 1) c.light = dvec4(by * dvec3(c.light), 1);
  return c;
}

BodyCase moved(BodyCase c, const dvec3& by, const std::string& name) {
  c.name += name;
  c.view.eye += by;
  c.min += by;
  c.max += by;
  c.light += c.light.w * dvec4(by, 0);
  return c;
}

void add_scales(std::vector<BodyCase>& out) {
  const BodyCase lamp = straight_case("light on V's left plane", {-10, 20, -10, 1});
  const BodyCase sun = straight_case("sun in the image plane", {0.5, 1, 0, 0});
  for (const auto& [by, name] :
       {std::pair{1e-6, " times 1e-6"}, {1e-4, " times 1e-4"}, {1e4, " times 1e4"}, {1e6, " times 1e6"}}) {
    out.push_back(scaled(lamp, by, name));
    out.push_back(scaled(sun, by, name));
  }
  out.push_back(moved(lamp, {2000, -300, 2000}, ", 2000 away"));
  out.push_back(moved(lamp, {6.4e6, 0.1, -6.4e6}, ", 6.4e6 away"));
}

void add_unbounded(std::vector<BodyCase>& out) {
  for (BodyCase c : {straight_case("no far plane, light inside V", {1, 0, -30, 1}),
                     straight_case("no far plane, sun along a side edge", {1, 1, -1, 0}),
                     straight_case("no far plane, light at the eye", {0, 0, 0, 1})}) {
    c.far = kInfinity;
    out.push_back(c);
  }
}

BodyCase spot_case(std::string name, const dvec3& position, const dvec3& forward, double tangent) {
  BodyCase c = straight_case(std::move(name), dvec4(position, 1));
  c.spot = view_frame(position, forward, {0, 1, 0}, tangent, tangent);
  return c;
}

void add_spots(std::vector<BodyCase>& out) {
  out.push_back(spot_case("miner's lamp: L is V's pyramid", {0, 0, 0}, {0, 0, -1}, 1.0));
  out.push_back(spot_case("spot faces the eye", {0, 0, -50}, {0, 0, 1}, 0.5));
  out.push_back(spot_case("spot inside S, aslant", {10, 0, -30}, {-1, -2, 0.5}, 0.7));
  BodyCase touching = spot_case("spot's apex on S", {10, 0.5, -30}, {0, -1, 0}, 1.0);
  out.push_back(touching);
}

}  // namespace

std::vector<BodyCase> degenerate_cases() {
  std::vector<BodyCase> out;
  add_positions(out);
  add_directions(out);
  add_flat_scenes(out);
  add_touching(out);
  add_slabs(out);
  add_scales(out);
  add_unbounded(out);
  add_spots(out);
  return out;
}

std::vector<BodyCase> random_cases(int count, unsigned seed) {
  std::mt19937_64 rng(seed);
  // Not std::uniform_real_distribution: the same cases with every standard library.
  const auto uniform = [&](double a, double b) { return a + (b - a) * double(rng() >> 11) * 0x1p-53; };
  const auto vector = [&] { return dvec3{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; };  // braces: in order
  std::vector<BodyCase> out;
  for (int i = 0; i < count; ++i) {
    BodyCase c;
    c.name = "random " + std::to_string(i);
    const dvec3 forward = vector(), up = vector();
    const dvec3 eye = 20.0 * vector();
    const double tan_y = uniform(0.2, 1.0);
    c.view = view_frame(eye, forward, up, 16.0 / 9.0 * tan_y, tan_y);
    c.near = uniform(0.1, 2);
    c.far = c.near * std::pow(10.0, uniform(1, 3));
    // Three boxes in four stand around the camera; the others may lie anywhere.
    const dvec3 a = vector(), b = vector(), middle = i % 4 ? dvec3(0) : 60.0 * vector();
    c.min = middle - dvec3(10) - 50.0 * glm::abs(a);
    c.max = middle + dvec3(10) + 50.0 * glm::abs(b);
    c.light = i % 2 ? dvec4(vector(), 0) : dvec4(80.0 * vector(), 1);
    const dvec3 axis = vector();
    if (i % 6 == 4) c.spot = view_frame(dvec3(c.light), axis, up, uniform(0.5, 2), 1.0);
    out.push_back(c);
  }
  return out;
}

CasePlanes planes_of(const BodyCase& c) {
  CasePlanes p;
  p.scene = box_body(c.min, c.max);
  p.frustum = frustum_planes(c.view, c.near, c.far);
  if (c.spot) p.spot = pyramid_planes(*c.spot);
  p.caster = frustum_hull_with_light(p.frustum, c.light);
  p.caster.insert(p.caster.end(), p.spot.begin(), p.spot.end());
  return p;
}

ConvexBody receivers_of(const CasePlanes& p) { return clip(clip(p.scene, p.spot), p.frustum); }
ConvexBody caster_body_of(const CasePlanes& p) { return clip(p.scene, p.caster); }

ConvexBody lit_casters_of(const CasePlanes& p, const glm::dvec4& light) {
  const ConvexBody r = receivers_of(p);
  return r.empty() ? ConvexBody{} : clip(clip(p.scene, p.spot), hull_with_light(r, light));
}

}  // namespace psm
