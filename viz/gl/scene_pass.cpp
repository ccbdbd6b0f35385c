// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/scene_pass.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "draw/texel_overlay.h"
#include "draw/theme.h"
#include "gl/gl_state.h"
#include "gl/viewed_side.h"

namespace psm::gl {

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

struct ShownBatch {
  const Batch* batch;
  std::vector<Shown> parts;
  double far_end = -1e300;
};

/// What one side of w = 0 shows, small things in front before the ground behind them, which they hide from being shaded. The
/// winding flips with the sign.
struct Side {
  float sign;
  GLenum front;
  std::vector<ShownBatch> batches;
};

namespace {

constexpr double kConeEdge = glm::radians(1.0);                     // how soft a spot's edge is, inwards
constexpr float kPointSize = 4.0f;                                  // pixels at scale 1, of a mesh's points
constexpr float kWeakLines = 0.55f, kWeakLinesAmongBodies = 0.85f;  // opacity of the texel grid's thin lines
constexpr double kFadeStart = 0.75;                                 // of the cube's limit, as in scene.frag

/// Of any length but zero, to unit length; what is zero or not finite stays dark.
glm::vec4 unit_light(const glm::dvec4& light) {
  const double length = light.w == 0.0 ? glm::length(glm::dvec3(light)) : std::abs(light.w);
  if (!(length > 0.0) || !std::isfinite(length)) return glm::vec4(0.0f);
  return glm::vec4(light / length);
}

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

void set_uniforms(Program& program, const SceneUniforms& values) {
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
  program.set("u_texture", 0);
  program.set("u_map", 1);
}

std::vector<Side> sides_of(const glm::dmat4& clip_from_world, const std::optional<CubeLimit>& limit, const SceneBuffers& scene) {
  const bool clockwise = front_is_clockwise(clip_from_world);
  std::vector<Side> sides;
  for (const float sign : {1.0f, -1.0f}) {
    if (sign < 0.0f && !limit) continue;
    const ViewedSide viewed(clip_from_world, sign, limit);
    Side side{sign, GLenum(clockwise == (sign > 0.0f) ? GL_CW : GL_CCW), {}};
    for (const Batch& batch : scene.batches()) {
      ShownBatch shown{&batch, {}};
      for (const Part& part : batch.parts) {
        shown.parts.push_back(viewed.of(part.bounds));
        if (shown.parts.back().at_all) shown.far_end = std::max(shown.far_end, viewed.far_end(part.bounds));
      }
      side.batches.push_back(std::move(shown));
    }
    std::stable_sort(side.batches.begin(), side.batches.end(),
                     [](const ShownBatch& a, const ShownBatch& b) { return a.far_end < b.far_end; });
    sides.push_back(std::move(side));
  }
  return sides;
}

std::optional<CubeLimit> limit_of(const ViewPicture& picture) {
  if (picture.scene != ScenePicture::projective) return std::nullopt;
  return CubeLimit{picture.cube_from_world, kFadeStart * picture.cube_limit, picture.cube_limit};
}

/// All but the ground's colour; nothing where a matrix cannot be drawn.
std::optional<SceneUniforms> picture_uniforms(const ViewPicture& picture, const Analysis& analysis, const SceneBuffers& scene,
                                              const ShadowPass& map, double scale) {
  const bool projective = picture.scene == ScenePicture::projective;
  const auto clip = narrow(picture.clip_from_world * scene.world_from_local());
  const auto cube = narrow(picture.cube_from_world * scene.world_from_local());
  if (!clip || (projective && !cube)) return std::nullopt;
  SceneUniforms values = shadow_uniforms(analysis, scene, map);
  values.clip_from_local = *clip;
  values.cube_from_local = cube.value_or(glm::mat4(1.0f));
  values.cube_limit = projective ? float(picture.cube_limit) : 0.0f;
  values.point_size = float(kPointSize * scale);
  return values;
}

/// Whether a batch has parts that need to discard fragments, or such that do not.
bool has_parts(const SceneBuffers& scene, const ShownBatch& shown, bool discarding) {
  const bool holes = scene.material(*shown.batch).alpha_cutoff > 0.0f;
  return std::any_of(shown.parts.begin(), shown.parts.end(),
                     [&](const Shown& s) { return s.at_all && (holes || !s.clear) == discarding; });
}

/// Those parts; of whole closed surfaces only the triangles that face the viewer, since they hide the others.
void draw_batch(Program& program, const SceneBuffers& scene, const ShownBatch& shown, bool discarding) {
  const Batch& batch = *shown.batch;
  const bool holes = scene.material(batch).alpha_cutoff > 0.0f;
  program.set("u_has_surface", batch.primitive == Primitive::triangles ? 1 : 0);
  scene.bind_material(batch, program);
  for (const bool solid : {false, true}) {
    solid ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
    scene.draw_parts(batch, [&](std::size_t i) {
      const Shown& s = shown.parts[i];
      return s.at_all && (holes || !s.clear) == discarding && (batch.parts[i].closed && s.uncut && s.clear && !holes) == solid;
    });
  }
  glDisable(GL_CULL_FACE);
}

/// What texels.frag needs besides; the maps are the analysis' own, whether or not they had to be drawn.
void set_texels(Program& program, const Analysis& analysis, const SceneBuffers& scene, double scale) {
  std::vector<glm::mat4> maps;
  const auto add = [&](const glm::dmat4& map) {
    if (const auto narrowed = narrow(map * scene.world_from_local())) maps.push_back(*narrowed);
  };
  if (analysis.map_from_world) add(*analysis.map_from_world);
  if (!analysis.map_from_world && analysis.cube_maps_from_world)
    for (const glm::dmat4& map : *analysis.cube_maps_from_world) add(map);
  program.set("u_texel_maps", std::span<const glm::mat4>(maps));
  program.set("u_texel_map_count", int(maps.size()));
  program.set("u_resolution", float(analysis.experiment.shadow.resolution));
  program.set("u_scale", float(scale));
}

void set_heat(Program& program, EyeOverlay overlay, const Analysis& analysis, const SceneBuffers& scene) {
  const HeatScale& heat = *heat_scale(overlay);
  const auto eye = narrow(analysis.clip_from_world() * scene.world_from_local());
  program.set("u_eye_from_local", eye.value_or(glm::mat4(1.0f)));
  program.set("u_image_size", glm::vec2(analysis.experiment.image.width, analysis.experiment.image.height));
  program.set("u_anisotropy", overlay == EyeOverlay::anisotropy ? 1 : 0);
  program.set("u_bands", std::span<const glm::vec3>(heat.colors));
  program.set("u_band_count", int(heat.colors.size()));
  program.set("u_first_bound", float(heat.first_bound));
  program.set("u_marked_from", float(heat.marked_from));
  program.set("u_no_texel", kNoTexelColor);
}

void set_grid(Program& program, const ViewPicture& picture, Theme theme) {
  program.set("u_step", float(picture.texel_step));
  program.set("u_weak", picture.id == ViewId::eye ? kWeakLines : kWeakLinesAmongBodies);
  program.set("u_strong", float(kStrongLines));
  program.set("u_line_color", picture_line_color(Role::texel_grid, theme));
}

}  // namespace

Program& ScenePass::program(const std::string& fragment, const std::string& defines) {
  return programs_.try_emplace(fragment + "\n" + defines, shaders_, "scene", fragment, defines).first->second;
}

void ScenePass::draw_scene(const Shading& shading, const SceneUniforms& values, const SceneBuffers& scene,
                           const std::vector<Side>& sides) {
  scene.bind();
  glCullFace(GL_BACK);
  std::set<Program*> ready;
  for (const bool discarding : {false, true}) {
    for (const Side& side : sides) {
      glFrontFace(side.front);
      for (const ShownBatch& shown : side.batches) {
        if (values.only_triangles && shown.batch->primitive != Primitive::triangles) continue;
        if (!has_parts(scene, shown, discarding)) continue;
        Program& drawn = program(shading.fragment,
                                 shading.defines + (discarding ? "#define MAY_DISCARD\n" : "") + scene.defines(*shown.batch));
        drawn.use();
        if (ready.insert(&drawn).second) {
          set_uniforms(drawn, values);
          if (shading.set) shading.set(drawn);
        }
        drawn.set("u_sign", side.sign);
        draw_batch(drawn, scene, shown, discarding);
      }
    }
  }
}

ScenePass::Shading ScenePass::lit(const Analysis& analysis, const ShadowPass& map, const std::string& defines) {
  const ShadowSettings& shadow = analysis.experiment.shadow;
  const bool filtered = shadow.filter == Filter::hardware || (shadow.filter == Filter::pcf && shadow.filter_size > 1);
  Shading shading{"scene", defines, {}};
  if (filtered || shadow.normal_bias != 0.0 || shadow.constant_bias() != 0.0) shading.defines += "#define LOOKUP\n";
  if (map.layers() > 0) shading.defines += "#define MAPS " + std::to_string(map.layers()) + "\n";
  if (analysis.light.w == 0.0) shading.defines += "#define SUN\n";
  return shading;
}

PixelRect ScenePass::reach(const ViewPicture& picture, const SceneBuffers& scene, glm::ivec2 size, double scale) {
  const int margin = 1 + int(std::ceil(0.5 * kPointSize * scale));
  SeenRect seen;
  for (const Side& side : sides_of(picture.clip_from_world, limit_of(picture), scene))
    for (const ShownBatch& shown : side.batches)
      for (std::size_t i = 0; i < shown.parts.size(); ++i)
        if (shown.parts[i].at_all) seen.add_box(double(side.sign) * picture.clip_from_world, shown.batch->parts[i].bounds);
  const PixelRect scene_rect = seen.pixels(size, margin);
  if (picture.scene != ScenePicture::projective) return scene_rect;
  SeenRect limit;  // of the cube, in whose space the list is
  const glm::dvec3 corner(picture.cube_limit);
  limit.add_box(picture.clip_from_list, {-corner, corner});
  return common(scene_rect, limit.pixels(size, margin));
}

void ScenePass::draw(const ViewPicture& picture, const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map,
                     double scale, const glm::vec4& ground) {
  auto values = picture_uniforms(picture, analysis, scene, map, scale);
  if (!values) return;
  values->ground = ground;
  map.bind_for_comparison(1, analysis.experiment.shadow.filter == Filter::hardware);
  glEnable(GL_DEPTH_TEST);
  const auto heat = [&](Program& program) {
    set_texels(program, analysis, scene, scale);
    set_heat(program, picture.overlay, analysis, scene);
  };
  draw_scene(heat_scale(picture.overlay) ? Shading{"texels", "", heat} : lit(analysis, map), *values, scene,
             sides_of(picture.clip_from_world, limit_of(picture), scene));
}

void ScenePass::draw_texel_grid(const ViewPicture& picture, const Analysis& analysis, const SceneBuffers& scene,
                                const ShadowPass& map, double scale, Theme theme) {
  if (picture.texel_step <= 0) return;
  const auto values = picture_uniforms(picture, analysis, scene, map, scale);
  if (!values) return;
  const auto grid = [&](Program& program) {
    set_texels(program, analysis, scene, scale);
    set_grid(program, picture, theme);
  };
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  enable_blending();
  draw_scene({"texels", "#define GRID\n", grid}, *values, scene, sides_of(picture.clip_from_world, limit_of(picture), scene));
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
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
  draw_scene(lit(analysis, map, "#define VERDICT\n"), values, scene, sides_of(analysis.clip_from_world(), std::nullopt, scene));
}

void ScenePass::draw_surface_points(const Analysis& analysis, const SceneBuffers& scene) {
  const glm::dmat4 clip_from_local = analysis.clip_from_world() * scene.world_from_local();
  const auto clip = narrow(clip_from_local);
  if (!clip) return;
  SceneUniforms values;
  values.clip_from_local = *clip;
  values.only_triangles = true;
  glEnable(GL_DEPTH_TEST);
  draw_scene({"surface_point"}, values, scene, sides_of(analysis.clip_from_world(), std::nullopt, scene));
}

}  // namespace psm::gl
