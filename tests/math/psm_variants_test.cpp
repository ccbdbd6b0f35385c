// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/psm_variants.h"

#include <gtest/gtest.h>

#include <random>

namespace psm {
namespace {

using V3 = Vec3<double>;
using V4 = Vec4<double>;

double in(std::mt19937_64& rng, double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); }

// FORMULAS: minimal and sufficient, on random bodies.
TEST(CameraShift, IsMinimalAndSufficient) {
  std::mt19937_64 rng(1);
  const double near = 0.5, tx = 0.8, ty = 0.6;
  for (int round = 0; round < 500; ++round) {
    std::vector<V3> h;
    std::vector<double> depths;
    for (int i = 0; i < 10; ++i) {
      h.push_back({in(rng, -5, 5), in(rng, -5, 5), in(rng, -6, 6)});
      depths.push_back(h.back().z);
    }
    const double front = shift_in_front<double>(depths, near), inside = shift_inside<double>(h, near, tx, ty);
    EXPECT_LE(front, inside);
    const auto fits = [&](double shift) {
      return std::all_of(h.begin(), h.end(), [&](const V3& v) {
        const double d = v.z + shift;
        return d >= near - 1e-12 && std::abs(v.x) <= d * tx + 1e-12 && std::abs(v.y) <= d * ty + 1e-12;
      });
    };
    EXPECT_TRUE(fits(inside));
    if (inside > 0) {
      EXPECT_FALSE(fits(inside * (1 - 1e-9) - 1e-9));
    }
    const double nearest = *std::min_element(depths.begin(), depths.end());
    if (front > 0) {
      EXPECT_NEAR(nearest + front, near, 1e-14);
    }
  }
}

struct Camera {
  Mat4<double> clip;
  std::vector<V3> frustum;
};

Camera camera(double n, double f) {
  Camera c{perspective(1.0, 1.0, n, f), {}};
  for (const double z : {n, f})
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) c.frustum.push_back({x * z, y * z, -z});
  return c;
}

V3 centroid(const std::vector<V3>& points) {
  V3 sum(0);
  for (const V3& p : points) sum += p / double(points.size());
  return sum;
}

TEST(DividedPsm, HasTheOneRulesWindowAndTheOrderOfItsLight) {
  const Camera cam = camera(1, 20);
  for (const double z : {-0.4, 0.4}) {  // from the front, from behind
    const V4 light(glm::normalize(V3(0.1, 1, z)), 0);
    const auto frame = light_frame(light, centroid(cam.frustum), V3(0, 0, -1), V3(0, 1, 0));
    const V4 plane = psm_plane<double>(cam.clip, light, cam.frustum).plane;
    const auto one_rule = fit_map<double>(frame, plane, cam.frustum, cam.frustum).map_from_world;
    const auto divided = divided_map<double>(frame, plane, cam.clip, cam.frustum, cam.frustum);
    EXPECT_EQ(divided.reversed_depth, z > 0);
    for (const V3& x : cam.frustum) {
      const V4 p = one_rule * V4(x, 1), q = divided.map_from_world * V4(x, 1);
      EXPECT_NEAR(p.x / p.w, q.x / q.w, 1e-12);
      EXPECT_NEAR(p.y / p.w, q.y / q.w, 1e-12);
      const V4 nearer = divided.map_from_world * V4(x + 0.01 * V3(light), 1);
      EXPECT_EQ(nearer.z / nearer.w > q.z / q.w, divided.reversed_depth);
    }
  }
}

