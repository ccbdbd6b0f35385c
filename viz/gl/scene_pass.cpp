// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/scene_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gl/gl_state.h"
#include "gl/theme.h"

namespace psm::gl {
namespace {

constexpr double kConeEdge = glm::radians(1.0);  // how soft a spot's edge is, inwards
constexpr float kPushBack = 1.5f;                // pixels of slope, so that lines on a surface keep both halves of their width
constexpr float kPointSize = 4.0f;               // pixels at scale 1, of a mesh's points

/// Of any length but zero, to unit length; what is zero or not finite stays dark.
glm::vec4 unit_light(const glm::dvec4& light) {
  const double length = light.w == 0.0 ? glm::length(glm::dvec3(light)) : std::abs(light.w);
  if (!(length > 0.0) || !std::isfinite(length)) return glm::vec4(0.0f);
  return glm::vec4(light / length);
}

/// Counter-clockwise triangles stay so on the screen where the determinant is negative: OpenGL's own projections look down -z.
bool front_is_clockwise(const glm::dmat4& clip_from_space) { return glm::determinant(clip_from_space) > 0.0; }

struct MapCorner {
  glm::vec4 clip;
  glm::vec2 map;  // 0 to 1 over the picture
};

}  // namespace

void ScenePass::set_light(const Analysis& analysis, const SceneBuffers& scene) {
  program_.set("u_light", unit_light(scene.local_from_world() * analysis.light));
  glm::vec2 cosines(-2.0f);
  glm::vec3 axis(0.0f);
  const LightSettings& light = analysis.experiment.light;
  const glm::dvec3 to_target = light.target - light.position;
  if (light.type == LightType::spot && glm::length(to_target) > 0.0) {
    const double half = glm::radians(0.5 * light.cone_deg);
    axis = glm::vec3(glm::normalize(to_target));
    cosines = glm::vec2(std::cos(half), std::cos(half - std::min(kConeEdge, 0.2 * half)));
  }
  program_.set("u_spot_axis", axis);
  program_.set("u_spot_cosines", cosines);
}

void ScenePass::draw(const ViewPicture& picture, const Analysis& analysis, const SceneBuffers& scene, const ShadowPass& map,
                     double scale, Theme theme) {
  const bool projective = picture.scene == ScenePicture::projective;
  const glm::dmat4 clip_from_local = picture.clip_from_world * scene.world_from_local();
  const auto clip = narrow(clip_from_local);
  const auto cube = narrow(picture.cube_from_world * scene.world_from_local());
  if (!clip || (projective && !cube)) return;

  program_.use();
  program_.set("u_clip_from_local", *clip);
  program_.set("u_cube_from_local", cube.value_or(glm::mat4(1.0f)));
  program_.set("u_cube_limit", projective ? float(picture.cube_limit) : 0.0f);
  program_.set("u_ground", ground_color(theme));
  program_.set("u_point_size", float(kPointSize * scale));
  program_.set("u_texture", 0);
  program_.set("u_map", 1);
  program_.set("u_map_from_local", std::span<const glm::mat4>(map.maps_from_local()));
  program_.set("u_map_count", int(map.maps_from_local().size()));
  map.bind_for_comparison(1);
  set_light(analysis, scene);

  const bool clockwise = front_is_clockwise(clip_from_local);
  draw_batches(scene, 1.0f, clockwise);
  if (projective) draw_batches(scene, -1.0f, !clockwise);
}

void ScenePass::draw_batches(const SceneBuffers& scene, float sign, bool clockwise_front) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kPushBack, 1.0f);
  glFrontFace(clockwise_front ? GL_CW : GL_CCW);
  program_.set("u_sign", sign);
  scene.bind();
  for (const Batch& batch : scene.batches()) {
    program_.set("u_has_surface", batch.primitive == Primitive::triangles ? 1 : 0);
    scene.bind_material(batch, program_);
    scene.draw(batch);
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
}

MapPass::MapPass(const std::filesystem::path& shaders)
    : program_(shaders, "map_depth", "map_depth"),
      corners_(sizeof(MapCorner), {{0, 4, offsetof(MapCorner, clip)}, {1, 2, offsetof(MapCorner, map)}}) {}

void MapPass::draw(const ViewPicture& picture, const ShadowPass& map, double scale, Theme theme) {
  const auto clip = narrow(picture.clip_from_list);
  if (!clip || map.layers() == 0) return;
  const float half_height = map.layers() == 6 ? 2.0f / 3.0f : 1.0f;
  const auto corner = [&](float u, float v) {
    return MapCorner{*clip * glm::vec4(2.0f * u - 1.0f, (2.0f * v - 1.0f) * half_height, 0.0f, 1.0f), {u, v}};
  };
  const std::array<MapCorner, 6> corners{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)};
  program_.use();
  program_.set("u_map", 0);
  program_.set("u_depth_range", depth_range_);
  program_.set("u_tiles", map.layers() == 6 ? glm::vec2(3.0f, 2.0f) : glm::vec2(1.0f));
  program_.set("u_ground", ground_color(theme));
  program_.set("u_scale", float(scale));
  map.bind_for_reading(0);
  glDisable(GL_DEPTH_TEST);
  corners_.upload(std::span<const MapCorner>(corners));
  corners_.draw_triangles();
}

}  // namespace psm::gl
