// SPDX-License-Identifier: GPL-3.0-or-later
// Analysis: one plain value with every stage of an experiment named, computed by a pure function in double precision.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/convex_body.h"
#include "scene/experiment.h"
#include "scene/scene.h"

namespace psm {

/// What the eye's projection makes of the light (PSM 2002, sections 3.1 and 3.2).
enum class PostLight { directional, point, inverted_point };

struct LightCase {
  LightType world = LightType::directional;
  PostLight post = PostLight::directional;
  double w = 0.0;               // v.(l - e) for positions, v.l for directions
  glm::dvec4 light_post{0.0};   // P V l in clip space, not divided
  bool reversed_order = false;  // naive depth order along rays
  bool inside_receivers = false, inside_frustum = false;
  double kappa = 0.0;              // light_post.w / |light_post.xyz|
  bool within_half_texel = false;  // |kappa| < 1 / (2 N): directional on screen
};

/// The two-dimensional error model at n, f, phi, theta, rho (GMNPR 2007, section 2); nothing where the technique has no rho.
struct ModelError {
  double F_near = 0, F_far = 0, F_max = 0, E_max_line = 0, E_max_frustum = 0, storage_factor = 0;
};

/// The grid over the image in whose cells `visible` points are taken, one in the middle of each.
inline constexpr int kVisibleColumns = 32, kVisibleRows = 18;

/// A point that the eye sees, on a surface: world space, unit normal on the side that is seen.
struct SurfacePoint {
  glm::dvec3 position{0.0}, normal{0.0};
};

/// The texel size m in pixels over the visible points that face the light (FORMULAS: largest extent of a texel in the image).
struct TexelStatistics {
  double m_mean = 0, m_p50 = 0, m_p95 = 0, m_max = 0, undersampled_fraction = 0;  // undersampled: m > 1
  bool operator==(const TexelStatistics&) const = default;
};

struct Analysis {
  Experiment experiment;  // as resolved
  LightCase light_case;

  // What the technique used; nothing where it has none.
  std::optional<double> theta, phi;   // radians
  std::optional<double> near, far;    // eye-depth range of R
  std::optional<double> rho, lambda;  // lambda = rho / (1 - rho), infinite for the uniform map
  double camera_shift = 0.0;
  Technique technique_used = Technique::uniform;
  std::vector<Note> notes;

  // Matrices, destination from source.
  glm::dmat4 view_from_world{1.0}, clip_from_view{1.0};
  glm::dmat4 cube_from_world{1.0};           // P V with the eye moved back by camera_shift: near as it is, far grown by the shift
  std::optional<glm::dmat4> map_from_world;  // none exactly when l lies in R
  std::optional<glm::dmat4> map_beyond_from_world;  // psm_two_maps: a second map, of what is behind the eye; lit if both say so
  std::optional<std::array<glm::dmat4, 6>> cube_maps_from_world;  // then six maps: +x -x +y -y +z -z
  bool reversed_depth = false;                // psm_divided, psm_recipe with an inverted light: the farthest hit survives
  std::optional<glm::dvec4> vanishing_plane;  // c = 0, positive on R

  glm::dvec4 light{0.0};                       // homogeneous, in world space, towards the light
  ConvexBody scene_body;                       // S
  SceneBody scene_body_used = SceneBody::box;  // or hull: what S is
  ConvexBody receivers_body;                   // R = V ∩ S ∩ L
  ConvexBody caster_body;                      // H = hull(V + l) ∩ S ∩ L (PSM 2002, section 4.1)
  ConvexBody fitted_body;                      // what the map's window holds: R, or the part of it that is visible
  ConvexBody depth_body;                       // H_R = hull(fitted + l) ∩ S ∩ L: what the map's depth range holds
  std::array<glm::dvec4, 8>
      frustum_corners{};  // homogeneous, world: near then far, each (-,-) (+,-) (+,+) (-,+); far may have w = 0

  std::optional<ModelError> model_error;
  std::optional<TexelStatistics> texels;  // asked for, not implied: whoever has visible points fills it in
  bool worse_than_uniform = false;        // computed; the note says by which measure

  glm::dmat4 clip_from_world() const { return clip_from_view * view_from_world; }
};

/// Pure: same inputs, same build, same bits. Never fails on an experiment whose fields are in range. `visible`: what the
/// eye sees in the middle of each cell of a kVisibleColumns x kVisibleRows grid over the image, from whoever has it (cells that
/// see nothing are left out); without it, bodies stand in for surfaces.
Analysis analyze(const Experiment& experiment, const Scene& scene, std::span<const SurfacePoint> visible = {});

/// The contract's JSON, two-space indented; numbers round-trip, infinities are "inf" and "-inf", what does not exist is null.
std::string analysis_to_json(const Analysis& analysis, const Scene& scene);

}  // namespace psm
