// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/scene_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/texel_overlay.h"
#include "draw/theme.h"
#include "gl/gl_state.h"

namespace psm::gl {
namespace {

constexpr double kConeEdge = glm::radians(1.0);  // how soft a spot's edge is, inwards
constexpr float kPushBack = 1.5f;                // pixels of slope
constexpr float kPointSize = 4.0f;               // pixels at scale 1, of a mesh's points

/// Of any length but zero, to unit length; what is zero or not finite stays dark.
glm::vec4 unit_light(const glm::dvec4& light) {
  const double length = light.w == 0.0 ? glm::length(glm::dvec3(light)) : std::abs(light.w);
  if (!(length > 0.0) || !std::isfinite(length)) return glm::vec4(0.0f);
  return glm::vec4(light / length);
}

struct MapCorner {
  glm::vec4 clip;
  glm::vec2 map;  // 0 to 1 over the picture
};

/// What is the same for all programs and batches of one picture.
struct SceneUniforms {
  glm::mat4 clip_from_local{1.0f}, cube_from_local{1.0f};
  float cube_limit = 0.0f, point_size = 1.0f, receiver_bias = 1.0f, constant_bias = 0.0f, normal_bias = 0.0f;
  int kernel = 1;
  glm::vec4 ground{1.0f};  // what the scene fades to
  glm::vec3 spot_axis{0.0f};
  glm::vec2 spot_cosines{-2.0f};
  glm::vec4 light{0.0f};
  std::span<const glm::mat4> maps_from_local;
  bool only_triangles = false;  // no lines, no points
};

void set_spot(SceneUniforms& to, const LightSettings& light) {
  const glm::dvec3 to_target = light.target - light.position;
  if (light.type != LightType::spot || !(glm::length(to_target) > 0.0)) return;
  const double half = glm::radians(0.5 * light.cone_deg);
  to.spot_axis = glm::vec3(glm::normalize(to_target));
  to.spot_cosines = glm::vec2(std::cos(half), std::cos(half - std::min(kConeEdge, 0.2 * half)));
}

/// What does not depend on the picture.
SceneUniforms shadow_uniforms(const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map) {
  SceneUniforms values;
  const ShadowSettings& shadow = analysis.experiment.shadow;
  values.receiver_bias = float(std::clamp(shadow.slope_scaled_bias(), 0.0, 1.0));
  values.constant_bias = float(shadow.constant_bias());
  values.normal_bias = float(shadow.normal_bias);
  values.kernel = shadow.filter == Filter::hardware ? 0 : shadow.filter == Filter::pcf ? shadow.filter_size : 1;
  values.light = unit_light(scene.local_from_world() * analysis.light);
  values.maps_from_local = map.maps_from_local();
  set_spot(values, analysis.experiment.light);
  return values;
}

void use(Program& program, const SceneUniforms& values) {
  program.use();
  program.set("u_clip_from_local", values.clip_from_local);
  program.set("u_cube_from_local", values.cube_from_local);
  program.set("u_cube_limit", values.cube_limit);
  program.set("u_point_size", values.point_size);
  program.set("u_receiver_bias", values.receiver_bias);
  program.set("u_constant_bias", values.constant_bias);
  program.set("u_normal_bias", values.normal_bias);
  program.set("u_kernel", values.kernel);
  program.set("u_ground", values.ground);
  program.set("u_spot_axis", values.spot_axis);
  program.set("u_spot_cosines", values.spot_cosines);
  program.set("u_light", values.light);
  program.set("u_map_from_local", values.maps_from_local);
  program.set("u_map_count", int(values.maps_from_local.size()));
  program.set("u_texture", 0);
  program.set("u_map", 1);
}

/// The batches that need to discard fragments, or those that do not.
void draw_batches(Program& program, const SceneBuffers& scene, bool only_triangles, bool all_discard, bool discarding) {
  for (const Batch& batch : scene.batches()) {
    if (only_triangles && batch.primitive != Primitive::triangles) continue;
    if ((all_discard || scene.material(batch).alpha_cutoff > 0.0f) != discarding) continue;
    program.set("u_has_surface", batch.primitive == Primitive::triangles ? 1 : 0);
    scene.bind_material(batch, program);
    scene.draw(batch);
  }
}

/// Both sides of w = 0 where the picture is projective; the winding flips with the sign.
void draw_scene(std::array<Program, 2>& programs, const SceneUniforms& values, const SceneBuffers& scene, bool projective,
                bool clockwise_front) {
  scene.bind();
  for (const bool discarding : {false, true}) {
    Program& program = programs[discarding ? 1 : 0];
    use(program, values);
    for (const float sign : {1.0f, -1.0f}) {
      if (sign < 0.0f && !projective) continue;
      program.set("u_sign", sign);
      glFrontFace(clockwise_front == (sign > 0.0f) ? GL_CW : GL_CCW);
      draw_batches(program, scene, values.only_triangles, projective, discarding);
    }
  }
}

/// What texels.frag needs besides; the maps are the analysis' own, whether or not they had to be drawn.
void set_texels(std::array<Program, 2>& programs, const Analysis& analysis, const SceneBuffers& scene, double scale) {
  std::vector<glm::mat4> maps;
  const auto add = [&](const glm::dmat4& map) {
    if (const auto narrowed = narrow(map * scene.world_from_local())) maps.push_back(*narrowed);
  };
  if (analysis.map_from_world) add(*analysis.map_from_world);
  if (!analysis.map_from_world && analysis.cube_maps_from_world)
    for (const glm::dmat4& map : *analysis.cube_maps_from_world) add(map);
  for (Program& program : programs) {
    program.use();
    program.set("u_texel_maps", std::span<const glm::mat4>(maps));
    program.set("u_texel_map_count", int(maps.size()));
    program.set("u_resolution", float(analysis.experiment.shadow.resolution));
    program.set("u_scale", float(scale));
  }
}

void set_heat(std::array<Program, 2>& programs, EyeOverlay overlay, const Analysis& analysis, const SceneBuffers& scene) {
  const HeatScale& heat = *heat_scale(overlay);
  const auto eye = narrow(analysis.clip_from_world() * scene.world_from_local());
  for (Program& program : programs) {
    program.use();
    program.set("u_eye_from_local", eye.value_or(glm::mat4(1.0f)));
    program.set("u_image_size", glm::vec2(analysis.experiment.image.width, analysis.experiment.image.height));
    program.set("u_anisotropy", overlay == EyeOverlay::anisotropy ? 1 : 0);
    program.set("u_bands", std::span<const glm::vec3>(heat.colors));
    program.set("u_band_count", int(heat.colors.size()));
    program.set("u_first_bound", float(heat.first_bound));
    program.set("u_marked_from", float(heat.marked_from));
    program.set("u_no_texel", kNoTexelColor);
  }
}

void set_grid(std::array<Program, 2>& programs, int step, Theme theme) {
  for (Program& program : programs) {
    program.use();
    program.set("u_step", float(step));
    program.set("u_strong", float(kStrongLines));
    program.set("u_line_color", picture_line_color(Role::texel_grid, theme));
  }
}

}  // namespace

ScenePass::ScenePass(const std::filesystem::path& shaders)
    : shaders_(shaders),
      shading_{Program(shaders, "scene", "scene"), Program(shaders, "scene", "scene", "#define MAY_DISCARD\n")},
      depth_{Program(shaders, "scene", "scene", "#define DEPTH_ONLY\n"),
             Program(shaders, "scene", "scene", "#define DEPTH_ONLY\n#define MAY_DISCARD\n")},
      verdicts_{Program(shaders, "scene", "scene", "#define VERDICT\n"),
                Program(shaders, "scene", "scene", "#define VERDICT\n#define MAY_DISCARD\n")},
      heat_{Program(shaders, "scene", "texels"), Program(shaders, "scene", "texels", "#define MAY_DISCARD\n")},
      grid_{Program(shaders, "scene", "texels", "#define GRID\n"),
            Program(shaders, "scene", "texels", "#define GRID\n#define MAY_DISCARD\n")},
      surface_points_{Program(shaders, "scene", "surface_point"),
                      Program(shaders, "scene", "surface_point", "#define MAY_DISCARD\n")} {}

ScenePass::Pair& ScenePass::pair_for(const ShadowSettings& shadow, Pair& plain, std::unique_ptr<Pair>& lookup,
                                     const char* defines) {
  const bool filtered = shadow.filter == Filter::hardware || (shadow.filter == Filter::pcf && shadow.filter_size > 1);
  if (!filtered && shadow.normal_bias == 0.0 && shadow.constant_bias() == 0.0) return plain;
  const std::string all = std::string("#define LOOKUP\n") + defines;
  if (!lookup)
    lookup.reset(
        new Pair{Program(shaders_, "scene", "scene", all), Program(shaders_, "scene", "scene", all + "#define MAY_DISCARD\n")});
  return *lookup;
}

void ScenePass::draw(const ViewPicture& picture, const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map,
                     double scale, Theme theme, const glm::vec4& ground) {
  const bool projective = picture.scene == ScenePicture::projective;
  const glm::dmat4 clip_from_local = picture.clip_from_world * scene.world_from_local();
  const auto clip = narrow(clip_from_local);
  const auto cube = narrow(picture.cube_from_world * scene.world_from_local());
  if (!clip || (projective && !cube)) return;

  SceneUniforms values = shadow_uniforms(analysis, scene, map);
  values.clip_from_local = *clip;
  values.cube_from_local = cube.value_or(glm::mat4(1.0f));
  values.cube_limit = projective ? float(picture.cube_limit) : 0.0f;
  values.point_size = float(kPointSize * scale);
  values.ground = ground;

  const ShadowSettings& shadow = analysis.experiment.shadow;
  map.bind_for_comparison(1, shadow.filter == Filter::hardware);
  glEnable(GL_DEPTH_TEST);
  const bool clockwise = front_is_clockwise(clip_from_local);
  if (heat_scale(picture.overlay)) {
    set_texels(heat_, analysis, scene, scale);
    set_heat(heat_, picture.overlay, analysis, scene);
    draw_scene(heat_, values, scene, projective, clockwise);
  } else {
    draw_scene(pair_for(shadow, shading_, lookup_shading_, ""), values, scene, projective, clockwise);
  }
  if (picture.texel_step > 0) {
    set_texels(grid_, analysis, scene, scale);
    set_grid(grid_, picture.texel_step, theme);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    enable_blending();
    draw_scene(grid_, values, scene, projective, clockwise);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
  }
  const DrawList& list = picture.list;
  if (list.lines.empty() && list.fills.empty() && list.points.empty()) return;

  // The depth again, for what is drawn over the scene: farther by a line's width of slope, so that lines on a surface keep both
  // halves of their width. Not in the pass that one sees, where it would let back faces through at silhouettes.
  const float far_end = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &far_end);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kPushBack, 1.0f);
  draw_scene(depth_, values, scene, projective, clockwise);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void ScenePass::draw_verdicts(const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map) {
  const glm::dmat4 clip_from_local = analysis.clip_from_world() * scene.world_from_local();
  const auto clip = narrow(clip_from_local);
  if (!clip) return;
  SceneUniforms values = shadow_uniforms(analysis, scene, map);
  values.clip_from_local = *clip;
  values.only_triangles = true;
  const ShadowSettings& shadow = analysis.experiment.shadow;
  map.bind_for_comparison(1, shadow.filter == Filter::hardware);
  glEnable(GL_DEPTH_TEST);
  draw_scene(pair_for(shadow, verdicts_, lookup_verdicts_, "#define VERDICT\n"), values, scene, false,
             front_is_clockwise(clip_from_local));
}

