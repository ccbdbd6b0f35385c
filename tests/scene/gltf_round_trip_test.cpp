// SPDX-License-Identifier: GPL-3.0-or-later
// What write_glb writes, read_gltf reads back: the same triangles, materials, textures, camera and light.
#include <cmath>
#include <limits>

#include "gltf_test_support.h"

namespace psm {
namespace {

using test::TempFolder;

Scene round_trip(const Scene& scene) {
  const TempFolder folder;
  const auto error = write_glb(scene, folder.path() / "scene.glb");
  EXPECT_FALSE(error) << error->text;
  return error ? Scene{} : test::read_or_fail(folder.path() / "scene.glb");
}

/// One textured triangle with every array, one mesh of lines and points, far from the origin.
Scene small_scene() {
  Scene scene;
  scene.textures.push_back({2, 1, {255, 0, 0, 255, 0, 0, 255, 40}, Wrap::mirror, Wrap::clamp, true});
  scene.materials.push_back({glm::vec4(0.8f, 0.1f, 0.3f, 0.5f), 0, 0.5f, true});
  scene.materials.push_back({});
  Mesh triangle;
  triangle.name = "triangle";
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}};
  triangle.normals.assign(3, glm::vec3(0, 0, 1));
  triangle.texcoords = {{0, 0}, {1, 0}, {0, 1}};
  triangle.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}};
  triangle.triangles = {0, 1, 2};
  Mesh wire;
  wire.name = "wire";
  wire.material = 1;
  wire.positions = {{1e9 + 0.125, 5, 5}, {1e9 + 1, 5, 5}, {1e9, 6, 5.001}};
  wire.lines = {0, 1, 1, 2};
  wire.points = {2};
  scene.meshes = {triangle, wire};
  update_bounds(scene);
  return scene;
}

std::vector<glm::dvec3> corners(const Scene& scene) {
  std::vector<glm::dvec3> out;
  for (const Mesh& mesh : scene.meshes)
    for (const auto i : mesh.triangles) out.push_back(mesh.positions[i]);
  return out;
}

void expect_close(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i) ASSERT_NEAR(a[i], b[i], tolerance);
}

TEST(GltfRoundTrip, ArraysMaterialsAndTextures) {
  const Scene scene = small_scene(), back = round_trip(scene);
  const Mesh &a = scene.meshes[0], &b = test::mesh_named(back, "triangle");
  EXPECT_EQ(b.triangles, a.triangles);
  EXPECT_EQ(b.normals, a.normals);
  EXPECT_EQ(b.texcoords, a.texcoords);
  EXPECT_EQ(b.colors, a.colors);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(glm::vec3(b.positions.at(i)), glm::vec3(a.positions[i])) << "the nearest floats";
  ASSERT_EQ(back.materials.size(), 3u) << "and glTF's default one";
  EXPECT_EQ(back.materials[0].base_color, scene.materials[0].base_color);
  EXPECT_EQ(back.materials[0].alpha_cutoff, 0.5f);
  EXPECT_TRUE(back.materials[0].double_sided);
  EXPECT_EQ(back.materials[1].alpha_cutoff, 0.0f);
  ASSERT_EQ(back.textures.size(), 1u);
  EXPECT_EQ(back.textures[0].rgba, scene.textures[0].rgba);
  EXPECT_EQ(back.textures[0].wrap_u, Wrap::mirror);
  EXPECT_EQ(back.textures[0].wrap_v, Wrap::clamp);
  EXPECT_TRUE(back.textures[0].nearest);
  EXPECT_TRUE(back.notes.empty());
}

TEST(GltfRoundTrip, LinesAndPointsFarFromTheOriginKeepTheirPlace) {
  const Scene back = round_trip(small_scene());
  std::size_t lines = 0, points = 0;
  for (const Mesh& mesh : back.meshes) {
    lines += mesh.lines.size();
    points += mesh.points.size();
  }
  EXPECT_EQ(lines, 4u);
  EXPECT_EQ(points, 1u);
  const Mesh& wire = test::mesh_named(back, "wire");
  expect_close(wire.positions.at(0), {1e9 + 0.125, 5, 5}, 1e-6);
  expect_close(wire.positions.at(2), {1e9, 6, 5.001}, 1e-6);
}

