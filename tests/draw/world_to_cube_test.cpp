// SPDX-License-Identifier: GPL-3.0-or-later
// The way from the world to the unit cube: its ends, that each step is a post-perspective space, and that no step is a jump.
#include "draw/world_to_cube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "draw/view.h"

namespace psm {
namespace {

using glm::dmat3, glm::dmat4, glm::dvec3, glm::dvec4;

const Scene kRoom = box_scene({-5, 0, -5}, {5, 2, 5});
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Case {
  const char* name;
  CameraSettings camera;
  glm::dvec4 light;  // w = 0: a direction
  Technique technique;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class WorldToCubeCases : public testing::TestWithParam<Case> {
 protected:
  static Analysis at_step(double t) {
    const Case& c = GetParam();
    Experiment e;
    e.camera = c.camera;
    e.light.type = c.light.w == 0.0 ? LightType::directional : LightType::point;
    (c.light.w == 0.0 ? e.light.to_light : e.light.position) = dvec3(c.light);
    e.shadow.technique = c.technique;
    e.view.world_to_cube = t;
    return analyze(e, kRoom);
  }
};

TEST_P(WorldToCubeCases, AtOneItIsTheCube) {
  const Analysis a = at_step(1.0);
  const WorldToCube step = world_to_cube(a);
  EXPECT_EQ(step.shown_from_world, a.cube_from_world);
  EXPECT_EQ(step.shown_from_cube, dmat4(1.0));
  EXPECT_EQ(step.withdrawn, 0.0);
}

TEST_P(WorldToCubeCases, AtZeroShapesAreTheWorlds) {
  const Analysis a = at_step(0.0);
  const WorldToCube step = world_to_cube(a);
  EXPECT_EQ(step.withdrawn, kInfinity);
  const dmat4& m = step.shown_from_world;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(m[i].w, 0.0) << "affine";
  const dmat3 linear(m);
  const dmat3 gram = glm::transpose(linear) * linear;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(gram[i][j] / gram[0][0], i == j ? 1.0 : 0.0, 1e-12) << "a similarity";
  EXPECT_LT(glm::determinant(linear), 0.0) << "seen through the cube view's mirror";
  for (const dvec3& v : a.receivers_body.vertices) {
    const dvec4 q = m * dvec4(v, 1.0);
    for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(q[i] / q.w), 1.0 + 1e-9) << "what is in view and lit fits the cube";
  }
}

TEST_P(WorldToCubeCases, EveryStepSeesTheFrustumInFrontOfItsEye) {
  for (double t : {0.0, 1e-6, 0.1, 0.5, 0.9, 0.999, 1.0}) {
    const Analysis a = at_step(t);
    const WorldToCube step = world_to_cube(a);
    for (const dvec4& corner : a.frustum_corners) {
      const double w = (step.shown_from_world * corner).w;
      EXPECT_EQ(w > 0.0, corner.w > 0.0 || t > 0.0) << t << ": w = " << w;
      EXPECT_GE(w, 0.0) << t;
    }
    // The eye itself, withdrawn, is where w = 0.
    const dvec4 depth = glm::transpose(a.cube_from_world)[3];
    if (t > 0.0) {
      const dvec3 forward(depth);
      const dvec3 eye = a.experiment.camera.position - (a.camera_shift + step.withdrawn) * forward;
      EXPECT_NEAR((step.shown_from_world * dvec4(eye, 1.0)).w, 0.0, 1e-9 * (1.0 + step.withdrawn)) << t;
    }
    // What the step draws of the world and what it draws of the cube are the same place.
    for (const dvec3& v : a.scene_body.vertices) {
      const dvec4 direct = step.shown_from_world * dvec4(v, 1.0),
                  by_cube = step.shown_from_cube * (a.cube_from_world * dvec4(v, 1.0));
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(direct[i], by_cube[i], 1e-8 * glm::length(direct)) << t;
    }
  }
}

TEST_P(WorldToCubeCases, NoStepIsAJump) {
  const Analysis a0 = at_step(0.5);
  constexpr int kSteps = 2000;
  std::vector<dvec3> before;
  for (int i = 0; i <= kSteps; ++i) {
    Analysis a = a0;
    a.experiment.view.world_to_cube = double(i) / kSteps;
    const WorldToCube step = world_to_cube(a);
    std::vector<dvec3> now;
    for (const dvec3& v : a.receivers_body.vertices) {
      const dvec4 q = step.shown_from_world * dvec4(v, 1.0);
      now.push_back(dvec3(q) / q.w);
    }
    for (std::size_t k = 0; k < before.size(); ++k) EXPECT_LT(glm::distance(now[k], before[k]), 0.15) << i;
    before = now;
  }
}

/// A light behind the eye is inverted in the cube and a plain point in the world: on the way it passes through infinity, once.
TEST_P(WorldToCubeCases, TheLightsSideOfInfinityChangesOnceAtMost) {
  const Analysis a0 = at_step(1.0);
  int changes = 0;
  double last = 0.0;
  for (int i = 1; i <= 100; ++i) {
    Analysis a = a0;
    a.experiment.view.world_to_cube = 0.01 * i;
    const double w = (world_to_cube(a).shown_from_world * a.light).w;
    if (i > 1 && (w > 0.0) != (last > 0.0)) ++changes;
    last = w;
  }
  const bool inverted_point = a0.light.w > 0.0 && (a0.cube_from_world * a0.light).w < 0.0;
  EXPECT_EQ(changes, inverted_point ? 1 : 0);
  Analysis world = a0;
  world.experiment.view.world_to_cube = 0.0;
  const double w = (world_to_cube(world).shown_from_world * a0.light).w;
  EXPECT_GE(w, 0.0);
  EXPECT_EQ(w > 0.0, a0.light.w > 0.0);
}

TEST_P(WorldToCubeCases, AllThatIsDrawnIsFiniteAndWithinTheView) {
  for (double t : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const Analysis a = at_step(t);
    const ViewPicture picture = describe_view(ViewId::cube, a, {800, 600});
    EXPECT_EQ(picture.cube_from_world, world_to_cube(a).shown_from_world);
    for (const DrawLine& l : picture.list.lines)
      for (const dvec4& p : {l.a, l.b})
        for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(p[i] / p.w), 3.0 + 1e-9) << t << ", role " << int(l.role);
    const auto drawn = [&](Role role) {
      return std::any_of(picture.list.lines.begin(), picture.list.lines.end(), [&](const DrawLine& l) { return l.role == role; });
    };
    for (Role role : {Role::frustum, Role::caster_body, Role::receivers_body, Role::light}) EXPECT_TRUE(drawn(role)) << t;
    EXPECT_EQ(picture.title.find("Unit cube") == 0, t == 1.0) << picture.title;
  }
}

const CameraSettings kAcross{{0, 3, 9}, {0, 1, 0}, {0, 1, 0}, 60, 0.1, 100};
const CameraSettings kInside{{0, 1.5, 0}, {0, 1.5, -1}, {0, 1, 0}, 60, 0.5, 20};
const CameraSettings kEndless{{0, 3, 9}, {0, 1, 0}, {0, 1, 0}, 50, 0.01, kInfinity};

INSTANTIATE_TEST_SUITE_P(, WorldToCubeCases,
                         testing::Values(Case{"sun", kAcross, {0.3, 1, 0.2, 0}, Technique::gmnpr},
                                         Case{"lamp_behind", kAcross, {1, 4, 14, 1}, Technique::psm},
                                         Case{"lamp_before", kAcross, {2, 6, 1, 1}, Technique::gmnpr},
                                         Case{"shifted", kInside, {0.1, 0.4, 1, 0}, Technique::psm_divided},
                                         Case{"endless", kEndless, {0.3, 1, 0.2, 0}, Technique::gmnpr}));

}  // namespace
}  // namespace psm
