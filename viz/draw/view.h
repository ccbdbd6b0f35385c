// SPDX-License-Identifier: GPL-3.0-or-later
// What each view shows, as plain data: a picture of the scene, a clip matrix, and a DrawList over it.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "draw/chart.h"
#include "draw/draw_list.h"
#include "draw/emphasis.h"
#include "draw/image.h"
#include "draw/legend.h"
#include "scene/analysis.h"

namespace psm {

enum class ScenePicture {
  none,        // the list alone
  shadowed,    // lit, with shadows from the map
  projective,  // the same, after a projective map of the world: drawn twice, the second time negated, so that both sides of w = 0
               // appear
  map_depth    // the shadow map's depth, as an image in the square [-1, 1]^2 of map clip space
};

/// Of the texel grid's lines, every how many are drawn stronger.
constexpr int kStrongLines = 8;

/// What shows of a picture, in fractions of its size: beside another one, or under something else. Labels stand in the free part.
struct ShownPart {
  glm::dvec2 columns{0.0, 1.0};   // from, to
  std::vector<Occupied> covered;  // y downwards
  bool divided() const { return columns != glm::dvec2(0.0, 1.0); }
  bool operator==(const ShownPart&) const = default;
};

/// One view, ready to draw. The world list has one DrawPoint of role light (the light's handle; a sun stands at the picture's
/// edge), one of role frustum (the eye), and one of role vanishing_plane where that shows. Corner [-1, 1]^2 of clip space is the
/// whole picture.
struct ViewPicture {
  ViewId id = ViewId::world;
  std::string title;  // "World", "Unit cube", "Shadow map 1024 x 1024", "Eye"
  ScenePicture scene = ScenePicture::shadowed;
  glm::dmat4 clip_from_world{1.0};  // for the scene's triangles (not used by map_depth)
  glm::dmat4 cube_from_world{1.0};  // projective only: fragments outside limit * [-1, 1]^3 of the cube are faded out
  double cube_limit = 3.0;
  glm::dmat4 clip_from_list{1.0};  // for the list
  DrawList list;
  /// The part of the picture that the eye's image occupies (the eye view letterboxes), in clip space: min x, min y, max x, max y.
  glm::dvec4 image_rect{-1.0, -1.0, 1.0, 1.0};
  EyeOverlay overlay = EyeOverlay::none;  // a heat map (texel_size, anisotropy) instead of the lit scene
  int texel_step = 0;                     // the texel grid over the scene: a line every so many texels; 0: none
  std::optional<ChartFrame> chart;        // of a plot: where values stand in the list's space
  std::optional<Image> cover;             // over the scene, spread over image_rect
  Legend legend;
  ShownPart shown;
};

/// Errors against the truth, penumbra: viz/gl traces them.
bool takes_rays(EyeOverlay overlay);

/// An overlay that took rays: the eye's image, opaque where it sees something, and what its colours mean.
struct TracedOverlay {
  Image image;
  Legend legend;
};

struct Probe;  // draw/probe.h

/// What a view shows besides its experiment. Nothing here is kept.
struct ViewExtras {
  Emphasis emphasis = {};
  const Probe* probe = nullptr;           // neither stronger nor fainter, but without what is hidden
  const TracedOverlay* traced = nullptr;  // in the eye view; none where one takes rays: its legend says that they are to come
  ShownPart shown = {};  // of a divided picture the legend keeps its colours alone: half of its numbers would be left
};

/// Pure. `size` in pixels: its aspect decides the letterbox and the fit. `scale`: of type, for which plots leave room.
ViewPicture describe_view(ViewId id, const Analysis& analysis, glm::ivec2 size, double scale = 1.0,
                          const ViewExtras& extras = {});

/// The plane that the world view shows: the one in use, or technique custom's own where that could not be used.
std::optional<glm::dvec4> shown_vanishing_plane(const Analysis& analysis);

/// Where an orbit looks from: the camera's view matrix and the perspective of a view of this aspect. `extent_min`, `extent_max`:
/// the box that distance 0 fits. With distance 0 and target 0 (both unset) it turns around the middle of that box; who then zooms
/// or pans stores the resolved `target` and `distance` first.
struct OrbitCamera {
  glm::dmat4 view_from_space{1.0}, clip_from_view{1.0};
  glm::dvec3 eye{0.0}, target{0.0};
  double distance = 1.0;  // eye and target as resolved
};
OrbitCamera orbit_camera(const OrbitSettings& orbit, const glm::dvec3& extent_min, const glm::dvec3& extent_max, double aspect);

/// What distance 0 fits: for the world view the scene with the camera and a position light; for the cube view the cube; for the
/// body view H.
void view_extent(ViewId id, const Analysis& analysis, glm::dvec3& extent_min, glm::dvec3& extent_max);

/// The camera of the world, cube or body view, of this aspect. The cube view's is seen through a mirror in z, because clip space
/// is left-handed: the cube then looks like the world, not like its mirror image. Its `view_from_space` holds the mirror; its eye
/// and target are in cube coordinates.
OrbitCamera view_camera(ViewId id, const Analysis& analysis, double aspect);

/// The badge at the bottom: light case, the number that decides, and its words.
std::string light_case_text(const Analysis& analysis);
/// What it is after projection alone: "inverted point light  w = -0.55".
std::string short_light_case_text(const Analysis& analysis);

}  // namespace psm
