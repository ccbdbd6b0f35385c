// SPDX-License-Identifier: GPL-3.0-or-later
// The table of an experiment's members: paths, ranges, units, help.
#include <array>
#include <utility>

#include "scene/experiment_names.h"

namespace psm {
namespace {

// Lengths and coordinates stay where their squares and products with a 1e6 : 1 frustum keep full precision.
constexpr double kLargest = 1e12, kSmallest = 1e-12;
// Directions and planes are of any length whose square is still a double.
constexpr double kLongest = 1e100;
template <std::size_t N>
std::vector<std::string> as_list(const std::array<const char*, N>& names) {
  return {names.begin(), names.end()};
}

struct Row : Field {
  Row(std::string row_path, decltype(Field::member) row_member, std::string row_unit, std::string row_help) {
    path = std::move(row_path), member = std::move(row_member), unit = std::move(row_unit), help = std::move(row_help);
  }
  Row&& within(double low, double high) && { return min = low, max = high, std::move(*this); }
  Row&& open() && { return open_min = open_max = true, std::move(*this); }
  Row&& or_infinite() && { return may_be_infinite = true, std::move(*this); }
  Row&& odd_only() && { return odd = true, std::move(*this); }
  Row&& under(const char* heading) && { return pane_group = heading, std::move(*this); }
  Row&& direction() && { return nonzero = true, std::move(*this).within(-kLongest, kLongest); }
  Row&& absent_is(const char* word) && { return absent = word, std::move(*this); }
  Row&& when(std::function<bool(const Experiment&)> condition) && { return applies = std::move(condition), std::move(*this); }
  Row&& coordinate() && { return std::move(*this).within(-kLargest, kLargest); }
};

/// `access` yields the enum; its values count from zero in the order of `names`.
template <class Access>
Choice choice(std::vector<std::string> names, Access access) {
  return {std::move(names), [access](const Experiment& e) { return int(access(const_cast<Experiment&>(e))); },
          [access](Experiment& e, int i) { access(e) = std::remove_reference_t<decltype(access(e))>(i); }};
}

/// The same for a member that may have no value: "none", then the names.
template <class Value, std::size_t N>
Choice choice_or_none(const std::array<const char*, N>& values, std::optional<Value> ViewSettings::*member) {
  std::vector<std::string> names{"none"};
  names.insert(names.end(), values.begin(), values.end());
  return {std::move(names), [member](const Experiment& e) { return e.view.*member ? int(*(e.view.*member)) + 1 : 0; },
          [member](Experiment& e, int i) { e.view.*member = i == 0 ? std::nullopt : std::optional<Value>(Value(i - 1)); }};
}

bool is_directional(const Experiment& e) { return e.light.type == LightType::directional; }
bool is_placed(const Experiment& e) { return !is_directional(e); }
bool is_spot(const Experiment& e) { return e.light.type == LightType::spot; }
bool is_pcf(const Experiment& e) { return e.shadow.filter == Filter::pcf; }

#define PSM_REF(type, member) type([](Experiment & e) -> auto& { return e.member; })
#define PSM_CHOICE(names, member) \
  choice(                         \
      names, [](Experiment & e) -> auto& { return e.member; })

void add_scene_and_camera(std::vector<Field>& rows) {
  rows.push_back(
      Row("scene.source", PSM_REF(TextRef, scene.source), "", "The scene: a built-in one by its id, or a .gltf or .glb file."));
  rows.push_back(Row("camera.position", PSM_REF(Vec3Ref, camera.position), "scene units", "Where the eye is.").coordinate());
  rows.push_back(
      Row("camera.target", PSM_REF(Vec3Ref, camera.target), "scene units", "The point the camera looks at.").coordinate());
  rows.push_back(Row("camera.up", PSM_REF(Vec3Ref, camera.up), "", "The direction that is upwards in the image, of any length.")
                     .direction());
  rows.push_back(Row("camera.vertical_fov_deg", PSM_REF(NumberRef, camera.vertical_fov_deg), "deg",
                     "Full vertical opening angle of the camera.")
                     .within(0, 180)
                     .open());
  rows.push_back(Row("camera.near", PSM_REF(NumberRef, camera.near), "scene units",
                     "Distance of the near plane; a small one ruins PSM unless near_fit tightens it.")
                     .within(kSmallest, kLargest));
  rows.push_back(Row("camera.far", PSM_REF(NumberRef, camera.far), "scene units",
                     "Distance of the far plane, beyond the near plane; may be inf.")
                     .within(kSmallest, kLargest)
                     .or_infinite());
  rows.push_back(Row("image.width", PSM_REF(IntRef, image.width), "px", "Width of the picture the eye sees.").within(1, 16384));
  rows.push_back(
      Row("image.height", PSM_REF(IntRef, image.height), "px", "Height of the picture the eye sees.").within(1, 16384));
}

void add_light(std::vector<Field>& rows) {
  rows.push_back(Row("light.type", PSM_CHOICE(as_list(kLightTypes), light.type), "", "A directional, a point or a spot light."));
  rows.push_back(
      Row("light.to_light", PSM_REF(Vec3Ref, light.to_light), "", "The direction towards the light, of any length but zero.")
          .direction()
          .when(is_directional));
  rows.push_back(
      Row("light.position", PSM_REF(Vec3Ref, light.position), "scene units", "Where the light is.").coordinate().when(is_placed));
  rows.push_back(Row("light.target", PSM_REF(Vec3Ref, light.target), "scene units", "The point the spot light aims at.")
                     .coordinate()
                     .when(is_spot));
  rows.push_back(Row("light.cone_deg", PSM_REF(NumberRef, light.cone_deg), "deg", "Full apex angle of the spot light's cone.")
                     .within(0, 180)
                     .open()
                     .when(is_spot));
  rows.push_back(Row("light.radius", PSM_REF(NumberRef, light.radius), "",
                     "Radius of an area light, a disc that faces each point, in scene units; of a directional light the disc at "
                     "distance 1 (the sun: 0.0047). The map knows its centre alone; truth and errors know all of it.")
                     .within(0, kLargest));
}

/// Against acne, and what smooths the map's answers.
void add_bias_and_filter(std::vector<Field>& rows) {
  const char* heading = "bias and filter";
  rows.push_back(
      Row("shadow.depth_bias", PSM_REF(NumberRef, shadow.depth_bias), "texels",
          "Depth offset against self-shadowing, in texels along the steeper depth slope of the caster; slope_bias makes "
          "it constant.")
          .within(0, 1000)
          .under(heading));
  rows.push_back(
      Row("shadow.slope_bias", PSM_REF(NumberRef, shadow.slope_bias), "",
          "How much of depth_bias grows with the slope: 1, all of it; 0, none, each surface gets what one at 45 degrees "
          "to the light needs.")
          .within(0, 1)
          .under(heading));
  rows.push_back(Row("shadow.normal_bias", PSM_REF(NumberRef, shadow.normal_bias), "texels",
                     "How far a point is shifted along its normal before it is looked up, in texels by their own reach along the "
                     "normal; half a texel keeps a plane free of acne whatever the technique.")
                     .within(0, 1000)
                     .under(heading));
  rows.push_back(Row("shadow.cull", PSM_CHOICE(as_list(kCulls), shadow.cull), "",
                     "Which faces of casters are left out of the map: none, those whose front the light sees, or the others. "
                     "Double-sided materials stay.")
                     .under(heading));
  rows.push_back(Row("shadow.filter", PSM_CHOICE(as_list(kFilters), shadow.filter), "",
                     "How comparisons with the map are averaged: none, the hardware's four texels weighted by distance, or "
                     "percentage-closer filtering over a kernel.")
                     .under(heading));
  rows.push_back(Row("shadow.filter_size", PSM_REF(IntRef, shadow.filter_size), "texels",
                     "Side of the kernel of percentage-closer filtering; its square is the number of comparisons.")
                     .within(1, 15)
                     .odd_only()
                     .when(is_pcf)
                     .under(heading));
}

void add_shadow(std::vector<Field>& rows) {
  rows.push_back(Row("shadow.technique", PSM_CHOICE(as_list(kTechniques), shadow.technique), "",
                     "How the shadow map is warped: which plane through the light it sends to infinity."));
  rows.push_back(
      Row("shadow.resolution", PSM_REF(IntRef, shadow.resolution), "texels", "Texels along each side of the shadow map.")
          .within(16, 8192));
  rows.push_back(Row("shadow.camera_shift", PSM_REF(ShiftRef, shadow.camera_shift), "scene units",
                     "How far the virtual camera steps back before the PSM projection: until the casters are in front of it, or "
                     "inside its frustum; auto lets the technique choose.")
                     .within(0, kLargest));
  rows.push_back(Row("shadow.near_fit", PSM_CHOICE((std::vector<std::string>{"off", "bounds", "depth"}), shadow.near_fit), "",
                     "What near and far tighten to: nothing, the receivers' depth range, or the visible points."));
  rows.push_back(Row("shadow.focus", PSM_CHOICE((std::vector<std::string>{"bounds", "visible"}), shadow.focus), "",
                     "What the map's window encloses: the receivers' bounds, or the visible points alone."));
  rows.push_back(Row("shadow.warp_range", PSM_CHOICE((std::vector<std::string>{"receivers", "frustum"}), shadow.warp_range), "",
                     "What the warp's range is measured on: the receivers, or the frustum between their depths."));
  rows.push_back(
      Row("shadow.scene_body", PSM_CHOICE((std::vector<std::string>{"box", "hull", "auto"}), shadow.scene_body), "",
          "What stands in for the scene in R and H: its box, a hull of the casters that can matter, or what the scene needs."));
  rows.push_back(
      Row("shadow.receiver_plane", PSM_REF(AutoPlaneRef, shadow.receiver_plane), "",
          "The plane a, b, c, d on which plane_optimal gives every texel the same size; auto: the largest visible flat area.")
          .direction());
  rows.push_back(
      Row("shadow.plane", PSM_REF(AutoPlaneRef, shadow.plane), "", "The vanishing plane a, b, c, d of technique custom.")
          .direction()
          .absent_is("null"));
}

void add_orbit(std::vector<Field>& rows, const std::string& view, OrbitSettings ViewSettings::*orbit, const std::string& unit) {
  const auto number = [orbit](double OrbitSettings::*part) {
    return NumberRef([orbit, part](Experiment& e) -> double& { return e.view.*orbit.*part; });
  };
  const Vec3Ref target = [orbit](Experiment& e) -> glm::dvec3& { return (e.view.*orbit).target; };
  rows.push_back(Row(view + ".target", target, unit, "The point this view turns around.").coordinate());
  // Turning on and on is allowed: an orbit that was dragged around many times must stay a valid file.
  rows.push_back(
      Row(view + ".yaw_deg", number(&OrbitSettings::yaw_deg), "deg", "From which side this view looks.").within(-1e6, 1e6));
  rows.push_back(
      Row(view + ".pitch_deg", number(&OrbitSettings::pitch_deg), "deg", "From how high this view looks.").within(-90, 90));
  rows.push_back(
      Row(view + ".distance", number(&OrbitSettings::distance), unit, "From how far this view looks; 0 fits everything.")
          .within(0, kLargest));
}

void add_view(std::vector<Field>& rows) {
  rows.push_back(Row("view.maximised", choice_or_none(kViews, &ViewSettings::maximised), "",
                     "The one view that fills the window, or none."));
  rows.push_back(Row("view.tiles", PSM_REF(TilesRef, view.tiles), "", "The views that share the window, in reading order."));
  add_orbit(rows, "view.world", &ViewSettings::world, "scene units");
  add_orbit(rows, "view.cube", &ViewSettings::cube, "half cube sides");
  add_orbit(rows, "view.body", &ViewSettings::body, "scene units");
  rows.push_back(Row("view.world_to_cube", PSM_REF(NumberRef, view.world_to_cube), "",
                     "How far the cube view has come on its way from the world, seen by an eye at infinity (0), to the cube (1).")
                     .within(0, 1));
  rows.push_back(Row("view.curve", PSM_CHOICE(as_list(kCurveKindNames), view.curve), "",
                     "What the curves view plots: the warp's strength, its errors F or E, or the storage factor over the light's "
                     "angle; F or E over depth; or F over both, as a map or as a relief."));
  rows.push_back(Row("view.curve_range", PSM_CHOICE((std::vector<std::string>{"experiment", "papers"}), view.curve_range), "",
                     "Whose n, f and phi the curves are for: the experiment's, or the papers' 1, 100 and 30 degrees."));
  rows.push_back(
      Row("view.explorer_slice", PSM_CHOICE((std::vector<std::string>{"side", "above"}), view.explorer_slice), "",
          "The explorer's slice of light positions, through the eye along the view: seen from the side, or from above."));
  rows.push_back(Row("view.world_body", PSM_CHOICE((std::vector<std::string>{"H", "M"}), view.world_body), "",
                     "The body in the world view: H, or M, the frustum extended towards the light, before S and L cut it."));
  rows.push_back(
      Row("view.map_shows", PSM_CHOICE((std::vector<std::string>{"depth", "scene"}), view.map_shows), "",
          "What the map view shows: the map's depths, or the scene as the light sees it through the map's projection."));
  rows.push_back(Row("view.map_center", PSM_REF(Vec2Ref, view.map_center), "half map sides",
                     "The point of the shadow map at the middle of its view.")
                     .within(-1e6, 1e6));
  rows.push_back(Row("view.map_zoom", PSM_REF(NumberRef, view.map_zoom), "", "How much the map view is enlarged; 1 shows it all.")
                     .within(1e-3, 1e6));
  rows.push_back(Row("view.eye_overlay", PSM_CHOICE(as_list(kEyeOverlays), view.eye_overlay), "",
                     "What the eye view's colours mean: the picture itself, the size m or the anisotropy of the map's texels in "
                     "it, its errors against ray-traced shadows, or how much of the light each point sees."));
  rows.push_back(Row("view.texel_grid", PSM_CHOICE((std::vector<std::string>{"off", "on"}), view.texel_grid), "",
                     "Whether the map's texels are drawn on the receivers, in the eye, world and cube view."));
  rows.push_back(Row("view.probe", PSM_REF(AutoPixelRef, view.probe), "px",
                     "The pixel x, y of the image, from its top left, whose texel, rays and angles all views show, or null.")
                     .within(0, 16384)
                     .absent_is("null"));
  rows.push_back(Row("view.compare", choice_or_none(kTechniques, &ViewSettings::compare), "",
                     "A second technique, B, that the eye, world and map view show beside the experiment's own, A, or none."));
  rows.push_back(Row("view.compare_layout", PSM_CHOICE((std::vector<std::string>{"split", "side_by_side"}), view.compare_layout),
                     "", "How A and B share a view: a dividing line (two maps always stand side by side), or a picture each."));
  rows.push_back(Row("view.split", PSM_REF(NumberRef, view.split), "",
                     "Where the line between A and B stands, as a part of the picture's width.")
                     .within(0, 1));
}

#undef PSM_REF
#undef PSM_CHOICE

std::vector<Field> make_fields() {
  std::vector<Field> rows;
  add_scene_and_camera(rows);
  add_light(rows);
  add_shadow(rows);
  add_bias_and_filter(rows);
  add_view(rows);
  return rows;
}

}  // namespace

const std::vector<Field>& experiment_fields() {
  static const std::vector<Field> fields = make_fields();
  return fields;
}

const Field* find_field(const std::string& path) {
  for (const Field& field : experiment_fields())
    if (field.path == path) return &field;
  return nullptr;
}

}  // namespace psm
