// SPDX-License-Identifier: GPL-3.0-or-later
// load_scene: ids and paths, and the defaults of scenes that bring no camera or light.
#include <gmock/gmock.h>

#include <cmath>

#include "gltf_test_support.h"

namespace psm {
namespace {

using testing::HasSubstr;

TEST(LoadScene, BuiltInIds) {
  for (const std::string& id : builtin_scene_ids()) {
    const Result<Scene> scene = load_scene(id, "");
    ASSERT_TRUE(scene) << scene.error().text;
    EXPECT_EQ(scene->id, id);
    EXPECT_TRUE(scene->camera && scene->light && !scene->bounds.empty());
  }
}

TEST(LoadScene, PathsAreRelativeToTheBase) {
  EXPECT_TRUE(load_scene("modes.gltf", test::data_file("")));
  EXPECT_TRUE(load_scene(test::data_file("modes.gltf").string(), "/nowhere"));
}

TEST(LoadScene, WhatIsNeitherIdNorFileListsTheIds) {
  for (const char* source : {"chesboard", "", "no/such.glb"}) {
    const Result<Scene> scene = load_scene(source, "/base");
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().text, HasSubstr("chessboard"));
    EXPECT_THAT(scene.error().text, HasSubstr(std::string("\"") + source + "\""));
    EXPECT_EQ(scene.error().text.find('\n'), std::string::npos);
  }
}

TEST(LoadScene, DefaultsWhereTheFileHasNone) {
  const Result<Scene> scene = load_scene("modes.gltf", test::data_file(""));
  ASSERT_TRUE(scene) << scene.error().text;
  EXPECT_EQ(*scene->light, LightSettings{});
  EXPECT_EQ(scene->camera->vertical_fov_deg, 60.0);
}

/// A scene with one triangle that spans this box.
Scene box_scene(const glm::dvec3& min, const glm::dvec3& max) {
  Scene scene;
  scene.materials.push_back({});
  Mesh mesh;
  mesh.positions = {min, max, {min.x, max.y, min.z}};
  mesh.triangles = {0, 1, 2};
  scene.meshes.push_back(mesh);
  update_bounds(scene);
  return scene;
}

TEST(LoadScene, TheDefaultCameraSeesEverythingFromTheFrontAndAbove) {
  const test::TempFolder folder;
  const std::pair<glm::dvec3, glm::dvec3> boxes[] = {{{-1, -1, -1}, {1, 1, 1}},       {{0, 0, 0}, {100, 1, 100}},
                                                     {{0, 0, 0}, {0, 50, 0}},         {{1e6, 0, 0}, {1e6 + 1, 1, 30}},
                                                     {{0, 0, 0}, {1e-6, 2e-6, 3e-6}}, {{5, 5, 5}, {5, 5, 5}}};
  for (const auto& [min, max] : boxes) {
    ASSERT_FALSE(write_glb(box_scene(min, max), folder.path() / "box.glb"));
    const Result<Scene> scene = load_scene("box.glb", folder.path());
    ASSERT_TRUE(scene) << scene.error().text;
    const CameraSettings& camera = *scene->camera;
    const Bounds& bounds = scene->bounds;
    EXPECT_GT(camera.position.z, bounds.max.z);
    EXPECT_GT(camera.position.y, 0.5 * (bounds.min.y + bounds.max.y));
    EXPECT_NEAR(camera.near * 1000.0, camera.far, 1e-9 * camera.far);
    const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                         corner & 4 ? bounds.max.z : bounds.min.z);
      const double depth = glm::dot(p - camera.position, forward);
      EXPECT_GT(depth, camera.near);
      EXPECT_LT(depth, camera.far);
      EXPECT_LE(std::abs(glm::dot(p - camera.position, up)), depth * std::tan(glm::radians(30.0)));
      EXPECT_LE(std::abs(glm::dot(p - camera.position, right)), depth * std::tan(glm::radians(30.0)));
    }
  }
}

}  // namespace
}  // namespace psm
