// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes with known answers, built from quads, boxes and spheres.
#pragma once

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/scene.h"

namespace psm {

inline Scene empty_scene() {
  Scene scene;
  scene.id = "test";
  scene.materials.resize(1);
  return scene;
}

inline Mesh& new_mesh(Scene& scene) { return scene.meshes.emplace_back(); }

inline void add_quad(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const auto i = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
  mesh.triangles.insert(mesh.triangles.end(), {i, i + 1, i + 2, i, i + 2, i + 3});
}

/// A square of the plane y = height around the y axis, facing up.
inline void add_ground(Scene& scene, double half, double height = 0) {
  add_quad(new_mesh(scene), {-half, height, -half}, {-half, height, half}, {half, height, half}, {half, height, -half});
  update_bounds(scene);
}

inline void add_box(Scene& scene, const glm::dvec3& lo, const glm::dvec3& hi) {
  Mesh& mesh = new_mesh(scene);
  for (int k = 0; k < 3; ++k) {
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    for (const double at : {lo[k], hi[k]}) {
      glm::dvec3 p[4];
      for (int i = 0; i < 4; ++i) {
        p[i][k] = at;
        p[i][u] = i == 1 || i == 2 ? hi[u] : lo[u];
        p[i][v] = i >= 2 ? hi[v] : lo[v];
      }
      if (at == hi[k])
        add_quad(mesh, p[0], p[1], p[2], p[3]);
      else
        add_quad(mesh, p[3], p[2], p[1], p[0]);
    }
  }
  update_bounds(scene);
}

/// Inscribed; as wide as the true sphere but for radius * (1 - cos(pi / rings)).
inline void add_sphere(Scene& scene, const glm::dvec3& center, double radius, int rings) {
  Mesh& mesh = new_mesh(scene);
  const double step = glm::pi<double>() / rings;
  const auto at = [&](int ring, int segment) {
    return center + radius * glm::dvec3(std::sin(ring * step) * std::cos(segment * step), std::cos(ring * step),
                                        std::sin(ring * step) * std::sin(segment * step));
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int segment = 0; segment < 2 * rings; ++segment)
      add_quad(mesh, at(ring, segment), at(ring, segment + 1), at(ring + 1, segment + 1), at(ring + 1, segment));
  update_bounds(scene);
}

/// Everything longer by a factor: scene, camera, light.
inline void scale(Scene& scene, Experiment& x, double factor) {
  for (Mesh& mesh : scene.meshes)
    for (glm::dvec3& p : mesh.positions) p *= factor;
  update_bounds(scene);
  x.camera.position *= factor;
  x.camera.target *= factor;
  x.camera.near *= factor;
  x.camera.far *= factor;
  x.light.position *= factor;
  x.light.target *= factor;
}

}  // namespace psm
