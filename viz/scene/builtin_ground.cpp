// SPDX-License-Identifier: GPL-3.0-or-later
// A plane with posts at growing depth: the scene for which the papers derive their formulas.
// The eye stands at x = z = 0 and looks along -z; one unit is a metre.
#include <cmath>

#include "scene/builtin_scenes.h"
#include "scene/builtin_shapes.h"

namespace psm {
namespace {

enum MaterialIndex { kStripeA, kStripeB, kPost };

constexpr double kHalfWidth = 40.0, kBehind = 10.0, kAhead = 100.0, kStripe = 10.0;
constexpr double kFirstRow = 3.0, kLastRow = 96.0, kPostRadius = 0.05, kPostHeight = 2.0;
constexpr int kRows = 13;

/// Stripes ten metres deep, in turn, so that depth can be read off the ground.
void add_ground(Scene& scene) {
  Mesh stripes[2];
  for (int i = 0; i * kStripe < kAhead + kBehind; ++i) {
    const double near_z = kBehind - i * kStripe;
    shapes::append_tile(stripes[i % 2], {-kHalfWidth, near_z - kStripe}, {kHalfWidth, near_z});
  }
  stripes[0].name = "ground_even", stripes[0].material = kStripeA;
  stripes[1].name = "ground_odd", stripes[1].material = kStripeB;
  for (Mesh& mesh : stripes) scene.meshes.push_back(std::move(mesh));
}

/// Rows whose depths grow by one factor: in the image each row is that much smaller than the one before.
void add_posts(Scene& scene) {
  const Mesh post = shapes::shaded(
      shapes::lathe(shapes::Outline().to(kPostRadius, 0).to(kPostRadius, kPostHeight).to(0, kPostHeight).points(), 12), 0.8);
  for (int row = 0; row < kRows; ++row) {
    Mesh mesh;
    mesh.name = "posts_" + std::to_string(row + 1);
    mesh.material = kPost;
    const double depth = kFirstRow * std::pow(kLastRow / kFirstRow, double(row) / (kRows - 1));
    for (double x : {-4.5, -1.5, 1.5, 4.5}) {
      const auto first = std::uint32_t(mesh.positions.size());
      for (const glm::dvec3& p : post.positions) mesh.positions.push_back(p + glm::dvec3(x, 0, -depth));
      mesh.normals.insert(mesh.normals.end(), post.normals.begin(), post.normals.end());
      for (std::uint32_t i : post.triangles) mesh.triangles.push_back(first + i);
    }
    scene.meshes.push_back(std::move(mesh));
  }
}

}  // namespace

Scene make_ground() {
  Scene scene;
  scene.materials = shapes::plain_materials({0xE8E8E8u, 0xD6D6D6u, 0x8A5A3Cu});
  add_ground(scene);
  add_posts(scene);

  scene.camera =
      CameraSettings{.position = {0, 1.7, 0}, .target = {0, 1.7, -10}, .vertical_fov_deg = 60.0, .near = 1.0, .far = 100.0};

  scene.light = LightSettings{.type = LightType::directional, .to_light = {-0.7, 1.0, -0.25}};
  return scene;
}

}  // namespace psm
