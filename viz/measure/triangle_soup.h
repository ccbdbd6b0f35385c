// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that rays can meet, and the questions about one of them that both ray engines ask. Private to viz/measure.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace psm {

/// Positions are local, as on the graphics card: (world - centre of the triangles' bounds) / half the largest side. Triangles
/// with coordinates that are no finite numbers, or without area, are left out.
class TriangleSoup {
 public:
  explicit TriangleSoup(const Scene& scene);

  struct Triangle {
    glm::dvec3 a, b, c;
    std::uint32_t mesh, index;  // in the scene
    glm::dvec3 normal() const { return glm::cross(b - a, c - a); }
  };
  const std::vector<Triangle>& triangles() const { return triangles_; }
  bool has_holes() const { return !cutouts_.empty(); }

  glm::dvec3 to_local(const glm::dvec3& world) const { return (world - origin_) / unit_; }
  glm::dvec3 to_world(const glm::dvec3& local) const { return origin_ + unit_ * local; }
  glm::dvec4 light_to_local(const glm::dvec4& light) const;
  double unit() const { return unit_; }
  /// Half the sides of the bounds, which are centred at the local origin.
  const glm::dvec3& half_size() const { return half_; }

  /// Where along the ray the triangle's plane lies, kept within the depths of its corners: an edge-on triangle has no better
  /// answer.
  double distance(std::uint32_t triangle, const glm::dvec3& origin, const glm::dvec3& direction) const;

  /// Whether the point lies on one side of the triangle's plane and the light on the other, both farther than rounding explains.
  bool separates(std::uint32_t triangle, const glm::dvec3& point, const glm::dvec4& light) const;

  /// Whether alpha lies below the material's cutoff where the ray meets the triangle's plane. Textures at full resolution.
  bool hole(std::uint32_t triangle, const glm::dvec3& origin, const glm::dvec3& direction) const;

 private:
  struct Cutout {
    glm::dvec2 texcoord[3];
    double alpha[3];  // of the corners, times the material's
    double cutoff;
    int texture;  // -1: none
  };
  void add(const Scene& scene, std::uint32_t mesh, std::uint32_t index);

  glm::dvec3 origin_{0.0}, half_{0.0};
  double unit_ = 1.0, rounding_ = 0.0;
  std::vector<Triangle> triangles_;
  std::vector<Cutout> cutouts_;
  std::vector<std::int32_t> cutout_of_;  // by triangle; -1: no holes
  std::vector<Texture> textures_;        // of the scene, where any triangle has holes
};

/// What finds triangles along rays; all positions local.
class RayEngine {
 public:
  virtual ~RayEngine() = default;
  /// The nearest triangle, holes apart, at a distance in [from, to] along the direction (of any length).
  virtual std::optional<std::uint32_t> nearest(const glm::dvec3& origin, const glm::dvec3& direction, double from,
                                               double to) const = 0;
  /// Whether a triangle separates point and light (and lies between them).
  virtual bool blocked(const glm::dvec3& point, const glm::dvec4& light) const = 0;
  virtual const char* name() const = 0;
};

/// The soup must live as long as the engine.
std::unique_ptr<RayEngine> make_cgal_engine(const TriangleSoup& soup);
std::unique_ptr<RayEngine> make_embree_engine(const TriangleSoup& soup);  // only where built with Embree

}  // namespace psm
