// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf_reader.h"

namespace psm {
namespace {

constexpr double kDefaultElevationDeg = 25.0;  // of the default camera above the scene's middle
constexpr double kMargin = 1.05;

/// Least distance from `center` along `backward` at which all corners of the box lie inside a square field of view.
double fitting_distance(const Bounds& bounds, const glm::dvec3& center, const glm::dvec3& right, const glm::dvec3& up,
                        const glm::dvec3& backward, double tan_half_fov) {
  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                       corner & 4 ? bounds.max.z : bounds.min.z);
    const glm::dvec3 d = p - center;
    const double across = std::max(std::abs(glm::dot(d, right)), std::abs(glm::dot(d, up)));
    distance = std::max(distance, glm::dot(d, backward) + kMargin * across / tan_half_fov);
  }
  return distance;
}

/// A scene of one point has no size of its own: its distance from the origin serves, or 1.
double radius_of(const Bounds& bounds, const glm::dvec3& center) {
  const double radius = 0.5 * glm::length(bounds.max - bounds.min);
  if (radius > 0.0) return radius;
  return glm::length(center) > 0.0 ? glm::length(center) : 1.0;
}

CameraSettings default_camera(const Bounds& bounds) {
  CameraSettings camera;
  camera.vertical_fov_deg = 60.0;
  const glm::dvec3 center = bounds.empty() ? glm::dvec3(0.0) : 0.5 * bounds.min + 0.5 * bounds.max;
  const double radius = bounds.empty() ? 1.0 : radius_of(bounds, center);
  const double elevation = glm::radians(kDefaultElevationDeg);
  const glm::dvec3 backward(0.0, std::sin(elevation), std::cos(elevation)), right(1.0, 0.0, 0.0);
  const double fit = bounds.empty() ? 0.0
                                    : fitting_distance(bounds, center, right, glm::cross(backward, right), backward,
                                                       std::tan(glm::radians(0.5 * camera.vertical_fov_deg)));
  const double distance = std::max(fit, 1.1 * radius);  // outside the scene, flat or pointlike as it may be
  camera.position = center + distance * backward;
  camera.target = center;
  camera.far = distance + 1.5 * radius;
  camera.near = camera.far / 1000.0;
  return camera;
}

std::string joined_ids() {
  std::string out;
  for (const auto& id : builtin_scene_ids()) out += (out.empty() ? "" : ", ") + id;
  return out;
}

Result<Scene> scene_from(const std::string& source, const std::filesystem::path& base) {
  const auto ids = builtin_scene_ids();
  if (std::find(ids.begin(), ids.end(), source) != ids.end()) return builtin_scene(source);
  const std::filesystem::path file = base / std::filesystem::path(source);
  std::error_code error;
  if (source.empty() || !std::filesystem::exists(file, error))
    return InputError{"\"" + gltf::shown(source) + "\" is neither a built-in scene nor a file (looked for " + gltf::shown(file) +
                      "); allowed: " + joined_ids() + ", or a .gltf or .glb file"};
  return read_gltf(file);
}

}  // namespace

std::size_t Scene::triangle_count() const {
  std::size_t count = 0;
  for (const Mesh& mesh : meshes) count += mesh.triangles.size() / 3;
  return count;
}

void update_bounds(Scene& scene) {
  scene.bounds = Bounds{};
  for (const Mesh& mesh : scene.meshes)
    for (const auto& p : mesh.positions) scene.bounds.add(p);
  std::vector<std::span<const glm::dvec3>> sets;
  for (const Mesh& mesh : scene.meshes) sets.emplace_back(mesh.positions);
  scene.hulls = point_hulls(sets);
}

Scene box_scene(const glm::dvec3& min, const glm::dvec3& max) {
  Scene scene;
  scene.id = "box";
  scene.materials.resize(1);
  scene.meshes.resize(1);
  scene.meshes[0].positions = {min, max, {min.x, max.y, min.z}};
  scene.meshes[0].triangles = {0, 1, 2};
  update_bounds(scene);
  return scene;
}

Result<Scene> load_scene(const std::string& source, const std::filesystem::path& base) {
  Result<Scene> scene = scene_from(source, base);
  if (!scene) return scene;
  if (scene->bounds.empty()) update_bounds(*scene);
  if (!scene->camera) scene->camera = default_camera(scene->bounds);
  if (!scene->light) scene->light = LightSettings{};
  return scene;
}

}  // namespace psm
