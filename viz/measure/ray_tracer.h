// SPDX-License-Identifier: GPL-3.0-or-later
// Rays against a scene's triangles: the nearest one, or any. The same triangles as the shadow map draws (all faces, whichever way
// they look; fragments below a texture's alpha cutoff are holes; lines and points are nothing).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "scene/analysis.h"
#include "scene/scene.h"

namespace psm {

/// Built once per scene, which it does not need afterwards; then any thread may ask. Distances are reckoned in double on the
/// scene's own triangles; Embree's floats, which only say which triangle is met, are relative to the scene's bounds.
class RayTracer {
 public:
  enum class Engine { embree, cgal };
  /// Embree where this was built with it.
  static Engine default_engine();

  explicit RayTracer(const Scene& scene, Engine engine = default_engine());
  ~RayTracer();
  RayTracer(RayTracer&&) noexcept;
  RayTracer& operator=(RayTracer&&) noexcept;

  struct Hit {
    double distance = 0;                   // along `direction`, in its lengths
    SurfacePoint point;                    // normal: the triangle's own, on the side of the ray's origin
    std::uint32_t mesh = 0, triangle = 0;  // index into Scene::meshes, and of the triangle in it
  };
  /// World space, `direction` of any length but zero, hits at distances in [from, to].
  std::optional<Hit> nearest(const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) const;

  /// Whether anything but the surface itself lies between the point, as `nearest` found it, and the light (homogeneous, towards
  /// the light). A triangle counts if point and light lie on either side of its plane, farther from it than rounding in double
  /// can account for: no surface shadows itself or what continues it in its plane, however low the light stands.
  bool shadowed(const SurfacePoint& point, const glm::dvec4& light) const;

  /// "Embree 3.13.5" or "CGAL 5.5.1 AABB tree".
  const char* engine() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace psm
