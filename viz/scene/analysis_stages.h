// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages of analyze() hand on to each other; private to viz/scene.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

#include "geom/frustum.h"
#include "math/shadow_map.h"
#include "scene/analysis.h"
#include "scene/eye_and_light.h"

namespace psm {

inline void note(Analysis& a, std::string code, std::string text, std::optional<double> value = {},
                 std::optional<double> limit = {}) {
  a.notes.push_back({std::move(code), std::move(text), value, limit});
}

/// What the stages hand on; the Analysis keeps what is worth showing.
struct Stages {
  const Experiment& x;
  const Scene& scene;
  ViewFrame view = {};
  std::vector<Plane> view_planes = {}, view_hull = {};  // of V, of hull(V + l)
  ConvexBody lit_scene = {};                            // S ∩ L
  glm::dvec4 light{0};                                  // unit direction and 0, or position and 1
  glm::dvec3 centroid{0};                               // of R
  double near = 1, far = 2;                             // depth range that the technique uses
  LightFrame<double> frame = {};
  glm::dvec4 uniform{0};
  std::vector<SurfacePoint> served = {};                    // visible points that face the light; empty where nobody gave any
  bool light_in_scene = false, light_in_receivers = false;  // a position inside S, inside R
};

/// Of planes all of which hold the point. Closed, and exact: a light on a face is inside.
inline bool contains(std::span<const Plane> planes, const glm::dvec4& point) {
  return std::all_of(planes.begin(), planes.end(), [&](const Plane& p) { return exact_side(p, point) >= 0; });
}

/// S and what the light's planes and the camera's leave of it.
struct SceneBodies {
  ConvexBody scene, lit, receivers;  // S, S ∩ L, R
  std::vector<Plane> light_planes;
  double light_near = 0;  // where a spot's cone starts
};

/// In the grain that the experiment asks for or the scene needs.
SceneBodies scene_bodies(const Stages& s, Analysis& a);

/// The vanishing plane that a technique chooses; sets technique_used and everything the technique has to say.
glm::dvec4 technique_plane(Technique technique, Stages& s, Analysis& a, std::span<const glm::dvec3> receivers);

/// plane_optimal (Chong and Gortler 2004): c = (G.l) K - (K.l) G for the receiver plane G and the camera plane K, so that all
/// texels on that receiver have the same size in the image.
glm::dvec4 plane_of_receiver(Stages& s, Analysis& a, std::span<const glm::dvec3> receivers);

/// best_plane: the plane with the smallest 95th percentile of m over the points, found by search from the planes of all
/// techniques.
glm::dvec4 best_plane(Stages& s, Analysis& a, std::span<const glm::dvec3> receivers);

/// The mappings that break the rule (psm_divided, psm_recipe), whole; nothing for every other technique.
std::optional<glm::dmat4> rule_breaking_map(Stages& s, Analysis& a, std::span<const glm::dvec3> receivers);

}  // namespace psm
