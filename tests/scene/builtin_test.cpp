// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in scenes: whole, closed, the right way round, and seen and lit by the camera and light they bring along.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "scene/builtin_pieces.h"
#include "scene/scene.h"

namespace psm {
namespace {

using Edge = std::pair<int, int>;

Scene scene_of(const std::string& id) {
  Result<Scene> scene = builtin_scene(id);
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().text);
  return scene ? *scene : Scene{};
}

bool is_piece(const Mesh& mesh) { return mesh.name.rfind("white_", 0) == 0 || mesh.name.rfind("black_", 0) == 0; }

/// Vertices that differ only in their normal count as one.
std::vector<int> welded(const Mesh& mesh) {
  std::map<std::tuple<double, double, double>, int> index_of;
  std::vector<int> index;
  for (const glm::dvec3& p : mesh.positions)
    index.push_back(index_of.try_emplace({p.x, p.y, p.z}, int(index_of.size())).first->second);
  return index;
}

std::map<Edge, int> directed_edges(const Mesh& mesh) {
  const std::vector<int> index = welded(mesh);
  std::map<Edge, int> count;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++count[{index[mesh.triangles[i + k]], index[mesh.triangles[i + (k + 1) % 3]]}];
  return count;
}

/// Every edge belongs to two triangles, which run along it in opposite directions.
void expect_closed(const Mesh& mesh) {
  const std::map<Edge, int> edges = directed_edges(mesh);
  int wrong = 0;
  for (const auto& [edge, count] : edges) {
    const auto twin = edges.find({edge.second, edge.first});
    if (edge.first == edge.second || count != 1 || twin == edges.end() || twin->second != 1) ++wrong;
  }
  EXPECT_EQ(wrong, 0) << mesh.name << ": edges that are open, doubled or of no length, of " << edges.size();
}

/// Signed volume of each connected part.
std::vector<double> part_volumes(const Mesh& mesh) {
  const std::vector<int> index = welded(mesh);
  std::vector<int> parent(index.size());
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = int(i);
  const auto root = [&](int i) {
    while (parent[std::size_t(i)] != i) i = parent[std::size_t(i)];
    return i;
  };
  for (const auto& [edge, count] : directed_edges(mesh)) parent[std::size_t(root(edge.first))] = root(edge.second);
  std::map<int, double> volume;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.triangles[i + k]]; };
    volume[root(index[mesh.triangles[i]])] += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
  }
  std::vector<double> volumes;
  for (const auto& [part, v] : volume) volumes.push_back(v);
  return volumes;
}

class BuiltinScene : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, BuiltinScene, testing::ValuesIn(builtin_scene_ids()),
                         [](const auto& scene) { return scene.param; });

TEST_P(BuiltinScene, HasValidMeshes) {
  const Scene scene = scene_of(GetParam());
  EXPECT_EQ(scene.id, GetParam());
  ASSERT_FALSE(scene.meshes.empty());
  std::set<std::string> names;
  for (const Mesh& mesh : scene.meshes) {
    EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name << " is there twice";
    EXPECT_GE(mesh.material, 0);
    EXPECT_LT(mesh.material, int(scene.materials.size()));
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_FALSE(mesh.triangles.empty());
    EXPECT_EQ(mesh.triangles.size() % 3, 0u);
    EXPECT_LT(*std::max_element(mesh.triangles.begin(), mesh.triangles.end()), mesh.positions.size());
    for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-6f) << mesh.name;
  }
}

/// Winding and shading agree: a triangle's own normal lies on the side of its vertex normals.
TEST_P(BuiltinScene, NormalsAgreeWithTheWinding) {
  for (const Mesh& mesh : scene_of(GetParam()).meshes)
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const auto at = [&](std::size_t k) { return mesh.positions[mesh.triangles[i + k]]; };
      const glm::dvec3 cross = glm::cross(at(1) - at(0), at(2) - at(0));
      ASSERT_GT(glm::length(cross), 0.0) << mesh.name;
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_GT(glm::dot(glm::normalize(cross), glm::dvec3(mesh.normals[mesh.triangles[i + k]])), 0.3) << mesh.name;
    }
}

