// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/closed_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace psm {
namespace {

/// A box with its own four corners for each face, as flat shading wants them; seen from outside.
Mesh box(const glm::dvec3& at, double size) {
  Mesh mesh;
  const auto face = [&](glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v) {
    const std::uint32_t first = std::uint32_t(mesh.positions.size());
    for (const glm::dvec3& p : {corner, corner + u, corner + u + v, corner + v}) mesh.positions.push_back(at + size * p);
    for (std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.triangles.push_back(first + i);
  };
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), o(0);
  face(o, y, x), face(z, x, y), face(o, z, y), face(x, y, z), face(o, x, z), face(y, z, x);
  return mesh;
}

Mesh joined(Mesh a, const Mesh& b) {
  const std::uint32_t first = std::uint32_t(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (std::uint32_t i : b.triangles) a.triangles.push_back(first + i);
  return a;
}

Mesh turned_inside_out(Mesh mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) std::swap(mesh.triangles[t], mesh.triangles[t + 1]);
  return mesh;
}

TEST(ClosedMesh, ABoxIsClosedWhereverItStands) {
  EXPECT_TRUE(is_closed(box(glm::dvec3(0), 1)));
  EXPECT_TRUE(is_closed(box(glm::dvec3(1e6, -3, 7), 1e-3)));
  EXPECT_TRUE(is_closed(joined(box(glm::dvec3(0), 1), box(glm::dvec3(5), 2))));
}

TEST(ClosedMesh, WhatOneCanLookIntoIsNot) {
  Mesh open = box(glm::dvec3(0), 1);
  open.triangles.resize(open.triangles.size() - 3);
  EXPECT_FALSE(is_closed(open));
  EXPECT_FALSE(is_closed(Mesh{}));
  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {0, 1, 2};
  EXPECT_FALSE(is_closed(flat));
  flat.triangles = {0, 1, 2, 0, 2, 1};  // both sides of a sheet: no volume
  EXPECT_FALSE(is_closed(flat));
}

TEST(ClosedMesh, ASurfaceSeenFromInsideIsNot) {
  const Mesh room = turned_inside_out(box(glm::dvec3(0), 1));
  EXPECT_FALSE(is_closed(room));
  EXPECT_FALSE(is_closed(joined(box(glm::dvec3(5), 10), room))) << "one piece of two";
}

TEST(ClosedMesh, AFaceThatIsTurnedRoundOpensIt) {
  Mesh mesh = box(glm::dvec3(0), 1);
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  EXPECT_FALSE(is_closed(mesh));
}

}  // namespace
}  // namespace psm