// Along every light ray, from the receiver on: depth grows in the front map up to the infinity plane, where the beyond map takes
// over at its far end and counts down towards the light. Each point is in the one map or in the other, at the same place.
TEST(TwoMaps, MeetInTheInfinityPlane) {
  const Camera cam = camera(1, 20);
  std::mt19937_64 rng(2);
  for (const V4 light : {V4(glm::normalize(V3(0.1, 1, 0.4)), 0), V4(1, 6, 9, 1)}) {
    std::vector<V3> casters =
        cam.frustum;  // towards the light, as far as twice as deep behind the eye as the light, or the light
    for (const V3& x : cam.frustum) casters.push_back(light.w == 0 ? x + 60.0 * V3(light) : V3(light));
    const auto frame = light_frame(light, centroid(cam.frustum), V3(0, 0, -1), V3(0, 1, 0));
    const V4 plane = psm_plane<double>(cam.clip, light, cam.frustum).plane;
    const auto maps = two_maps<double>(frame, plane, cam.clip, cam.frustum, casters);
    ASSERT_TRUE(maps.beyond);
    EXPECT_TRUE(maps.front.reversed_depth);
    const V4 Ml = *maps.beyond * light;
    EXPECT_LT(Ml.z, 0.0);
    for (const int i : {0, 1, 3}) EXPECT_NEAR(Ml[i], 0.0, 1e-9);
    const V4 w = row(cam.clip, 3);
    for (int round = 0; round < 300; ++round) {
      const V3 receiver = cam.frustum[rng() % 4] * in(rng, 1, 20);
      const auto on_ray = [&](double t) {
        return V3(light.w == 0 ? receiver + t * V3(light) : receiver + t * (V3(light) - receiver));
      };
      const double t0 = in(rng, 0, light.w == 0 ? 60 : 0.9), t1 = t0 + (light.w == 0 ? 0.1 : 1e-3);
      const V4 front = maps.front.map_from_world * V4(on_ray(t0), 1), beyond = *maps.beyond * V4(on_ray(t0), 1);
      const double depth = front.z / front.w, behind = beyond.z / beyond.w;
      EXPECT_NEAR(front.x / front.w, beyond.x / beyond.w, 1e-9);
      EXPECT_NEAR(front.y / front.w, beyond.y / beyond.w, 1e-9);
      const bool in_front = glm::dot(w, V4(on_ray(t0), 1)) > 0.0;
      EXPECT_EQ(depth < 1.0, in_front);
      EXPECT_EQ(behind > 1.0, in_front);
      EXPECT_GE(depth, -1.0 - 1e-9);
      const V4 front1 = maps.front.map_from_world * V4(on_ray(t1), 1), beyond1 = *maps.beyond * V4(on_ray(t1), 1);
      EXPECT_GT(front1.z / front1.w, depth) << "towards the light: the reversed order of an inverted light";
      EXPECT_LT(beyond1.z / beyond1.w, behind) << "towards the light: the usual order";
    }
  }
}

TEST(TwoMaps, AreOneWhereNothingIsBehindTheEye) {
  const Camera cam = camera(1, 20);
  for (const double z : {-0.4, 0.4}) {
    const V4 light(glm::normalize(V3(0.1, 1, z)), 0);
    const auto frame = light_frame(light, centroid(cam.frustum), V3(0, 0, -1), V3(0, 1, 0));
    const V4 plane = psm_plane<double>(cam.clip, light, cam.frustum).plane;
    const auto maps = two_maps<double>(frame, plane, cam.clip, cam.frustum, cam.frustum);
    EXPECT_FALSE(maps.beyond);
    EXPECT_EQ(maps.front.map_from_world, divided_map<double>(frame, plane, cam.clip, cam.frustum, cam.frustum).map_from_world);
  }
}

TEST(Recipe, LooksAtTheCubeAndFailsWhereItsAuthorsDidNotLook) {
  const Camera cam = camera(1, 100);
  const auto from_post = [&](V4 post) {
    const V4 l = glm::inverse(cam.clip) * post;
    return V4(glm::normalize(V3(l)), 0);
  };
  const double A = 101.0 / 99.0;
  const auto overhead = recipe_map(cam.clip, V4(0, 1, 0, 0));
  EXPECT_FALSE(overhead.reversed_depth || overhead.degenerate_up || overhead.behind_light);
  for (const V3& x : cam.frustum) {
    const V4 q = overhead.map_from_world * V4(x, 1);
    EXPECT_LE(std::max(std::abs(q.x), std::abs(q.y)), q.w * (1 + 1e-12));
  }
  EXPECT_TRUE(recipe_map(cam.clip, V4(0, 0, -1, 0)).degenerate_up);
  // |x| + |y| + A < x^2 + y^2 + A^2 fails for nearly every vanishing point on screen.
  EXPECT_TRUE(recipe_map(cam.clip, from_post({0.5, 0, A, 1})).behind_light);
  EXPECT_FALSE(recipe_map(cam.clip, from_post({3, 0, A, 1})).behind_light);
  EXPECT_TRUE(recipe_map(cam.clip, V4(glm::normalize(V3(0.1, 1, 0.4)), 0)).reversed_depth);
}

}  // namespace
}  // namespace psm
