// SPDX-License-Identifier: GPL-3.0-or-later
// The analytic Jacobian against finite differences, and the formulas of its singular values.
#include "math/texel_footprint.h"

#include <gtest/gtest.h>

#include <random>

namespace psm {
namespace {

using glm::dmat4, glm::dvec2, glm::dvec3, glm::dvec4;

constexpr double kWidth = 1280, kHeight = 720, kResolution = 1024;
constexpr double kPi = 3.14159265358979323846;

dvec2 project(const dmat4& m, const dvec3& p, double sx, double sy) {
  const dvec4 q = m * dvec4(p, 1);
  return dvec2(q) / q.w * dvec2(sx / 2, sy / 2);
}

struct Surface {
  dmat4 clip, map;
  dvec3 point, normal;
};

Surface random_surface(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vec = [&] { return dvec3(any(random), any(random), any(random)); };
  const dvec3 eye = 5.0 * vec(), lamp = 5.0 * vec() + dvec3(0, 8, 0);
  Surface s;
  s.clip = perspective(0.9, 0.5, 0.1, 100.0) * look_along(eye, -eye + vec(), dvec3(0, 1, 0));
  s.map = perspective(0.5, 0.7, 0.1, 100.0) * look_along(lamp, -lamp + vec(), dvec3(0.1, 0.2, 1));
  s.point = 0.3 * vec();
  s.normal = vec();
  return s;
}

/// The extent in pixels, along each direction of the map, of a texel around the point: by central differences along the surface.
struct Extents {
  double largest = 0, smallest = 1e300, direction = 0;
};
Extents by_differences(const Surface& s) {
  const dvec3 n = glm::normalize(s.normal), t1 = perpendicular(n), t2 = glm::cross(n, t1);
  const double h = 1e-6;
  const auto difference = [&](const dmat4& m, const dvec3& t, double sx, double sy) {
    return (project(m, s.point + h * t, sx, sy) - project(m, s.point - h * t, sx, sy)) / (2 * h);
  };
  const glm::dmat2 texel(difference(s.map, t1, kResolution, kResolution), difference(s.map, t2, kResolution, kResolution));
  const glm::dmat2 pixel(difference(s.clip, t1, kWidth, kHeight), difference(s.clip, t2, kWidth, kHeight));
  const glm::dmat2 pixel_from_texel = pixel * glm::inverse(texel);
  Extents e;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = kPi * i / kSteps;
    const dvec2 extent = pixel_from_texel * dvec2(std::cos(angle), std::sin(angle));
    e.smallest = std::min(e.smallest, glm::length(extent));
    if (glm::length(extent) <= e.largest) continue;
    e.largest = glm::length(extent);
    e.direction = std::atan2(extent.y, extent.x);
  }
  return e;
}

TEST(TexelFootprint, IsThatOfFiniteDifferences) {
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    const Surface s = random_surface(random);
    const auto footprint = texel_footprint<double>(s.clip, s.map, s.point, s.normal, kWidth, kHeight, kResolution);
    const Extents e = by_differences(s);
    if (e.largest > 1e3 * e.smallest) continue;  // too thin for the sweep's steps and the differences' digits
    EXPECT_NEAR(footprint.m, e.largest, 1e-5 * e.largest) << i;
    EXPECT_NEAR(footprint.anisotropy, e.largest / e.smallest, 1e-3 * footprint.anisotropy) << i;
    EXPECT_NEAR(footprint.area, e.largest * e.smallest, 1e-3 * footprint.area) << i;
    const double turn = std::remainder(footprint.orientation - e.direction, kPi);
    if (footprint.anisotropy > 1.1) {
      EXPECT_NEAR(turn, 0, 5e-3) << i << " " << footprint.anisotropy;
    }
    EXPECT_GT(footprint.orientation, -kPi / 2 - 1e-12);
    EXPECT_LE(footprint.orientation, kPi / 2 + 1e-12);
  }
}

/// FORMULAS, section 5, with J = d(texel)/d(pixel) in so many words.
TEST(TexelFootprint, IsTheFormulasOfTheSingularValues) {
  std::mt19937 random(12);
  for (int i = 0; i < 200; ++i) {
    const Surface s = random_surface(random);
    const dvec3 n = glm::normalize(s.normal), t1 = perpendicular(n), t2 = glm::cross(n, t1);
    const auto columns = [&](const dmat4& m, const dvec2& half) {
      return glm::dmat2(detail::projected_derivative(m, s.point, t1) * half, detail::projected_derivative(m, s.point, t2) * half);
    };
    const glm::dmat2 j = columns(s.map, dvec2(kResolution / 2)) * glm::inverse(columns(s.clip, {kWidth / 2, kHeight / 2}));
    const double a = j[0][0], b = j[1][0], c = j[0][1], d = j[1][1];
    const double largest = (std::hypot(a + d, b - c) + std::hypot(a - d, b + c)) / 2,
                 smallest = std::abs(a * d - b * c) / largest;
    const auto footprint = texel_footprint<double>(s.clip, s.map, s.point, s.normal, kWidth, kHeight, kResolution);
    EXPECT_NEAR(footprint.m * smallest, 1, 1e-9);
    EXPECT_NEAR(footprint.anisotropy, largest / smallest, 1e-9 * footprint.anisotropy);
    EXPECT_NEAR(footprint.area * std::abs(a * d - b * c), 1, 1e-9);
  }
}

TEST(TexelFootprint, PointsAlongTheLightOnAGrazedGround) {
  // Seen from above, lit from low along x: texels are long along x. A surface that holds the light ray keeps its direction.
  const dmat4 clip = perspective(1.0, 1.0, 0.1, 100.0) * look_along(dvec3(0, 5, 0), dvec3(0, -1, 0), dvec3(0, 0, -1));
  for (const double height : {0.1, 0.0}) {
    const dmat4 map = perspective(0.5, 0.5, 0.1, 100.0) * look_along(dvec3(8, height, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0));
    const auto footprint = texel_footprint<double>(clip, map, dvec3(0), dvec3(0, 1, 0), 500, 500, 1000);
    EXPECT_NEAR(footprint.orientation, 0, 1e-9) << height;
    EXPECT_EQ(std::isinf(footprint.m), height == 0) << footprint.m;
  }
}

}  // namespace
}  // namespace psm
