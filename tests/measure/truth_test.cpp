// SPDX-License-Identifier: GPL-3.0-or-later
// Ray-traced light against scenes whose shadows are known, with each engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "measure/shadow_error.h"
#include "scenes.h"

namespace psm {
namespace {

using Engine = RayTracer::Engine;

std::vector<Engine> engines() {
  if (RayTracer::default_engine() == Engine::cgal) return {Engine::cgal};
  return {Engine::embree, Engine::cgal};
}

constexpr int kWidth = 128, kHeight = 72;

struct Picture {
  VisibleImage image;
  std::vector<Lit> truth;
};

Picture trace(const Scene& scene, const Experiment& x, Engine engine) {
  const RayTracer tracer(scene, engine);
  Picture out{see(tracer, x, kWidth, kHeight), {}};
  out.truth = trace_light(tracer, out.image, x);
  return out;
}

std::size_t count(const std::vector<Lit>& truth, Lit lit) { return std::size_t(std::count(truth.begin(), truth.end(), lit)); }

Experiment looking_down() {
  Experiment x;
  x.camera.position = {0.3, 9, 8};
  x.camera.target = {0, 0, 0};
  x.camera.near = 0.5;
  x.camera.far = 60;
  return x;
}

Experiment with_sun(const glm::dvec3& to_light) {
  Experiment x = looking_down();
  x.light.to_light = to_light;
  return x;
}

Experiment with_lamp(const glm::dvec3& position, LightType type = LightType::point) {
  Experiment x = looking_down();
  x.light.type = type;
  x.light.position = position;
  return x;
}

class Truth : public ::testing::TestWithParam<Engine> {};
INSTANTIATE_TEST_SUITE_P(Engines, Truth, ::testing::ValuesIn(engines()),
                         [](const auto& tested) { return tested.param == Engine::embree ? "Embree" : "Cgal"; });

/// Distance of the sphere's centre from the segment (or half-line) between a point and the light.
double distance_to_ray(const glm::dvec3& center, const glm::dvec3& p, const glm::dvec4& light) {
  const glm::dvec3 d = glm::dvec3(light) - light.w * p;
  const double t = glm::clamp(glm::dot(center - p, d) / glm::dot(d, d), 0.0, light.w == 0 ? 1e300 : 1.0);
  return glm::length(p + t * d - center);
}

void expect_round_shadow(const Experiment& x, Engine engine) {
  const glm::dvec3 center(0, 2, 0);
  constexpr int kRings = 48;
  const double radius = 1, least = radius * std::pow(std::cos(glm::pi<double>() / (2 * kRings)), 2);
  Scene scene = empty_scene();
  add_ground(scene, 6);
  add_sphere(scene, center, radius, kRings);
  const Picture p = trace(scene, x, engine);
  const glm::dvec4 light =
      x.light.type == LightType::directional ? glm::dvec4(x.light.to_light, 0) : glm::dvec4(x.light.position, 1);
  std::size_t dark = 0, unsure = 0;
  for (std::size_t i = 0; i < p.truth.size(); ++i) {
    if (!p.image.sees(i) || p.image.points[i].normal.y < 1 - 1e-9 || p.image.points[i].position.y > 0.01) continue;
    ASSERT_NE(p.truth[i], Lit::away);
    const double d = distance_to_ray(center, p.image.points[i].position, light);
    // Between the sphere and the largest one inside its facets, either answer may be right.
    if (d > least && d < radius) {
      ++unsure;
      continue;
    }
    EXPECT_EQ(p.truth[i] == Lit::dark, d < radius) << i << " " << d;
    dark += d < radius;
  }
  EXPECT_GT(dark, 50u);
  EXPECT_LT(unsure, 10u);
}

TEST_P(Truth, SphereInTheSun) { expect_round_shadow(with_sun({0.4, 1, -0.3}), GetParam()); }
TEST_P(Truth, SphereUnderALamp) { expect_round_shadow(with_lamp({0.5, 4.5, 0.7}), GetParam()); }
TEST_P(Truth, NoShadowOfWhatIsBehindTheLamp) {
  Scene scene = empty_scene();
  add_ground(scene, 6);
  add_box(scene, {-1, 3, -1}, {1, 4, 1});
  const Picture p = trace(scene, with_lamp({0, 2.5, 0}), GetParam());
  EXPECT_EQ(count(p.truth, Lit::dark), 0u);
  EXPECT_GT(count(p.truth, Lit::lit), 1000u);
}

TEST_P(Truth, SpotLightsItsConeAlone) {
  Scene scene = empty_scene();
  add_ground(scene, 6);
  Experiment x = with_lamp({0, 3, 0}, LightType::spot);
  x.light.target = {0, 0, 0};
  x.light.cone_deg = 60;
  const Picture p = trace(scene, x, GetParam());
  const double radius = 3 * std::tan(glm::radians(30.0));
  for (std::size_t i = 0; i < p.truth.size(); ++i) {
    if (!p.image.sees(i)) continue;
    const double d = std::hypot(p.image.points[i].position.x, p.image.points[i].position.z);
    EXPECT_EQ(p.truth[i], d < radius ? Lit::lit : Lit::away) << d;
  }
  EXPECT_GT(count(p.truth, Lit::lit), 100u);
  EXPECT_GT(count(p.truth, Lit::away), 100u);
}

TEST_P(Truth, LampInARoomLightsAllWalls) {
  Scene scene = empty_scene();
  add_box(scene, {-5, -5, -5}, {5, 5, 5});
  Experiment x = with_lamp({1, 0.3, -2});
  x.camera.position = {4, 4, 4};
  x.camera.near = 0.01;
  const Picture p = trace(scene, x, GetParam());
  EXPECT_EQ(count(p.truth, Lit::lit), p.truth.size());
  // And nothing from outside.
  x.light.position = {1, 7, 30};
  const Picture out = trace(scene, x, GetParam());
  EXPECT_EQ(count(out.truth, Lit::lit), 0u);
  EXPECT_EQ(count(out.truth, Lit::unseen), 0u);
}

TEST_P(Truth, LightInTheSurfacesOwnPlaneLightsNeitherSide) {
  Scene scene = empty_scene();
  add_ground(scene, 6, 0.1);
  for (const Experiment& x : {with_sun({1, 0, 0.3}), with_lamp({20, 0.1, 3}), with_lamp({1, 0.1, 0})}) {
    const Picture p = trace(scene, x, GetParam());
    EXPECT_EQ(count(p.truth, Lit::lit) + count(p.truth, Lit::dark), 0u);
    EXPECT_GT(count(p.truth, Lit::away), 1000u);
  }
}

/// A convex body alone in the world casts no shadow on itself, and neither does a finely divided plane, however low the light.
TEST_P(Truth, NothingConvexShadowsItself) {
  for (const double size : {1.0, 1e-4, 1e4}) {
    for (const double height : {1.0, 1e-2, 1e-5, 1e-8}) {
      Scene scene = empty_scene();
      Mesh& field = new_mesh(scene);
      for (int i = 0; i < 400; ++i) {
        const double x = i % 20 - 10.0, z = i / 20 - 10.0;
        add_quad(field, {x, 0.3, z}, {x, 0.3, z + 1}, {x + 1, 0.3, z + 1}, {x + 1, 0.3, z});
      }
      update_bounds(scene);
      Experiment x = with_sun({0.7, height, 0.2});
      scale(scene, x, size);
      EXPECT_EQ(count(trace(scene, x, GetParam()).truth, Lit::dark), 0u) << size << " " << height;

      Scene ball = empty_scene();
      add_sphere(ball, {0.1, 0.7, 0.3}, 4, 40);
      Experiment y = with_sun({0.7, height, 0.9});
      scale(ball, y, size);
      const Picture p = trace(ball, y, GetParam());
      EXPECT_EQ(count(p.truth, Lit::dark), 0u) << size << " " << height;
      EXPECT_GT(count(p.truth, Lit::lit), 300u);
    }
  }
}

TEST_P(Truth, DoesNotDependOnTheUnit) {
  for (const Experiment& base : {with_sun({0.4, 1, -0.3}), with_lamp({0.5, 4.5, 0.7})}) {
    std::vector<Lit> first;
    for (const double factor : {1.0, 1e-4, 1e4, 1e-9, 1e9}) {
      const auto made = builtin_scene("chessboard");
      ASSERT_TRUE(made);
      Scene scene = *made;
      Experiment x = base;
      scale(scene, x, factor);
      const std::vector<Lit> truth = trace(scene, x, GetParam()).truth;
      if (first.empty()) first = truth;
      EXPECT_EQ(truth, first) << factor;
    }
  }
}

TEST_P(Truth, DoesNotDependOnThePlace) {
  Scene scene = empty_scene();
  add_ground(scene, 6);
  add_box(scene, {-1, 0, -1}, {1, 2, 1});
  Experiment x = with_lamp({3, 4.5, 2});
  const std::vector<Lit> here = trace(scene, x, GetParam()).truth;
  EXPECT_GT(count(here, Lit::dark), 100u);
  const glm::dvec3 shift(6.4e6, -2000, 1e6);
  for (Mesh& mesh : scene.meshes)
    for (glm::dvec3& p : mesh.positions) p += shift;
  update_bounds(scene);
  x.camera.position += shift;
  x.camera.target += shift;
  x.light.position += shift;
  const std::vector<Lit> there = trace(scene, x, GetParam()).truth;
  std::size_t differ = 0;
  for (std::size_t i = 0; i < here.size(); ++i) differ += here[i] != there[i];
  EXPECT_LE(differ, 3u);  // a nanometre can move a pixel's middle across an edge
}

TEST_P(Truth, BrokenTrianglesAreNotThere) {
  Scene scene = empty_scene();
  add_ground(scene, 6);
  add_box(scene, {-1, 0, -1}, {1, 2, 1});
  const Experiment x = with_sun({0.4, 1, -0.3});
  const Picture whole = trace(scene, x, GetParam());
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  Mesh& broken = new_mesh(scene);
  add_quad(broken, {0, nan, 0}, {1, 5, 1}, {-1, 5, 1}, {0, 5, -1});
  add_quad(broken, {0, inf, 0}, {1, 5, 1}, {-1, 5, 1}, {0, -inf, -1});
  add_quad(broken, {0, 3, 0}, {0, 3, 0}, {0, 3, 0}, {0, 3, 0});
  add_quad(broken, {0, 3, 0}, {1, 3, 1}, {2, 3, 2}, {3, 3, 3});
  const Picture same = trace(scene, x, GetParam());
  EXPECT_EQ(same.truth, whole.truth);
}

TEST_P(Truth, AnEmptySceneIsUnseen) {
  const Picture p = trace(empty_scene(), with_sun({0, 1, 0}), GetParam());
  EXPECT_EQ(count(p.truth, Lit::unseen), p.truth.size());
}

TEST_P(Truth, ASceneTooSmallToBeMeasuredIsUnseen) {
  Scene scene = empty_scene();
  add_box(scene, glm::dvec3(-1e-310), glm::dvec3(1e-310));
  const RayTracer tracer(scene, GetParam());
  EXPECT_FALSE(tracer.nearest({0, 1, 0}, {0, -1, 0}, 0, 10));
  EXPECT_FALSE(tracer.shadowed({{0, -1, 0}, {0, 1, 0}}, {0, 1, 0, 1}));
}

TEST_P(Truth, TransparentTexelsAreHoles) {
  Scene scene = empty_scene();
  add_ground(scene, 6);
  Texture& texture = scene.textures.emplace_back();
  texture.width = texture.height = 2;
  texture.nearest = true;
  texture.rgba = {9, 9, 9, 255, 9, 9, 9, 0, 9, 9, 9, 0, 9, 9, 9, 255};  // solid, hole / hole, solid
  scene.materials.emplace_back();
  scene.materials[1].texture = 0;
  scene.materials[1].alpha_cutoff = 0.5f;
  Mesh& leaf = new_mesh(scene);
  leaf.material = 1;
  add_quad(leaf, {-2, 3, -2}, {-2, 3, 2}, {2, 3, 2}, {2, 3, -2});
  leaf.texcoords = {{0, 0}, {0, 2}, {2, 2}, {2, 0}};  // 4 x 4 fields
  update_bounds(scene);
  const Picture p = trace(scene, with_sun({0, 1, 0}), GetParam());
  std::size_t solid = 0, holes = 0;
  for (std::size_t i = 0; i < p.truth.size(); ++i) {
    const glm::dvec3 at = p.image.points[i].position;
    if (!p.image.sees(i) || at.y > 1) continue;
    const bool under = std::abs(at.x) < 2 && std::abs(at.z) < 2;
    const bool dark = under && int(std::floor(at.x + 2) + std::floor(at.z + 2)) % 2 == 0;
    EXPECT_EQ(p.truth[i], dark ? Lit::dark : Lit::lit) << at.x << " " << at.z;
    ++(dark ? solid : holes);
  }
  EXPECT_GT(solid, 50u);
  EXPECT_GT(holes, 50u);
}

TEST_P(Truth, NearAndFarAreRespected) {
  Scene scene = empty_scene();
  add_ground(scene, 500);
  Experiment x;
  x.camera.position = {0, 2, 0};
  x.camera.target = {0, 2, -1};
  for (const double far : {100.0, std::numeric_limits<double>::infinity()}) {
    x.camera.near = 5;
    x.camera.far = far;
    const VisibleImage image = see(RayTracer(scene, GetParam()), x, kWidth, kHeight);
    double least = 1e300, most = 0;
    for (std::size_t i = 0; i < image.points.size(); ++i) {
      if (!image.sees(i)) continue;
      least = std::min(least, -image.points[i].position.z);
      most = std::max(most, -image.points[i].position.z);
      EXPECT_EQ(image.points[i].normal, glm::dvec3(0, 1, 0));
    }
    // Pixels k + 1/2 below the horizon see depth row / (k + 1/2).
    const double row = 2 / std::tan(glm::radians(30.0)) * kHeight / 2;
    EXPECT_NEAR(least, row / (std::floor(row / 5 - 0.5) + 0.5), 1e-9);
    EXPECT_NEAR(most, std::isinf(far) ? row / 0.5 : row / (std::ceil(row / 100 - 0.5) + 0.5), 1e-9);
  }
}

TEST_P(Truth, AHitNamesItsTriangle) {
  Scene scene = empty_scene();
  add_ground(scene, 4);
  add_ground(scene, 4, 2);
  const RayTracer tracer(scene, GetParam());
  const auto hit = tracer.nearest({1, 1, 2}, {0, -0.5, 0}, 0, 10);
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance, 2);
  EXPECT_EQ(hit->mesh, 0u);
  EXPECT_EQ(hit->triangle, 0u);
  EXPECT_EQ(hit->point.normal, glm::dvec3(0, 1, 0));
  const auto above = tracer.nearest({1, 1, -2}, {0, 3, 0}, 0, 10);
  ASSERT_TRUE(above);
  EXPECT_EQ(above->mesh, 1u);
  EXPECT_EQ(above->triangle, 1u);
  EXPECT_EQ(above->point.normal, glm::dvec3(0, -1, 0));  // its back
  EXPECT_FALSE(tracer.nearest({1, 1, 2}, {0, -0.5, 0}, 0, 1.9));
  EXPECT_FALSE(tracer.nearest({1, 1, 2}, {0, -0.5, 0}, 2.1, 10));
  EXPECT_TRUE(tracer.nearest({1, 1e7, 2}, {0, -1, 0}, 0, 1e8));
}

TEST(Engines, AgreeOnTheBuiltInScenes) {
  if (engines().size() < 2) GTEST_SKIP() << "built without Embree";
  for (const char* id : {"chessboard", "ground"}) {
    const auto scene = builtin_scene(id);
    ASSERT_TRUE(scene);
    for (const glm::dvec4& light : {glm::dvec4(0.4, 1, -0.3, 0), glm::dvec4(1, 0.05, 0.2, 0), glm::dvec4(0.5, 2.5, 0.7, 1)}) {
      Experiment x = light.w == 0 ? with_sun(glm::dvec3(light)) : with_lamp(glm::dvec3(light));
      x.camera = *scene->camera;
      const Picture a = trace(*scene, x, Engine::embree), b = trace(*scene, x, Engine::cgal);
      std::size_t differ = 0;
      for (std::size_t i = 0; i < a.truth.size(); ++i)
        differ += a.truth[i] != b.truth[i] ||
                  glm::length(a.image.points[i].position - b.image.points[i].position) > 1e-6 * glm::length(x.camera.position);
      RecordProperty(std::string(id) + "_differ", int(differ));
      EXPECT_LE(differ, 2u) << id << " of " << a.truth.size();
      EXPECT_GT(count(a.truth, Lit::lit), 500u);
    }
  }
}

}  // namespace
}  // namespace psm