TEST_P(BuiltinScene, WhatIsNotFlatIsClosedAndOutward) {
  for (const Mesh& mesh : scene_of(GetParam()).meshes) {
    Bounds bounds;
    for (const glm::dvec3& p : mesh.positions) bounds.add(p);
    if (bounds.max.y == bounds.min.y) continue;
    expect_closed(mesh);
    for (double volume : part_volumes(mesh)) EXPECT_GT(volume, 0) << mesh.name;
  }
}

TEST_P(BuiltinScene, BringsACameraAndALight) {
  const Scene scene = scene_of(GetParam());
  ASSERT_TRUE(scene.camera && scene.light);
  EXPECT_GT(scene.camera->near, 0);
  EXPECT_GT(scene.camera->far, scene.camera->near);
  EXPECT_NE(scene.camera->position, scene.camera->target);
  EXPECT_GE(scene.materials.size(), 3u);
}

TEST(BuiltinScenes, UnknownIdListsTheKnownOnes) {
  const Result<Scene> scene = builtin_scene("chess");
  ASSERT_FALSE(scene);
  for (const char* part : {"\"chess\"", "chessboard", "ground"})
    EXPECT_NE(scene.error().text.find(part), std::string::npos) << part;
}

// ---- chessboard -------------------------------------------------------------------------------------------------------

TEST(Chessboard, HasAllPiecesOfAGame) {
  std::map<std::string, int> count;
  std::set<std::string> squares;
  for (const Mesh& mesh : scene_of("chessboard").meshes)
    if (is_piece(mesh)) {
      const std::size_t cut = mesh.name.rfind('_');
      ++count[mesh.name.substr(0, cut)];
      squares.insert(mesh.name.substr(cut + 1));
    }
  EXPECT_EQ(squares.size(), 32u);
  for (const std::string side : {"white_", "black_"})
    for (const auto& [name, n] :
         std::map<std::string, int>{{"pawn", 8}, {"rook", 2}, {"knight", 2}, {"bishop", 2}, {"queen", 1}, {"king", 1}})
      EXPECT_EQ(count[side + name], n) << side << name;
}

TEST(Chessboard, EveryPieceStandsInsideItsSquare) {
  for (const Mesh& mesh : scene_of("chessboard").meshes) {
    if (!is_piece(mesh)) continue;
    const double x = mesh.name[mesh.name.size() - 2] - 'a' - 3.5, z = '8' - mesh.name.back() - 3.5;
    double lowest = 1;
    for (const glm::dvec3& p : mesh.positions) {
      lowest = std::min(lowest, p.y);
      ASSERT_LT(std::max(std::abs(p.x - x), std::abs(p.z - z)), 0.5) << mesh.name;
    }
    EXPECT_EQ(lowest, 0.0) << mesh.name;
  }
}

TEST(Chessboard, SquareA1IsDarkAndTheColoursAreDistinct) {
  const Scene scene = scene_of("chessboard");
  const auto find = [&](const char* name) {
    return std::find_if(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& m) { return m.name == name; });
  };
  const auto dark = find("dark_squares"), light = find("light_squares");
  ASSERT_TRUE(dark != scene.meshes.end() && light != scene.meshes.end());
  EXPECT_EQ(dark->triangles.size(), 64u * 3);
  EXPECT_EQ(light->triangles.size(), 64u * 3);
  const auto has = [](const Mesh& m, const glm::dvec3& p) { return std::count(m.positions.begin(), m.positions.end(), p) > 0; };
  EXPECT_TRUE(has(*dark, {-4, 0, 4}));
  EXPECT_FALSE(has(*light, {-4, 0, 4}));
  const auto green = [&](const Mesh& m) { return scene.materials[std::size_t(m.material)].base_color.g; };
  EXPECT_GT(green(*light), 3 * green(*dark));
}

TEST(Chessboard, SizesAreThoseOfTheBoard) {
  const Scene scene = scene_of("chessboard");
  EXPECT_GT(scene.triangle_count(), 20000u);
  EXPECT_LT(scene.triangle_count(), 50000u);
  EXPECT_LT(scene.bounds.min.y, 0.0);
  EXPECT_GT(scene.bounds.min.y, -1.0);
  EXPECT_GT(scene.bounds.max.y, 1.5);
  EXPECT_LT(scene.bounds.max.y, 2.0);
  EXPECT_GT(scene.bounds.max.x, 8.0);
  EXPECT_EQ(scene.bounds.min.x, -scene.bounds.max.x);
}

