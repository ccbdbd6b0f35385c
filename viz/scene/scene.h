// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn and casts shadows: world-space triangles, as posed, with their materials.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geom/point_hulls.h"
#include "scene/experiment.h"
#include "scene/result.h"

namespace psm {

enum class Wrap { repeat, clamp, mirror };

/// 8-bit sRGB colour, 8-bit linear alpha; rows top to bottom.
struct Texture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // width * height * 4
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool nearest = false;
};

struct Material {
  glm::vec4 base_color{0.8f, 0.8f, 0.8f, 1.0f};  // linear
  int texture = -1;                              // index into Scene::textures, -1: none
  float alpha_cutoff = 0.0f;                     // fragments with less alpha are dropped; 0: opaque
  bool double_sided = false;
};

/// One batch of one material. Positions in world space, double; every array but `positions` may be empty.
/// Indices are valid by construction (checked by whoever builds the mesh).
struct Mesh {
  std::string name;
  int material = 0;
  std::vector<glm::dvec3> positions;
  std::vector<glm::vec3> normals;        // unit, world space, as many as positions
  std::vector<glm::vec2> texcoords;      // glTF convention: (0, 0) is the top left of the image
  std::vector<glm::vec4> colors;         // linear, multiplies base_color
  std::vector<std::uint32_t> triangles;  // three a triangle, counter-clockwise seen from the front
  std::vector<std::uint32_t> lines;      // two a line; drawn, but cast no shadow
  std::vector<std::uint32_t> points;     // drawn, but cast no shadow
};

/// World-axis box; empty while min > max.
struct Bounds {
  glm::dvec3 min{1e300}, max{-1e300};
  bool empty() const { return min.x > max.x; }
  void add(const glm::dvec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
};

struct Scene {
  std::string id;  // a built-in scene's id, or the file's name without its folder
  std::vector<Texture> textures;
  std::vector<Material> materials;  // never empty
  std::vector<Mesh> meshes;
  Bounds bounds;                         // of all meshes
  PointHulls hulls;                      // a set for each mesh
  std::optional<CameraSettings> camera;  // what the scene brings along as defaults
  std::optional<LightSettings> light;
  std::vector<Note> notes;  // what the loader had to leave out

  std::size_t triangle_count() const;
};

/// Recomputes `bounds` and `hulls` from the positions.
void update_bounds(Scene& scene);

/// A scene that is nothing but its box: one triangle between the corners. For studies of the mathematics alone.
Scene box_scene(const glm::dvec3& min, const glm::dvec3& max);

/// Built-in scenes, made by code: ids in a fixed order, and one by its id (an error lists the ids).
std::vector<std::string> builtin_scene_ids();
Result<Scene> builtin_scene(const std::string& id);

/// glTF 2.0, .gltf or .glb. A file without a perspective camera or without a light leaves `camera` or `light` empty.
Result<Scene> read_gltf(const std::filesystem::path& file);

/// Binary glTF with the scene's meshes, materials, textures, camera and light. Written whole or not at all.
std::optional<InputError> write_glb(const Scene& scene, const std::filesystem::path& file);

/// `source` is a built-in id, or a path (relative ones against `base`). Fills in the defaults a scene without camera or light
/// gets: a camera that sees the whole scene from the front and above, and the default sun.
Result<Scene> load_scene(const std::string& source, const std::filesystem::path& base);

}  // namespace psm
