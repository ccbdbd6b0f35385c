// SPDX-License-Identifier: GPL-3.0-or-later
// Normals that are smooth where the surface is, and sharp at its edges.
#include <cmath>
#include <map>
#include <utility>

#include "scene/builtin_shapes.h"

namespace psm::shapes {
namespace {

/// Disjoint sets of triangle corners; those of one set share a normal.
class CornerSets {
 public:
  explicit CornerSets(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

glm::dvec3 face_normal(const Solid& solid, std::size_t triangle) {
  const auto corner = [&](std::size_t k) { return solid.positions[solid.triangles[3 * triangle + k]]; };
  return glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
}

/// Interior angle at a corner: the weight that makes a vertex normal independent of how its faces are cut into triangles.
double corner_angle(const Solid& solid, std::size_t corner) {
  const std::size_t first = corner - corner % 3;
  const auto at = [&](std::size_t c) { return solid.positions[solid.triangles[first + c % 3]]; };
  const glm::dvec3 a = at(corner % 3 + 1) - at(corner % 3), b = at(corner % 3 + 2) - at(corner % 3);
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Joins the corners at both ends of every edge that bends by less than `crease`.
CornerSets smooth_sets(const Solid& solid, const std::vector<glm::dvec3>& faces, double crease) {
  CornerSets sets(solid.triangles.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> corner_of_edge;  // the corner at which a half-edge starts
  const auto next = [](std::size_t c) { return c - c % 3 + (c + 1) % 3; };
  for (std::size_t c = 0; c < solid.triangles.size(); ++c) corner_of_edge[{solid.triangles[c], solid.triangles[next(c)]}] = c;
  for (std::size_t c = 0; c < solid.triangles.size(); ++c) {
    const auto twin = corner_of_edge.find({solid.triangles[next(c)], solid.triangles[c]});
    if (twin == corner_of_edge.end() || glm::dot(faces[c / 3], faces[twin->second / 3]) < std::cos(crease)) continue;
    sets.join(c, next(twin->second));
    sets.join(next(c), twin->second);
  }
  return sets;
}

}  // namespace

Mesh shaded(const Solid& solid, double crease) {
  std::vector<glm::dvec3> faces(solid.triangles.size() / 3);
  for (std::size_t t = 0; t < faces.size(); ++t) faces[t] = face_normal(solid, t);
  CornerSets sets = smooth_sets(solid, faces, crease);

  std::vector<glm::dvec3> sums(solid.triangles.size(), glm::dvec3(0.0));
  for (std::size_t c = 0; c < sums.size(); ++c) sums[sets.find(c)] += corner_angle(solid, c) * faces[c / 3];

  Mesh mesh;
  std::map<std::size_t, std::uint32_t> vertex_of_set;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const auto [vertex, is_new] = vertex_of_set.try_emplace(sets.find(c), std::uint32_t(mesh.positions.size()));
    if (is_new) {
      mesh.positions.push_back(solid.positions[solid.triangles[c]]);
      mesh.normals.push_back(glm::vec3(glm::normalize(sums[vertex->first])));
    }
    mesh.triangles.push_back(vertex->second);
  }
  return mesh;
}

}  // namespace psm::shapes