TEST(Chessboard, TheSpotIsASpotThatCoversTheBoard) {
  const LightSettings light = *scene_of("chessboard").light;
  ASSERT_EQ(light.type, LightType::spot);
  const glm::dvec3 axis = glm::normalize(light.target - light.position);
  for (const glm::dvec3& corner : {glm::dvec3(4, 0, 4), {-4, 0, 4}, {4, 0, -4}, {-4, 0, -4}, {4, 1.8, 4}, {-4, 1.8, -4}}) {
    const glm::dvec3 to = corner - light.position;
    EXPECT_LT(std::atan2(glm::length(glm::cross(axis, to)), glm::dot(axis, to)), glm::radians(0.5 * light.cone_deg))
        << corner.x << ' ' << corner.y << ' ' << corner.z;
  }
}

/// Low over the board, most pieces in the picture, and the near ones much larger than the far ones.
TEST(Chessboard, TheCameraLooksAcrossTheBoard) {
  const Scene scene = scene_of("chessboard");
  const CameraSettings camera = *scene.camera;
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  const double limit_y = std::tan(glm::radians(0.5 * camera.vertical_fov_deg)), limit_x = limit_y * 16 / 9;
  int seen = 0;
  double nearest = 1e300, farthest = 0;
  for (const Mesh& mesh : scene.meshes) {
    if (!is_piece(mesh)) continue;
    const glm::dvec3 to = mesh.positions.front() - camera.position;
    const double depth = glm::dot(to, forward);
    if (depth < camera.near || std::abs(glm::dot(to, right)) > limit_x * depth || std::abs(glm::dot(to, up)) > limit_y * depth)
      continue;
    ++seen;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  EXPECT_GE(seen, 28);
  EXPECT_GT(farthest, 4 * nearest);
  EXPECT_LT(camera.position.y, 2.5);
}

// ---- ground -----------------------------------------------------------------------------------------------------------

TEST(Ground, PostsStandAtGrowingDepthInFrontOfTheEye) {
  const Scene scene = scene_of("ground");
  std::vector<double> depths;
  for (const Mesh& mesh : scene.meshes) {
    if (mesh.name.rfind("posts_", 0) != 0) continue;
    expect_closed(mesh);
    const std::vector<double> volumes = part_volumes(mesh);
    EXPECT_EQ(volumes.size(), 4u);
    for (double volume : volumes) EXPECT_GT(volume, 0);
    Bounds bounds;
    for (const glm::dvec3& p : mesh.positions) bounds.add(p);
    EXPECT_EQ(bounds.min.y, 0.0);
    depths.push_back(-0.5 * (bounds.min.z + bounds.max.z));
  }
  ASSERT_GE(depths.size(), 8u);
  for (std::size_t i = 1; i + 1 < depths.size(); ++i) EXPECT_NEAR(depths[i] / depths[i - 1], depths[i + 1] / depths[i], 1e-9);
  EXPECT_GT(depths.front(), scene.camera->near);
  EXPECT_LT(depths.back(), scene.camera->far);
  EXPECT_GT(depths.back(), 20 * depths.front());
}

TEST(Ground, TheEyeLooksAlongThePlaneAndTheSunIsUp) {
  const Scene scene = scene_of("ground");
  EXPECT_EQ(scene.camera->position, glm::dvec3(0, 1.7, 0));
  const glm::dvec3 forward = scene.camera->target - scene.camera->position;
  EXPECT_EQ(forward.x, 0.0);
  EXPECT_EQ(forward.y, 0.0);
  EXPECT_LT(forward.z, 0.0);
  EXPECT_EQ(scene.light->type, LightType::directional);
  EXPECT_GT(scene.light->to_light.y, 0.0);
}

/// The plane is flat at y = 0 and gap-free; only the posts give the box its height.
TEST(Ground, ThePlaneIsWholeAndTheBoxHasHeight) {
  const Scene scene = scene_of("ground");
  double area = 0;
  for (const Mesh& mesh : scene.meshes) {
    if (mesh.name.rfind("ground_", 0) != 0) continue;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const auto at = [&](std::size_t k) { return mesh.positions[mesh.triangles[i + k]]; };
      EXPECT_EQ(at(0).y, 0.0);
      area += 0.5 * glm::cross(at(1) - at(0), at(2) - at(0)).y;
    }
  }
  const glm::dvec3 size = scene.bounds.max - scene.bounds.min;
  EXPECT_NEAR(area, size.x * size.z, 1e-9 * area);
  EXPECT_EQ(scene.bounds.min.y, 0.0);
  EXPECT_GT(size.y, 1.0);
}

