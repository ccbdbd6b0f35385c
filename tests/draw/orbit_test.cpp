// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "draw/view.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4;

TEST(Orbit, YawAndPitchTurnTheEye) {
  OrbitSettings o;
  o.target = {1, 2, 3};
  o.distance = 10;
  o.yaw_deg = o.pitch_deg = 0;
  EXPECT_LT(glm::distance(orbit_camera(o, dvec3(-1), dvec3(1), 1.5).eye, dvec3(1, 2, 13)), 1e-12);
  o.yaw_deg = 90;
  EXPECT_LT(glm::distance(orbit_camera(o, dvec3(-1), dvec3(1), 1.5).eye, dvec3(11, 2, 3)), 1e-12);
  o.pitch_deg = 90;
  EXPECT_LT(glm::distance(orbit_camera(o, dvec3(-1), dvec3(1), 1.5).eye, dvec3(1, 12, 3)), 1e-12);
}

TEST(Orbit, DistanceZeroFitsTheBoxAtAnyAspectAngleAndScale) {
  for (double scale : {1e-6, 1.0, 1e6}) {
    for (double aspect : {0.3, 1.0, 3.0}) {
      for (double pitch : {-90.0, -20.0, 0.0, 45.0, 90.0}) {
        OrbitSettings o;
        o.pitch_deg = pitch;
        const dvec3 low = scale * dvec3(10, -1, 3), high = scale * dvec3(14, 1, 30);
        const OrbitCamera c = orbit_camera(o, low, high, aspect);
        double widest = 0;
        for (int i = 0; i < 8; ++i) {
          const dvec3 p(i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z);
          const dvec4 q = c.clip_from_view * c.view_from_space * dvec4(p, 1);
          ASSERT_GT(q.w, 0);
          ASSERT_LE(std::abs(q.z), q.w);
          widest = std::max({widest, std::abs(q.x) / q.w, std::abs(q.y) / q.w});
        }
        EXPECT_LT(widest, 0.95);
        EXPECT_GT(widest, 0.80) << "and no smaller than it must be";
      }
    }
  }
}

TEST(Orbit, AnExtentWithoutSizeIsNoTrap) {
  for (const dvec3& p : {dvec3(0), dvec3(5, 0, 0)}) {
    const OrbitCamera c = orbit_camera({}, p, p, 1.0);
    EXPECT_GT(c.distance, 0);
    EXPECT_TRUE(std::isfinite(c.eye.x + c.eye.y + c.eye.z));
  }
}

TEST(Orbit, TheCubeIsNotMirrored) {
  Analysis a;
  a.experiment.view.cube.yaw_deg = a.experiment.view.cube.pitch_deg = 0;
  const OrbitCamera c = view_camera(ViewId::cube, a, 1.0);
  EXPECT_LT(c.eye.z, -1) << "on the near face's side, where the eye is";
  const dvec4 right = c.clip_from_view * c.view_from_space * dvec4(1, 0, 0, 1);
  EXPECT_GT(right.x / right.w, 0);
  const dvec4 near = c.clip_from_view * c.view_from_space * dvec4(0, 0, -1, 1),
              far = c.clip_from_view * c.view_from_space * dvec4(0, 0, 1, 1);
  EXPECT_LT(near.w, far.w);
}

}  // namespace
}  // namespace psm
