// SPDX-License-Identifier: GPL-3.0-or-later
// Umbra, penumbra and light under a straight edge, where the fraction of the disc is known.
#include "measure/area_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/shadow_error.h"
#include "scenes.h"

namespace psm {
namespace {

/// Of the unit disc: the part with x > from.
double segment(double from) {
  const double x = std::clamp(from, -1.0, 1.0);
  return (std::acos(x) - x * std::sqrt(1 - x * x)) / glm::pi<double>();
}

/// A plate at y = 1 over x < 0, as good as endless, over the plane y = 0.
Scene under_an_edge() {
  Scene scene = empty_scene();
  add_ground(scene, 50);
  add_quad(new_mesh(scene), {-50, 1, -50}, {-50, 1, 50}, {0, 1, 50}, {0, 1, -50});
  update_bounds(scene);
  return scene;
}

LightSettings lamp(double radius) {
  LightSettings light;
  light.type = LightType::point;
  light.position = {0, 2, 0};
  light.radius = radius;
  return light;
}

SurfacePoint on_floor(double x) { return {{x, 0, 0}, {0, 1, 0}}; }

TEST(AreaLight, UnderAnEdgeTheVisiblePartOfTheDiscIsSeen) {
  const RayTracer tracer(under_an_edge());
  const double radius = 0.25;
  double before = 0;
  for (double x = -0.4; x <= 0.4; x += 0.01) {
    // The disc faces the point: across the ray (-x, 2) its places are (0, 2) + s (2, x) / d; the edge hides s < -x d / (2 + x^2).
    const double d = std::sqrt(4 + x * x), edge = -x * d / (2 + x * x) / radius;
    const double seen = visible_fraction(tracer, on_floor(x), lamp(radius));
    EXPECT_NEAR(seen, segment(edge), 2.0 / kDiscSamples) << x;
    EXPECT_GE(seen, before) << x;
    before = seen;
  }
  EXPECT_EQ(visible_fraction(tracer, on_floor(-0.3), lamp(radius)), 0.0);
  EXPECT_EQ(visible_fraction(tracer, on_floor(0.3), lamp(radius)), 1.0);
}

TEST(AreaLight, ASunHasItsDiscAtDistanceOne) {
  const RayTracer tracer(under_an_edge());
  LightSettings sun;
  sun.radius = 0.1;
  for (const double length : {1e-3, 1.0, 1e6}) {
    sun.to_light = {0, length, 0};
    for (double x = -0.15; x < 0.16; x += 0.05)
      EXPECT_NEAR(visible_fraction(tracer, on_floor(x), sun), segment(-x / 0.1), 2.0 / kDiscSamples);
  }
}

TEST(AreaLight, APointOfLightIsSeenOrNot) {
  const RayTracer tracer(under_an_edge());
  EXPECT_EQ(visible_fraction(tracer, on_floor(-0.01), lamp(0)), 0.0);
  EXPECT_EQ(visible_fraction(tracer, on_floor(0.01), lamp(0)), 1.0);
}

TEST(AreaLight, WhatIsBelowTheSurfacesOwnHorizonIsNotSeen) {
  Scene scene = empty_scene();
  add_ground(scene, 1);
  const RayTracer tracer(scene);
  LightSettings light = lamp(0.5);
  light.position = {10, 1e-4, 0};  // on the horizon: half of the disc is above it
  EXPECT_NEAR(visible_fraction(tracer, on_floor(0), light), 0.5, 0.03);
  light.position = {10, 0.51, 0};
  EXPECT_EQ(visible_fraction(tracer, on_floor(0), light), 1.0);
}

TEST(AreaLight, TheTruthIsLitByHalfAndTheMapIsComparedByFractions) {
  const VisibleImage image{5, 1, {on_floor(0), on_floor(1), on_floor(2), on_floor(3), {}}};
  const std::vector<float> fractions{0.0f, 0.4f, 0.5f, -1.0f, -1.0f};
  EXPECT_EQ(lit_by_half(image, fractions), (std::vector<Lit>{Lit::dark, Lit::dark, Lit::lit, Lit::away, Lit::unseen}));
  const MapReading map{{MapVerdict::dark, MapVerdict::lit, MapVerdict::outside, MapVerdict::dark, MapVerdict::unseen},
                       {0.25f, 0.9f, 0.0f, 0.0f, 0.0f}};
  EXPECT_NEAR(*lit_difference(fractions, map), (0.25 + 0.5 + 0.5) / 3, 1e-6);
  EXPECT_FALSE(lit_difference({-1.0f}, {{MapVerdict::lit}, {1.0f}}));
}

}  // namespace
}  // namespace psm
