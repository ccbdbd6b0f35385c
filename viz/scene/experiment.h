// SPDX-License-Identifier: GPL-3.0-or-later
// Experiment: one plain value with everything a user can set. Declared once, in the table of experiment.cpp: widgets, JSON,
// --set and sweeps come from it.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/result.h"

namespace psm {

/// A named reason (fallback, clamp, limit) with the number that fired it and the limit it met.
struct Note {
  std::string code;  // snake_case, stable
  std::string text;  // one sentence for the user
  std::optional<double> value, limit;
  bool operator==(const Note&) const = default;
};

enum class LightType { directional, point, spot };
enum class Technique {
  uniform,
  psm,
  lispsm,
  lispsm_reference,
  glpr,
  gmnpr,
  minimax,
  minimax_frustum,
  plane_optimal,
  best_plane,
  psm_recipe,
  psm_divided,
  psm_two_maps,
  custom
};
/// How far the virtual camera steps back (PSM 2002, section 4.2): a number, or the least shift by a rule, after which all of H is
/// in front of the eye or inside the shifted frustum; `automatic` leaves the rule to the technique.
enum class ShiftRule { automatic, in_front, inside };
using CameraShift = std::variant<ShiftRule, double>;
enum class Cull { none, front, back };  // faces of casters that are left out of the map
enum class Filter { none, hardware, pcf };
enum class NearFit { off, bounds, depth };
enum class Focus { bounds, visible };
enum class WarpRange { receivers, frustum };
enum class SceneBody { box, hull, automatic };
enum class EyeOverlay { none, texel_size, anisotropy, errors, penumbra };
/// How two techniques share a view: a dividing line over one picture, or a picture each.
enum class CompareLayout { split, side_by_side };
enum class ViewId { world, cube, map, eye, body, curves, explorer };
inline constexpr std::array kAllViews{ViewId::world, ViewId::cube,   ViewId::map,     ViewId::eye,
                                      ViewId::body,  ViewId::curves, ViewId::explorer};         // by value
inline constexpr std::array kMainViews{ViewId::world, ViewId::cube, ViewId::map, ViewId::eye};  // shown unless asked otherwise
inline constexpr std::size_t kMostTiles = 4;
/// What the curves view plots, by the two-dimensional model of viz/math/warp.h: over theta, over depth, or over both.
enum class CurveKind { lambda, log_lambda, rho, F_max, E_max, E_frustum, storage, F_z, E_z, surface, relief };
inline constexpr std::size_t kCurveKinds = 11;
enum class CurveFrustum { experiment, papers };
enum class ExplorerSlice { side, above };
enum class MapShows { depth, scene };
/// H, or M: the frustum extended towards the light, before the scene's bounds and the light's frustum cut it.
enum class WorldBody { H, M };

struct SceneSettings {
  std::string source = "chessboard";
  bool operator==(const SceneSettings&) const = default;
};

/// World space; lengths in scene units. `far` may be infinite.
struct CameraSettings {
  glm::dvec3 position{0.0, 1.7, 6.0}, target{0.0, 1.0, 0.0}, up{0.0, 1.0, 0.0};
  double vertical_fov_deg = 60.0, near = 0.1, far = 100.0;
  bool operator==(const CameraSettings&) const = default;
};

struct ImageSettings {
  int width = 1280, height = 720;
  bool operator==(const ImageSettings&) const = default;
  double aspect() const { return double(width) / height; }
};

/// `to_light` points to the light, of any length but zero (directional); `position` is a point or spot light's, `target` and
/// `cone_deg` (full apex angle) a spot's. Members of other types keep their values but are neither written nor used.
struct LightSettings {
  LightType type = LightType::directional;
  glm::dvec3 to_light{0.3, 1.0, 0.2};
  glm::dvec3 position{0.0, 4.0, 0.0}, target{0.0, 0.0, 0.0};
  double cone_deg = 60.0;
  double radius = 0.0;  // of an area light's disc, which faces each point; of a directional light's at distance 1
  bool operator==(const LightSettings&) const = default;
};

struct ShadowSettings {
  Technique technique = Technique::gmnpr;
  int resolution = 1024;    // texels along each side of the map
  double depth_bias = 1.5;  // texels; how much of it grows with the caster's slope is slope_bias
  double slope_bias =
      1.0;  // 1: along the steeper of the two depth slopes of the caster; 0: constant, as on a slope of 45 degrees
  double normal_bias = 0.0;  // texels, by their reach along the receiver's normal
  Cull cull = Cull::none;
  Filter filter = Filter::none;
  int filter_size = 3;  // of pcf: texels across, odd
  CameraShift camera_shift;
  NearFit near_fit = NearFit::bounds;
  Focus focus = Focus::bounds;
  WarpRange warp_range = WarpRange::receivers;
  SceneBody scene_body = SceneBody::box;     // S
  std::optional<glm::dvec4> receiver_plane;  // none: auto
  std::optional<glm::dvec4> plane;           // vanishing plane of technique custom
  /// The two parts of depth_bias, texels.
  double slope_scaled_bias() const { return depth_bias * slope_bias; }
  double constant_bias() const { return depth_bias * (1.0 - slope_bias); }
  bool operator==(const ShadowSettings&) const = default;
};

/// How one three-dimensional view is looked at: an orbit around `target`. `distance` 0: fit what it shows. World and body: scene
/// units. Cube: units of the cube, whose half side is 1.
struct OrbitSettings {
  glm::dvec3 target{0.0};
  double yaw_deg = 35.0, pitch_deg = 25.0, distance = 0.0;
  bool operator==(const OrbitSettings&) const = default;
};

/// Which views are open, and how each is looked at.
struct ViewSettings {
  std::vector<ViewId> tiles{kMainViews.begin(), kMainViews.end()};  // one to four, none twice
  std::optional<ViewId> maximised;                                  // none: the tiles
  OrbitSettings world, cube, body;
  CurveKind curve = CurveKind::log_lambda;
  CurveFrustum curve_range = CurveFrustum::experiment;  // whose n, f and phi
  ExplorerSlice explorer_slice = ExplorerSlice::side;   // of positions: upwards, or to the side
  double world_to_cube = 1.0;                           // of the cube view: 0 the world, seen from infinity, to 1 the cube
  WorldBody world_body = WorldBody::H;                  // in the world view
  MapShows map_shows = MapShows::depth;                 // the map, or the lit scene in its place
  glm::dvec2 map_center{0.0};                           // map clip space
  double map_zoom = 1.0;                                // 1: the whole map
  EyeOverlay eye_overlay = EyeOverlay::none;            // what the eye view's colours mean
  bool texel_grid = false;                              // the map's texels on the receivers, in the eye, world and cube view
  std::optional<glm::dvec2> probe;                      // the pixel of the image whose texel is shown in all views
  std::optional<Technique> compare;                     // a second technique, shown beside the first
  CompareLayout compare_layout = CompareLayout::split;
  double split = 0.5;  // where the dividing line stands, as a part of the picture's width
  bool operator==(const ViewSettings&) const = default;
};

struct Experiment {
  SceneSettings scene;
  CameraSettings camera;
  ImageSettings image;
  LightSettings light;
  ShadowSettings shadow;
  ViewSettings view;
  bool operator==(const Experiment&) const = default;
};

// ---- the table -------------------------------------------------------------------------------------------------------

/// Names of an enum's values, in order; `get`/`set` use the index.
struct Choice {
  std::vector<std::string> names;
  std::function<int(const Experiment&)> get;
  std::function<void(Experiment&, int)> set;
};
using NumberRef = std::function<double&(Experiment&)>;
using IntRef = std::function<int&(Experiment&)>;
using Vec2Ref = std::function<glm::dvec2&(Experiment&)>;
using Vec3Ref = std::function<glm::dvec3&(Experiment&)>;
using TextRef = std::function<std::string&(Experiment&)>;
using ShiftRef = std::function<CameraShift&(Experiment&)>;  // a rule's name or a number
using TilesRef = std::function<std::vector<ViewId>&(Experiment&)>;
using AutoPixelRef = std::function<std::optional<glm::dvec2>&(Experiment&)>;  // null, or [x, y]
using AutoPlaneRef = std::function<std::optional<glm::dvec4>&(Experiment&)>;  // "auto" or null, or [a, b, c, d]

/// One row: a member that a user can set.
struct Field {
  std::string path;  // JSON path, such as "camera.near"
  std::variant<NumberRef, IntRef, Vec2Ref, Vec3Ref, TextRef, ShiftRef, TilesRef, AutoPixelRef, AutoPlaneRef, Choice> member;
  std::string unit;                         // "" where there is none; "deg", "texels", "scene units", "px"
  double min = -1e300, max = 1e300;         // of a number or of each component
  bool open_min = false, open_max = false;  // the bound itself is not allowed
  bool may_be_infinite = false;             // "inf" is allowed
  bool odd = false;                         // a whole number: not an even one
  bool nonzero = false;                     // a vector: not the zero vector; a plane: its normal is not
  std::string absent = "auto";              // the word for "no value" of AutoPixelRef and AutoPlaneRef: "auto" or "null"
  std::string help;                         // one sentence
  std::string pane_group;                   // the control pane's heading over it; empty: the path's first part
  /// False where the member means nothing for this experiment (a spot's cone while the light is directional).
  std::function<bool(const Experiment&)> applies = [](const Experiment&) { return true; };
};

/// All members, in the order in which files and panels show them.
const std::vector<Field>& experiment_fields();

/// The row of a path; null if there is none.
const Field* find_field(const std::string& path);

/// The allowed values in words: "a number in (0, 180)", "one of: none".
std::string allowed_values(const Field& field);

/// The value as --set takes it back, bit for bit: "0,1,-0.2", "inf", "auto", "spot".
std::string value_text(const Field& field, const Experiment& experiment);

/// Shortest text that reads back as the same double; "inf", "-inf", "nan".
std::string number_text(double value);

/// Decimal notation, whatever the locale, or "inf", "-inf"; nothing where the text is no number or beyond the doubles.
std::optional<double> number_from_text(const std::string& text);

/// Null where the member's value is within the row's range; else the line "PATH: VALUE is not allowed; allowed: ...".
std::optional<InputError> check_field(const Field& field, const Experiment& experiment);

/// Every row that applies, and what ties members together (far > near, up not along the view direction ...).
std::optional<InputError> check_experiment(const Experiment& experiment);

const char* name_of(LightType);
const char* name_of(Technique);
const char* name_of(ViewId);
const char* name_of(ShiftRule);
const char* name_of(EyeOverlay);
std::optional<ViewId> view_from_name(const std::string& name);
const char* name_of(Cull);
const char* name_of(Filter);
std::vector<std::string> technique_names();
std::optional<ShiftRule> shift_rule_from_name(const std::string& name);
/// Whether the technique looks from a shifted eye.
bool shifts_camera(Technique);
std::optional<Technique> technique_from_name(const std::string& name);

}  // namespace psm