void ScenePass::draw_surface_points(const Analysis& analysis, const SceneBuffers& scene) {
  const glm::dmat4 clip_from_local = analysis.clip_from_world() * scene.world_from_local();
  const auto clip = narrow(clip_from_local);
  if (!clip) return;
  SceneUniforms values;
  values.clip_from_local = *clip;
  values.only_triangles = true;
  glEnable(GL_DEPTH_TEST);
  draw_scene(surface_points_, values, scene, false, front_is_clockwise(clip_from_local));
}

MapPass::MapPass(const std::filesystem::path& shaders)
    : program_(shaders, "map_depth", "map_depth"),
      corners_(sizeof(MapCorner), {{0, 4, offsetof(MapCorner, clip)}, {1, 2, offsetof(MapCorner, map)}}) {}

void MapPass::draw(const ViewPicture& picture, const ShadowPass& map, double scale, Theme theme) {
  const auto clip = narrow(picture.clip_from_list);
  if (!clip) return;
  const glm::vec2 tiles = map.layers() == 6 ? glm::vec2(3.0f, 2.0f) : glm::vec2(std::max(1, map.layers()), 1.0f);
  const float half_height = tiles.y / tiles.x;
  const auto corner = [&](float u, float v) {
    return MapCorner{*clip * glm::vec4(2.0f * u - 1.0f, (2.0f * v - 1.0f) * half_height, 0.0f, 1.0f), {u, v}};
  };
  const std::array<MapCorner, 6> corners{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)};
  program_.use();
  program_.set("u_map", 0);
  program_.set("u_depth_range", depth_range_);
  program_.set("u_tiles", tiles);
  program_.set("u_empty", map.layers() == 0 ? 1 : 0);
  program_.set("u_ground", picture_ground(theme));
  program_.set("u_scale", float(scale));
  map.bind_for_reading(0);
  glDisable(GL_DEPTH_TEST);
  corners_.upload(std::span<const MapCorner>(corners));
  corners_.draw_triangles();
}

}  // namespace psm::gl
