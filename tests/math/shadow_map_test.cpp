// SPDX-License-Identifier: GPL-3.0-or-later
// Invariants of every shadow mapping, on random cameras, lights and receivers, in float and double.
#include "math/shadow_map.h"

#include <gtest/gtest.h>

#include <random>

#include "math/light_case.h"

namespace psm {
namespace {

template <class T>
struct Setup {
  Vec3<T> eye, forward, up;
  Mat4<T> clip;
  Vec4<T> light;
  std::vector<Vec3<T>> receivers;
  Vec3<T> centroid{0};
};

template <class T>
class Random {
 public:
  explicit Random(unsigned seed) : rng_(seed) {}
  T in(double a, double b) { return T(std::uniform_real_distribution<double>(a, b)(rng_)); }
  Vec3<T> direction() {
    for (;;) {
      const Vec3<T> v(in(-1, 1), in(-1, 1), in(-1, 1));
      if (glm::length(v) > T(0.1) && glm::length(v) < T(1)) return glm::normalize(v);
    }
  }
  int index(int n) { return int(rng_() % unsigned(n)); }

 private:
  std::mt19937_64 rng_;
};

/// Receivers fill part of the frustum between n = 1 and f = 10; position lights keep outside of it.
template <class T>
Setup<T> random_setup(Random<T>& r) {
  Setup<T> s;
  s.eye = r.direction() * r.in(0, 3);
  s.forward = r.direction();
  s.up = perpendicular(s.forward);
  const Mat4<T> view = look_along(s.eye, s.forward, s.up);
  s.clip = perspective(T(0.7), T(0.5), T(1), T(10)) * view;
  const Vec3<T> right = Vec3<T>(row(view, 0)), up = Vec3<T>(row(view, 1));
  for (int i = 0; i < 12; ++i) {
    const T z = i < 2 ? T(1 + 9 * i) : r.in(1, 10);
    s.receivers.push_back(s.eye + z * (s.forward + r.in(-0.7, 0.7) * right + r.in(-0.5, 0.5) * up));
    s.centroid += s.receivers.back() / T(12);
  }
  const bool directional = r.index(2) == 0;
  s.light = directional ? Vec4<T>(r.direction(), 0) : Vec4<T>(s.centroid + r.direction() * r.in(15, 40), 1);
  return s;
}

template <class T>
Vec4<T> random_technique_plane(const Setup<T>& s, const LightFrame<T>& frame, Random<T>& r) {
  std::vector<Vec3<T>> d;
  for (const auto& x : s.receivers) d.push_back(safe_normalize(x - Vec3<T>(s.light)));
  const Vec3<T> axis = s.light.w == T(0) ? Vec3<T>(0) : smallest_enclosing_cone<T>(d).axis;
  const Vec4<T> uniform = uniform_plane(s.light, axis);
  switch (r.index(3)) {
    case 0:
      return uniform;
    case 1:
      return psm_plane<T>(s.clip, s.light, s.receivers).plane;
    default: {
      const T rho = r.in(0.05, 1);
      return warped_plane(uniform, frame.b, ratio_range<T>(frame.b, uniform, s.receivers), rho, T(1) - rho);
    }
  }
}

template <class T>
class ShadowMapTyped : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ShadowMapTyped, Scalars);

TYPED_TEST(ShadowMapTyped, EveryMappingKeepsTheRule) {
  using T = TypeParam;
  Random<T> r(7);
  const T eps = epsilon<T>();
  for (int round = 0; round < 2000; ++round) {
    const Setup<T> s = random_setup(r);
    const LightFrame<T> frame = light_frame(s.light, s.centroid, s.forward, s.up);
    const Vec4<T> plane = random_technique_plane(s, frame, r);
    ASSERT_GT(value_range<T>(plane, s.receivers).min, T(0));
    const Mat4<T> M = fit_map<T>(frame, plane, s.receivers, s.receivers).map_from_world;

    // M l = (0, 0, -k, 0): each zero within the rounding of the row's and the light's lengths.
    const Vec4<T> Ml = M * s.light;
    EXPECT_LT(Ml.z, T(0));
    for (const int i : {0, 1, 3}) {
      EXPECT_LE(std::abs(Ml[i]), T(64) * eps * glm::length(row(M, i)) * glm::length(s.light)) << "row " << i;
    }

    Range<T> u, v, z;
    for (const auto& x : s.receivers) {
      const Vec4<T> q = M * Vec4<T>(x, 1);
      ASSERT_GT(q.w, T(0));
      u.add(q.x / q.w), v.add(q.y / q.w), z.add(q.z / q.w);
      // A step towards the light keeps (u, v) and reduces the depth.
      const Vec3<T> step = s.light.w == T(0) ? Vec3<T>(s.light) : (Vec3<T>(s.light) - x) * T(0.1);
      const Vec4<T> p = M * Vec4<T>(x + step, 1);
      const T tolerance = T(4000) * eps * (T(1) + T(1) / q.w);
      EXPECT_NEAR(p.x / p.w, q.x / q.w, tolerance);
      EXPECT_NEAR(p.y / p.w, q.y / q.w, tolerance);
      EXPECT_LT(p.z / p.w, q.z / q.w);
    }
    const T tight = T(4000) * eps;
    for (const Range<T>& range : {u, v, z}) {
      EXPECT_NEAR(range.min, T(-1), tight);
      EXPECT_NEAR(range.max, T(1), tight);
    }
  }
}

TYPED_TEST(ShadowMapTyped, FrustumGoesToTheCubeAndBack) {
  using T = TypeParam;
  Random<T> r(8);
  for (int round = 0; round < 500; ++round) {
    const Setup<T> s = random_setup(r);
    const Mat4<T> back = glm::inverse(s.clip);
    for (const auto& x : s.receivers) {
      const Vec4<T> q = s.clip * Vec4<T>(x, 1);
      for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(q[i] / q.w), T(1) + T(100) * epsilon<T>());
      const Vec4<T> p = back * (q / q.w);
      EXPECT_LT(glm::length(Vec3<T>(p) / p.w - x), T(2000) * epsilon<T>());
    }
  }
}

