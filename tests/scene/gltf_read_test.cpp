// SPDX-License-Identifier: GPL-3.0-or-later
// What each part of glTF 2.0 becomes, on the small files of data/.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "gltf_test_support.h"

namespace psm {
namespace {

using test::data_file, test::mesh_named, test::note_of, test::read_or_fail;
using testing::ElementsAre, testing::HasSubstr;

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

TEST(GltfModes, EachModeAndIndexType) {
  const Scene scene = read_or_fail(data_file("modes.gltf"));
  ASSERT_EQ(scene.meshes.size(), 7u);
  EXPECT_EQ(scene.id, "modes.gltf");
  EXPECT_THAT(mesh_named(scene, "points").points, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(mesh_named(scene, "lines").lines, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(mesh_named(scene, "loop").lines, ElementsAre(0, 1, 1, 2, 2, 3, 3, 0));
  EXPECT_THAT(mesh_named(scene, "line strip").lines, ElementsAre(0, 1, 1, 2, 2, 3));
  for (const char* name : {"triangles", "strip", "fan"}) {
    const Mesh& mesh = mesh_named(scene, name);
    EXPECT_EQ(mesh.triangles.size(), 6u) << name;
    expect_near(test::area_vector(mesh), {0, 0, 1});
    EXPECT_EQ(mesh.positions.size(), 6u) << "flat normals split vertices: " << name;
    for (const auto& n : mesh.normals) expect_near(n, {0, 0, 1});
  }
  EXPECT_EQ(scene.triangle_count(), 6u);
  EXPECT_TRUE(mesh_named(scene, "points").normals.empty());
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_FALSE(scene.camera || scene.light);
}

TEST(GltfPacked, NormalisedIntegers) {
  const Scene scene = read_or_fail(data_file("packed.gltf"));
  const Mesh& mesh = mesh_named(scene, "normalised");
  ASSERT_EQ(mesh.positions.size(), 4u);
  expect_near(mesh.positions[0], {-2, -2, 0});
  expect_near(mesh.positions[2], {2, 2, 0});
  expect_near(mesh.normals[3], {0, 0, 1});
  EXPECT_NEAR(mesh.texcoords[1].x, 1.0f, 1e-6f);
  EXPECT_NEAR(mesh.colors[3].g, 0.4f, 1e-6f);
  EXPECT_EQ(mesh.colors[3].a, 1.0f) << "three components: opaque";
}

TEST(GltfPacked, QuantisedIntegers) {
  const Scene scene = read_or_fail(data_file("packed.gltf"));
  const Mesh& mesh = mesh_named(scene, "plain");
  ASSERT_EQ(mesh.positions.size(), 4u);
  expect_near(mesh.positions[2], {2, 1, 0});
  EXPECT_NEAR(mesh.colors[3].a, 0.2f, 1e-4f);
}

TEST(GltfPacked, SparseAndInterleaved) {
  const Scene scene = read_or_fail(data_file("packed.gltf"));
  const Mesh& sparse = mesh_named(scene, "sparse");
  ASSERT_EQ(sparse.triangles.size(), 6u);
  expect_near(test::corner(sparse, 0, 1), {1, 0, 0});
  expect_near(test::corner(sparse, 0, 2), {5, 5, 5});
  const Mesh& zeros = mesh_named(scene, "zeros");
  expect_near(test::corner(zeros, 0, 0), {0, 0, 0});
  expect_near(test::corner(zeros, 0, 2), {0, 4, 0});
  const Mesh& interleaved = mesh_named(scene, "interleaved");
  ASSERT_EQ(interleaved.positions.size(), 4u);
  expect_near(interleaved.positions[3], {0, 1, 0});
  expect_near(interleaved.normals[3], {0, 0, 1});
}

TEST(GltfTextured, ImagesFromAllPlaces) {
  const Scene scene = read_or_fail(data_file("textured.gltf"));
  ASSERT_EQ(scene.materials.size(), 6u) << "five and the default one";
  const Material& file = scene.materials[0];
  ASSERT_GE(file.texture, 0);
  const Texture& checker = scene.textures[std::size_t(file.texture)];
  EXPECT_EQ(checker.width, 2);
  EXPECT_THAT(std::vector<int>(checker.rgba.begin(), checker.rgba.begin() + 8), ElementsAre(255, 0, 0, 255, 0, 255, 0, 0));
  EXPECT_EQ(checker.wrap_u, Wrap::clamp);
  EXPECT_EQ(checker.wrap_v, Wrap::mirror);
  EXPECT_TRUE(checker.nearest);
  EXPECT_FLOAT_EQ(file.alpha_cutoff, 0.25f);
  EXPECT_TRUE(file.double_sided);
  const Texture& embedded = scene.textures.at(std::size_t(scene.materials[1].texture));
  EXPECT_EQ(embedded.height, 2);
  EXPECT_EQ(int(embedded.rgba[4]), 5);
  EXPECT_EQ(int(scene.textures.at(std::size_t(scene.materials[2].texture)).rgba[0]), 9);
}

TEST(GltfTextured, ABrokenImageCostsItsTextureOnly) {
  const Scene scene = read_or_fail(data_file("textured.gltf"));
  EXPECT_EQ(scene.materials.at(3).texture, -1);
  const Note* note = note_of(scene, "gltf_image");
  ASSERT_TRUE(note);
  EXPECT_THAT(note->text, HasSubstr("images[3]"));
}

TEST(GltfTextured, OneImageWithTwoSamplersIsTwoTextures) {
  const Scene scene = read_or_fail(data_file("textured.gltf"));
  const int first = scene.materials[0].texture, again = scene.materials[4].texture;
  ASSERT_NE(first, again);
  EXPECT_EQ(scene.textures[std::size_t(first)].rgba, scene.textures[std::size_t(again)].rgba);
  EXPECT_EQ(scene.textures[std::size_t(again)].wrap_u, Wrap::repeat);
}

TEST(GltfTextured, TextureTransformIsBakedIn) {
  const Scene scene = read_or_fail(data_file("textured.gltf"));
  const Mesh& mesh = mesh_named(scene, "transformed");
  ASSERT_EQ(mesh.texcoords.size(), 6u);
  // Scale (2, 3), a quarter turn counter-clockwise to the eye (u to -v, v to u), offset (0.5, 0.25); set 1.
  EXPECT_NEAR(mesh.texcoords[0].x, 0.5f, 1e-6f);
  EXPECT_NEAR(mesh.texcoords[0].y, 0.25f, 1e-6f);
  EXPECT_NEAR(mesh.texcoords[1].x, 0.5f, 1e-6f);
  EXPECT_NEAR(mesh.texcoords[1].y, 0.25f - 2.0f, 1e-6f);
  EXPECT_NEAR(mesh.texcoords[2].x, 3.5f, 1e-6f);
  EXPECT_NEAR(mesh.texcoords[2].y, 0.25f - 2.0f, 1e-6f);
  EXPECT_FLOAT_EQ(scene.materials[4].base_color.g, 0.25f);
}

TEST(GltfPosed, SkinsStandAsTheirJointsDo) {
  const Scene scene = read_or_fail(data_file("posed.gltf"));
  const Mesh& strip = mesh_named(scene, "strip");
  Bounds bounds;
  for (const auto& p : strip.positions) bounds.add(p);
  // Below untouched, above moved by the upper joint's (0, 0, 2), between half; the node's own (100, 100, 100) does not count.
  expect_near(bounds.min, {0, 0, 0});
  expect_near(bounds.max, {1, 2, 2});
  for (const auto& p : strip.positions) EXPECT_NEAR(p.z, p.y, 1e-6);
  EXPECT_TRUE(note_of(scene, "gltf_skin"));
}

TEST(GltfPosed, MorphTargetsAreLeftOutWithANote) {
  const Scene scene = read_or_fail(data_file("posed.gltf"));
  for (const auto& p : mesh_named(scene, "morphed").positions) EXPECT_EQ(p.z, 0.0);
  EXPECT_TRUE(note_of(scene, "gltf_morph"));
}

TEST(GltfLit, TransformationsInDoubleAndMirrored) {
  const Scene scene = read_or_fail(data_file("lit.gltf"));
  const Mesh& mirrored = mesh_named(scene, "mirrored");
  // x mirrored, then y to z, then far away: 0.25 survives beside 1e9, and the front still shows where the normal says.
  Bounds bounds;
  for (const auto& p : mirrored.positions) bounds.add(p);
  expect_near(bounds.min, {1e9 - 1.0, 0.25, 3.0}, 1e-6);
  expect_near(bounds.max, {1e9, 0.25, 4.0}, 1e-6);
  expect_near(test::area_vector(mirrored), {0, -1, 0}, 1e-6);
  expect_near(mirrored.normals.at(0), {0, -1, 0});
  const Mesh& matrix = mesh_named(scene, "matrix");
  expect_near(test::area_vector(matrix), {0, 0, 4}, 1e-5);
}

TEST(GltfLit, FirstPerspectiveCamera) {
  const Scene scene = read_or_fail(data_file("lit.gltf"));
  ASSERT_TRUE(scene.camera);
  expect_near(scene.camera->position, {1e9, 2, 10});
  EXPECT_NEAR(scene.camera->vertical_fov_deg, 45.0, 1e-9);
  EXPECT_EQ(scene.camera->near, 0.5);
  EXPECT_EQ(scene.camera->far, std::numeric_limits<double>::infinity());
  EXPECT_EQ(scene.camera->up, glm::dvec3(0, 1, 0));
  const glm::dvec3 view = scene.camera->target - scene.camera->position;
  expect_near(glm::normalize(view), {0, 0, -1});
  const double middle = 0.5 * (scene.bounds.min.z + scene.bounds.max.z);
  EXPECT_NEAR(scene.camera->target.z, middle, 1e-6) << "aims at the depth of the scene's middle";
  EXPECT_TRUE(note_of(scene, "gltf_orthographic"));
}

TEST(GltfLit, FirstLightIsASpot) {
  const Scene scene = read_or_fail(data_file("lit.gltf"));
  ASSERT_TRUE(scene.light);
  EXPECT_EQ(scene.light->type, LightType::spot);
  expect_near(scene.light->position, {1e9, 8, 0});
  EXPECT_NEAR(scene.light->cone_deg, 2 * 0.5 * 180 / M_PI, 1e-9) << "the full apex angle";
  const glm::dvec3 axis = scene.light->target - scene.light->position;
  expect_near(axis / glm::length(axis), {0, -1, 0});
  EXPECT_TRUE(note_of(scene, "gltf_light"));
}

TEST(GltfScene, TheDefaultSceneAndAllRootsWithoutScenes) {
  const test::TempFolder folder;
  folder.write("modes buffer.bin", test::bytes_of(data_file("modes buffer.bin")));
  nlohmann::json doc = nlohmann::json::parse(test::bytes_of(data_file("modes.gltf")));
  const auto read = [&] { return read_or_fail(folder.write("scenes.gltf", doc.dump())); };
  doc["scenes"] = {{{"nodes", {0}}}, {{"nodes", {5, 4}}}};
  EXPECT_EQ(read().meshes.at(0).name, "points");
  doc["scene"] = 1;
  ASSERT_EQ(read().meshes.size(), 2u);
  EXPECT_EQ(read().meshes.at(0).name, "strip") << "in the order of the scene";
  doc.erase("scene");
  EXPECT_EQ(read().meshes.at(0).name, "points") << "the first where none is chosen";
  doc.erase("scenes");
  EXPECT_EQ(read().meshes.size(), 7u) << "all roots";
}

}  // namespace
}  // namespace psm