// ---- ball, robots, ceiling ------------------------------------------------------------------------------------------------

TEST(Ball, FloatsOverThePlane) {
  const Scene scene = scene_of("ball");
  for (const Mesh& mesh : scene.meshes)
    for (const glm::dvec3& p : mesh.positions) EXPECT_TRUE(mesh.name == "ball" ? p.y > 0.5 : p.y == 0.0) << mesh.name;
  EXPECT_LT(scene.triangle_count(), 2000u);
}

TEST(Robots, AreAboutAsManyTrianglesAsInThePaperAndStandOnTheGround) {
  const Scene scene = scene_of("robots");
  EXPECT_NEAR(double(scene.triangle_count()), 11000, 500);
  std::map<std::string, double> lowest;
  for (const Mesh& mesh : scene.meshes)
    if (mesh.name.starts_with("robot_"))
      for (const glm::dvec3& p : mesh.positions) {
        double& y = lowest.try_emplace(mesh.name.substr(0, 7), p.y).first->second;
        y = std::min(y, p.y);
      }
  EXPECT_EQ(lowest.size(), 4u);
  for (const auto& [robot, y] : lowest) EXPECT_NEAR(y, 0.0, 1e-12) << robot;
}

TEST(Ceiling, IsAboutAsManyTrianglesAsInThePaperAndOverheadForTheMostPart) {
  const Scene scene = scene_of("ceiling");
  EXPECT_NEAR(double(scene.triangle_count()), 23000, 1000);
  std::size_t above = 0;
  for (const Mesh& mesh : scene.meshes)
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
      above += mesh.positions[mesh.triangles[i]].y > scene.camera->position.y + 3;
  EXPECT_GT(above, scene.triangle_count() / 2);
}

// ---- shapes -----------------------------------------------------------------------------------------------------------

TEST(Shapes, ALathedCylinderHasTheVolumeOfItsPrism) {
  const shapes::Solid solid = shapes::lathe(shapes::Outline().to(2, 0).to(2, 3).to(0, 3).points(), 64);
  EXPECT_NEAR(shapes::signed_volume(solid), 3 * 0.5 * 64 * 4 * std::sin(2 * M_PI / 64), 1e-12);
}

TEST(Shapes, ABallOutlineClosesOnTheAxis) {
  const shapes::Outline outline = shapes::Outline().to(0.5, 0).ball(1.0, 8);
  EXPECT_EQ(outline.points().back().x, 0.0);
  EXPECT_NEAR(outline.height(), 1 + std::sqrt(0.75), 1e-12);
  for (std::size_t i = 2; i < outline.points().size(); ++i)
    EXPECT_NEAR(glm::length(outline.points()[i] - glm::dvec2(0, std::sqrt(0.75))), 1.0, 1e-12);
}

TEST(Shapes, CreasesAreSharpAndCurvesAreSmooth) {
  const shapes::Solid cylinder = shapes::lathe(shapes::Outline().to(1, 0).to(1, 1).to(0, 1).points(), 12);
  const Mesh mesh = shapes::shaded(cylinder, 0.8);
  // Two poles, and each of the 24 rim points once for the side and once for its disc.
  EXPECT_EQ(mesh.positions.size(), 2u + 2 * 24);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 n = mesh.normals[i];
    const bool side = std::abs(n.y) < 1e-6f;
    EXPECT_TRUE(side || std::abs(std::abs(n.y) - 1) < 1e-6f);
    if (side) {
      EXPECT_NEAR(glm::dot(glm::dvec3(n), mesh.positions[i] * glm::dvec3(1, 0, 1)), 1.0, 1e-6);
    }
  }
  EXPECT_EQ(shapes::shaded(cylinder, 3.0).positions.size(), 26u);
}

TEST(Shapes, SrgbBecomesLinear) {
  const glm::vec4 colour = shapes::linear_from_srgb(0xFF8000);
  EXPECT_FLOAT_EQ(colour.r, 1.0f);
  EXPECT_NEAR(colour.g, 0.21586f, 1e-5f);
  EXPECT_FLOAT_EQ(colour.b, 0.0f);
  EXPECT_FLOAT_EQ(colour.a, 1.0f);
}

}  // namespace
}  // namespace psm