TYPED_TEST(ShadowMapTyped, SmallestConeIsNoLargerThanAnyOtherAndHoldsAll) {
  using T = TypeParam;
  Random<T> r(9);
  for (int round = 0; round < 500; ++round) {
    const Vec3<T> centre = r.direction();
    std::vector<Vec3<T>> d;
    for (int i = 0; i < 12; ++i) d.push_back(glm::normalize(centre + r.direction() * r.in(0, 0.9)));
    const Cone<T> cone = smallest_enclosing_cone<T>(d);
    const auto cosine_of = [&](const Vec3<T>& g) {
      T m = T(1);
      for (const auto& x : d) m = std::min(m, glm::dot(g, x));
      return m;
    };
    EXPECT_EQ(cone.cosine, cosine_of(cone.axis));
    for (int i = 0; i < 50; ++i)
      EXPECT_LE(cosine_of(glm::normalize(cone.axis + r.direction() * r.in(0, 0.2))), cone.cosine + T(16) * epsilon<T>());
  }
}

TEST(ShadowMap, PsmIsContinuousThroughTheCameraPlane) {
  Random<double> r(10);
  for (int round = 0; round < 200; ++round) {
    const auto s = random_setup(r);
    const Vec3<double> side = glm::cross(s.forward, s.up);
    const auto map_at = [&](double w) {
      const Vec4<double> light(glm::normalize(side + w * s.forward), 0.0);
      const auto frame = light_frame(light, s.centroid, s.forward, s.up);
      return fit_map<double>(frame, psm_plane<double>(s.clip, light, s.receivers).plane, s.receivers, s.receivers).map_from_world;
    };
    const auto before = map_at(-1e-9), at = map_at(0.0), after = map_at(1e-9);
    for (int c = 0; c < 4; ++c)
      for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(before[c][k], at[c][k], 1e-6);
        EXPECT_NEAR(after[c][k], at[c][k], 1e-6);
      }
  }
}

// n = 1, f = 100: a vanishing point at (x, 0) on the infinity plane; at x = 1.0852 looking at the centre stops being valid.
TEST(ShadowMap, PsmTurnsItsAimContinuouslyWhereTheCentreFails) {
  const double n = 1, f = 100, A = (f + n) / (f - n);
  const Mat4<double> clip = perspective(1.0, 1.0, n, f);
  std::vector<Vec3<double>> corners;
  for (const double z : {n, f})
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) corners.push_back({x * z, y * z, -z});
  double last = 0;
  int turned = 0;
  for (double x = 0.5; x < 1.5; x += 2e-5) {
    const Vec4<double> light = glm::inverse(clip) * Vec4<double>(x, 0, A, 1);
    const auto psm = psm_plane<double>(clip, {glm::normalize(Vec3<double>(light)), 0.0}, corners);
    ASSERT_TRUE(psm.valid);
    ASSERT_GT(value_range<double>(psm.plane, corners).min, 0.0) << x;
    if (x > 0.51) {
      EXPECT_LT(std::abs(psm.turned - last), 2e-3) << x;
    }
    last = psm.turned;
    turned += psm.turned > 0;
  }
  EXPECT_GT(turned, 100);
}

TEST(LightCase, SignsAndThresholds) {
  const Vec3<double> eye(1, 2, 3), v(0, 0, -1);
  EXPECT_EQ(classify_light<double>({0, 1, -1, 0}, eye, v).sign, 1);
  EXPECT_EQ(classify_light<double>({0, 1, 1, 0}, eye, v).sign, -1);
  EXPECT_EQ(classify_light<double>({0, 1, 0, 0}, eye, v).sign, 0);
  EXPECT_EQ(classify_light<double>({0, 1e30, 1e14, 0}, eye, v).sign, 0);  // within four roundings
  EXPECT_EQ(classify_light<double>({0, 1e-30, 1e-46, 0}, eye, v).sign, 0);
  EXPECT_EQ(classify_light<double>({0, 1, 1e-14, 0}, eye, v).sign, -1);
  EXPECT_EQ(classify_light<double>({5, 9, 3, 1}, eye, v).sign, 0);
  EXPECT_EQ(classify_light<double>({1, 2, 3, 1}, eye, v).sign, 0);  // at the eye
  EXPECT_EQ(classify_light<double>({1, 2, 2.999999, 1}, eye, v).sign, 1);
  EXPECT_EQ(classify_light<double>({1, 2, 3.000001, 1}, eye, v).sign, -1);
  EXPECT_TRUE(classify_light<double>({0, 1, 1, 0}, eye, v).reversed);
  EXPECT_DOUBLE_EQ(classify_light<double>({0, 3, -7, 0}, eye, v).w, 7.0);  // directions are not normalised
}

}  // namespace
}  // namespace psm