TEST(GltfRoundTrip, Cameras) {
  for (const double far : {50.0, std::numeric_limits<double>::infinity()}) {
    Scene scene = small_scene();
    scene.meshes.pop_back();
    update_bounds(scene);
    scene.camera = CameraSettings{{3, 4, 5}, {0.25, 0.1, 0}, {0, 1, 0}, 35.0, 0.01, far};
    const Scene back = round_trip(scene);
    ASSERT_TRUE(back.camera);
    expect_close(back.camera->position, scene.camera->position, 1e-12);
    expect_close(glm::normalize(back.camera->target - back.camera->position),
                 glm::normalize(scene.camera->target - scene.camera->position), 1e-12);
    EXPECT_EQ(back.camera->up, scene.camera->up);
    EXPECT_NEAR(back.camera->vertical_fov_deg, 35.0, 1e-12);
    EXPECT_EQ(back.camera->near, 0.01);
    EXPECT_EQ(back.camera->far, far);
  }
}

TEST(GltfRoundTrip, RolledCameraKeepsItsUp) {
  Scene scene = small_scene();
  scene.camera = CameraSettings{{0, 0, 5}, {0, 0, 0}, {1, 1, 0}, 60.0, 0.1, 10.0};
  const Scene back = round_trip(scene);
  ASSERT_TRUE(back.camera);
  expect_close(back.camera->up, glm::normalize(glm::dvec3(1, 1, 0)), 1e-12);
}

TEST(GltfRoundTrip, Lights) {
  Scene scene = small_scene();
  for (const glm::dvec3 to_light : {glm::dvec3(0.3, 1, 0.2), glm::dvec3(0, 1, 0), glm::dvec3(0, -2, 0)}) {
    scene.light = LightSettings{};
    scene.light->to_light = to_light;
    const Scene back = round_trip(scene);
    ASSERT_TRUE(back.light && back.light->type == LightType::directional);
    expect_close(glm::normalize(back.light->to_light), glm::normalize(to_light), 1e-12);
  }
  scene.light = LightSettings{LightType::point, {0, 1, 0}, {1, 2, 3}, {0, 0, 0}, 60};
  ASSERT_TRUE(round_trip(scene).light);
  EXPECT_EQ(round_trip(scene).light->position, glm::dvec3(1, 2, 3));
  scene.light = LightSettings{LightType::spot, {0, 1, 0}, {1, 2, 3}, {0, -1, 2}, 77};
  const Scene back = round_trip(scene);
  ASSERT_TRUE(back.light && back.light->type == LightType::spot);
  EXPECT_NEAR(back.light->cone_deg, 77, 1e-12);
  expect_close(glm::normalize(back.light->target - back.light->position), glm::normalize(glm::dvec3(-1, -3, -1)), 1e-12);
}

class BuiltIn : public testing::TestWithParam<std::string> {};

TEST_P(BuiltIn, SurvivesTheRoundTrip) {
  const Result<Scene> scene = builtin_scene(GetParam());
  ASSERT_TRUE(scene) << scene.error().text;
  const Scene back = round_trip(*scene);
  const auto a = corners(*scene), b = corners(back);
  ASSERT_EQ(a.size(), b.size());
  const double size = glm::length(scene->bounds.max - scene->bounds.min);
  for (std::size_t i = 0; i < a.size(); ++i) expect_close(a[i], b[i], 1e-7 * size);
  EXPECT_EQ(back.camera.has_value(), scene->camera.has_value());
  EXPECT_EQ(back.light.has_value(), scene->light.has_value());
  EXPECT_EQ(back.textures.size(), scene->textures.size());
}

INSTANTIATE_TEST_SUITE_P(Gltf, BuiltIn, testing::ValuesIn(builtin_scene_ids()),
                         [](const auto& test_info) { return test_info.param; });

TEST(GltfWrite, AFolderThatIsNotThereIsOneLine) {
  const auto error = write_glb(small_scene(), "/no/such/folder/scene.glb");
  ASSERT_TRUE(error);
  EXPECT_NE(error->text.find("/no/such/folder/scene.glb"), std::string::npos);
  EXPECT_EQ(error->text.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace psm
