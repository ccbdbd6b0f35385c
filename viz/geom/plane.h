// SPDX-License-Identifier: GPL-3.0-or-later
// Half-spaces that know their exact value: what was rounded on the way to the four doubles can be had exactly when a sign hangs
// on it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>

namespace psm {

/// What a plane bounds, for whoever shows where a facet comes from.
enum class PlaneId : std::uint8_t {
  given,
  left,  // sides of a frustum or of a spot's pyramid, seen from its apex
  right,
  bottom,
  top,
  near,
  far,
  min_x,  // sides of a box
  max_x,
  min_y,
  max_y,
  min_z,
  max_z,
  hull,       // a facet of a hull of points
  infinity,   // (0, 0, 0, 1): all of space lies inside
  silhouette  // through the light and an edge
};

struct SilhouetteOf;

/// A half-space p.x >= 0 with x = (x, y, z, 1); p.xyz is the inward normal, of any length. The vector holds the plane rounded to
/// doubles. Exactly it is either  xyz.(x - anchor) + offset  or, where `edge` is set, (p_i.l) p_j - (p_j.l) p_i.
/// Make a new plane rather than writing into one.
struct Plane : glm::dvec4 {
  glm::dvec3 anchor{0.0};
  double offset = 0.0;
  PlaneId id = PlaneId::given;
  bool of_light = false;  // bounds the light's volume L rather than the camera's V
  std::shared_ptr<const SilhouetteOf> edge;

  Plane() : glm::dvec4(0.0) {}
  Plane(double nx, double ny, double nz, double distance, PlaneId plane_id = PlaneId::given)
      : glm::dvec4(nx, ny, nz, distance), offset(distance), id(plane_id) {}
  Plane(const glm::dvec3& normal, double distance) : Plane(normal.x, normal.y, normal.z, distance) {}
  Plane(const glm::dvec4& v) : Plane(v.x, v.y, v.z, v.w) {}

  /// normal.(x - point) + distance >= 0, exactly.
  static Plane through(const glm::dvec3& normal, const glm::dvec3& point, double distance = 0.0,
                       PlaneId plane_id = PlaneId::given);
  /// The plane through the light and the edge of `kept` (kept.l > 0) and `dropped` (dropped.l < 0).
  static Plane silhouette(const Plane& kept, const Plane& dropped, const glm::dvec4& light);
};

struct SilhouetteOf {
  Plane kept, dropped;
  glm::dvec4 light;
};

/// `same_definition` for planes whose rounded coefficients are equal.
bool same_exact_definition(const Plane& p, const Plane& q);

/// The same half-space by its exact definition; false for one that happens to have the same points.
inline bool same_definition(const Plane& p, const Plane& q) {
  return p.x == q.x && p.y == q.y && p.z == q.z && p.w == q.w && same_exact_definition(p, q);
}

/// In words: "V left", "S max y", "L top", "light and the edge of V near and V left".
std::string describe(const Plane& plane);

/// Sign of p.l, exact.
int exact_side(const Plane& p, const glm::dvec4& light);

}  // namespace psm
