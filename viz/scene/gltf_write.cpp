// SPDX-License-Identifier: GPL-3.0-or-later
// write_glb: one node and mesh for each of the scene's meshes, one node each for camera and light.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "scene/experiment_file.h"
#include "scene/gltf_reader.h"

namespace psm {
namespace gltf {
namespace {

using json = nlohmann::ordered_json;

enum Target { kNoTarget = 0, kVertices = 34962, kIndices = 34963 };
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kModePoints = 0, kModeLines = 1, kModeTriangles = 4;

json list(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Collects the binary chunk and the members that describe it.
class Binary {
 public:
  Bytes bytes;
  json views = json::array(), accessors = json::array();

  template <class T>
  int add_view(const std::vector<T>& data, Target target) {
    json view = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size() * sizeof(T)}};
    if (target != kNoTarget) view["target"] = int(target);
    const auto* first = reinterpret_cast<const std::uint8_t*>(data.data());
    bytes.insert(bytes.end(), first, first + data.size() * sizeof(T));
    bytes.resize((bytes.size() + 3) / 4 * 4, 0);
    views.push_back(std::move(view));
    return int(views.size()) - 1;
  }

  template <class T>
  int add_accessor(const std::vector<T>& data, int component_type, const char* type, Target target) {
    accessors.push_back(
        {{"bufferView", add_view(data, target)}, {"componentType", component_type}, {"count", data.size()}, {"type", type}});
    return int(accessors.size()) - 1;
  }

  int add_positions(const std::vector<glm::vec3>& positions) {
    glm::vec3 min = positions[0], max = positions[0];
    for (const auto& p : positions) min = glm::min(min, p), max = glm::max(max, p);
    const int accessor = add_accessor(positions, kFloat, "VEC3", kVertices);
    accessors.back()["min"] = list(min);
    accessors.back()["max"] = list(max);
    return accessor;
  }

  /// Two bytes each where the largest index allows; 65535 itself would restart a primitive.
  int add_indices(const std::vector<std::uint32_t>& indices) {
    if (*std::max_element(indices.begin(), indices.end()) >= 65535)
      return add_accessor(indices, kUnsignedInt, "SCALAR", kIndices);
    return add_accessor(std::vector<std::uint16_t>(indices.begin(), indices.end()), kUnsignedShort, "SCALAR", kIndices);
  }
};

/// What a mesh's node is moved by, so that float positions around it lose no more than a few bits: far from the origin the middle
/// of the mesh, else nothing.
glm::dvec3 origin_of(const Mesh& mesh) {
  Bounds bounds;
  for (const auto& p : mesh.positions) bounds.add(p);
  const glm::dvec3 center = 0.5 * bounds.min + 0.5 * bounds.max;
  return glm::length(center) > 4.0 * glm::length(bounds.max - bounds.min) ? center : glm::dvec3(0.0);
}

std::vector<glm::vec3> floats_around(const std::vector<glm::dvec3>& positions, const glm::dvec3& origin) {
  std::vector<glm::vec3> out;
  out.reserve(positions.size());
  for (const auto& p : positions) out.push_back(glm::vec3(p - origin));
  return out;
}

class Writer {
 public:
  explicit Writer(const Scene& scene) : scene_(scene) {}

  std::string glb() {
    write_textures();
    write_materials();
    for (const Mesh& mesh : scene_.meshes) write_mesh(mesh);
    if (scene_.camera) write_camera(*scene_.camera);
    if (scene_.light) write_light(*scene_.light);
    return packed();
  }

 private:
  const Scene& scene_;
  Binary binary_;
  json root_ = {{"asset", {{"version", "2.0"}, {"generator", "psmlab"}}}};
  json nodes_ = json::array(), meshes_ = json::array(), materials_ = json::array();
  json textures_ = json::array(), images_ = json::array(), samplers_ = json::array();
  std::vector<int> texture_index_;  // of each Scene texture, -1: it has no pixels

  void write_textures() {
    for (const Texture& texture : scene_.textures) {
      const bool usable = texture.width > 0 && texture.height > 0 &&
                          texture.rgba.size() == std::size_t(texture.width) * std::size_t(texture.height) * 4;
      texture_index_.push_back(usable ? int(textures_.size()) : -1);
      if (!usable) continue;
      textures_.push_back({{"source", images_.size()}, {"sampler", samplers_.size()}});
      images_.push_back({{"bufferView", binary_.add_view(encode_png(texture), kNoTarget)}, {"mimeType", "image/png"}});
      samplers_.push_back(sampler(texture));
    }
  }

  static json sampler(const Texture& texture) {
    const auto wrap = [](Wrap w) { return w == Wrap::repeat ? 10497 : (w == Wrap::clamp ? 33071 : 33648); };
    return {{"magFilter", texture.nearest ? 9728 : 9729},
            {"minFilter", texture.nearest ? 9728 : 9987},
            {"wrapS", wrap(texture.wrap_u)},
            {"wrapT", wrap(texture.wrap_v)}};
  }

  int texture_of(const Material& material) const {
    const bool in_range = material.texture >= 0 && std::size_t(material.texture) < texture_index_.size();
    return in_range ? texture_index_[std::size_t(material.texture)] : -1;
  }

  void write_materials() {
    for (const Material& material : scene_.materials) {
      const glm::vec4 color = glm::clamp(material.base_color, 0.0f, 1.0f);
      json pbr = {{"baseColorFactor", {color.r, color.g, color.b, color.a}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}};
      if (const int texture = texture_of(material); texture >= 0) pbr["baseColorTexture"] = {{"index", texture}};
      json out = {{"pbrMetallicRoughness", std::move(pbr)}};
      if (material.alpha_cutoff > 0.0f) out["alphaMode"] = "MASK", out["alphaCutoff"] = material.alpha_cutoff;
      if (material.double_sided) out["doubleSided"] = true;
      materials_.push_back(std::move(out));
    }
  }

  bool textured(const Mesh& mesh) const {
    return mesh.material >= 0 && std::size_t(mesh.material) < scene_.materials.size() &&
           texture_of(scene_.materials[std::size_t(mesh.material)]) >= 0;
  }

  json attributes_of(const Mesh& mesh, const glm::dvec3& origin) {
    const std::size_t count = mesh.positions.size();
    json attributes = {{"POSITION", binary_.add_positions(floats_around(mesh.positions, origin))}};
    if (mesh.normals.size() == count) attributes["NORMAL"] = binary_.add_accessor(mesh.normals, kFloat, "VEC3", kVertices);
    if (mesh.texcoords.size() == count)
      attributes["TEXCOORD_0"] = binary_.add_accessor(mesh.texcoords, kFloat, "VEC2", kVertices);
    else if (textured(mesh))  // the format demands coordinates here; zeros are what a draw without them sees
      attributes["TEXCOORD_0"] = binary_.add_accessor(std::vector<glm::vec2>(count, glm::vec2(0.0f)), kFloat, "VEC2", kVertices);
    if (mesh.colors.size() == count)
      attributes["COLOR_0"] = binary_.add_accessor(clamped(mesh.colors), kFloat, "VEC4", kVertices);
    return attributes;
  }

  static std::vector<glm::vec4> clamped(std::vector<glm::vec4> colors) {
    for (auto& c : colors) c = glm::clamp(c, 0.0f, 1.0f);
    return colors;
  }

  void write_mesh(const Mesh& mesh) {
    if (mesh.positions.empty() || (mesh.triangles.empty() && mesh.lines.empty() && mesh.points.empty())) return;
    const glm::dvec3 origin = origin_of(mesh);
    const json attributes = attributes_of(mesh, origin);
    json primitives = json::array();
    const auto add = [&](const std::vector<std::uint32_t>& indices, int mode) {
      if (indices.empty()) return;
      json primitive = {{"attributes", attributes}, {"indices", binary_.add_indices(indices)}, {"mode", mode}};
      if (mesh.material >= 0 && std::size_t(mesh.material) < scene_.materials.size()) primitive["material"] = mesh.material;
      primitives.push_back(std::move(primitive));
    };
    add(mesh.triangles, kModeTriangles);
    add(mesh.lines, kModeLines);
    add(mesh.points, kModePoints);
    json node = {{"mesh", meshes_.size()}};
    if (!mesh.name.empty()) node["name"] = mesh.name;
    if (origin != glm::dvec3(0.0)) node["translation"] = list(origin);
    nodes_.push_back(std::move(node));
    meshes_.push_back({{"primitives", std::move(primitives)}});
  }

  /// The turn that points a node's -z along `forward`, its y towards `up`.
  static json rotation(const glm::dvec3& forward, const glm::dvec3& up) {
    const glm::dvec3 z = -glm::normalize(forward);
    glm::dvec3 x = glm::cross(up, z);
    if (!(glm::length(x) > 1e-9 * glm::length(up)))
      x = glm::cross(std::abs(z.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1), z);
    x = glm::normalize(x);
    const glm::dquat q = glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z)));
    return {q.x, q.y, q.z, q.w};
  }

  void write_camera(const CameraSettings& camera) {
    json view = {{"yfov", glm::radians(camera.vertical_fov_deg)}, {"znear", camera.near}};
    if (std::isfinite(camera.far)) view["zfar"] = camera.far;
    root_["cameras"] = json::array({{{"type", "perspective"}, {"perspective", std::move(view)}}});
    nodes_.push_back({{"name", "camera"},
                      {"camera", 0},
                      {"translation", list(camera.position)},
                      {"rotation", rotation(camera.target - camera.position, camera.up)}});
  }

  void write_light(const LightSettings& light) {
    const char* const names[] = {"directional", "point", "spot"};
    json out = {{"type", names[int(light.type)]}, {"intensity", intensity(light)}};
    if (light.type == LightType::spot) out["spot"] = {{"outerConeAngle", glm::radians(0.5 * light.cone_deg)}};
    root_["extensionsUsed"] = json::array({"KHR_lights_punctual"});
    root_["extensions"] = {{"KHR_lights_punctual", {{"lights", json::array({std::move(out)})}}}};

    json node = {{"name", "light"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
    const glm::dvec3 up(0.0, 1.0, 0.0);
    if (light.type != LightType::directional) node["translation"] = list(light.position);
    if (light.type == LightType::directional) node["rotation"] = rotation(-light.to_light, up);
    if (light.type == LightType::spot) node["rotation"] = rotation(light.target - light.position, up);
    nodes_.push_back(std::move(node));
  }

  /// psmlab has no intensities; other programs show the scene's middle about as bright for each type of light (lux, candela).
  double intensity(const LightSettings& light) const {
    const double lux = 3.0;
    if (light.type == LightType::directional || scene_.bounds.empty()) return lux;
    const glm::dvec3 d = 0.5 * scene_.bounds.min + 0.5 * scene_.bounds.max - light.position;
    const double candela = lux * glm::dot(d, d);
    return candela > 0.0 ? candela : lux;
  }

  /// Empty arrays are not valid glTF.
  void take(const char* key, json& array) {
    if (!array.empty()) root_[key] = std::move(array);
  }

  std::string packed() {
    json nodes = json::array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) nodes.push_back(i);
    if (!nodes.empty()) {
      root_["scene"] = 0;
      root_["scenes"] = json::array({{{"nodes", std::move(nodes)}}});
    }
    if (!binary_.bytes.empty()) root_["buffers"] = json::array({{{"byteLength", binary_.bytes.size()}}});
    take("nodes", nodes_);
    take("meshes", meshes_);
    take("materials", materials_);
    take("textures", textures_);
    take("images", images_);
    take("samplers", samplers_);
    take("accessors", binary_.accessors);
    take("bufferViews", binary_.views);
    return with_header(root_.dump(-1, ' ', false, json::error_handler_t::replace));
  }

  std::string with_header(std::string text) const {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const bool has_bin = !binary_.bytes.empty();
    const std::uint64_t total = 12 + 8 + text.size() + (has_bin ? 8 + binary_.bytes.size() : 0);
    if (total > 0xFFFFFFFFu) throw Problem{"would have " + std::to_string(total) + " bytes; a .glb holds at most 4294967295"};
    std::string out = "glTF" + u32(2) + u32(total) + u32(text.size()) + "JSON" + text;
    if (has_bin)
      out += u32(binary_.bytes.size()) + std::string("BIN\0", 4) + std::string(binary_.bytes.begin(), binary_.bytes.end());
    return out;
  }

  static std::string u32(std::uint64_t value) {
    std::string out;
    for (int shift = 0; shift < 32; shift += 8) out += char(value >> shift & 0xFF);
    return out;
  }
};

}  // namespace
}  // namespace gltf

std::optional<InputError> write_glb(const Scene& scene, const std::filesystem::path& file) {
  try {
    return write_file_atomically(file, gltf::Writer(scene).glb());
  } catch (const gltf::Problem& problem) {
    return InputError{gltf::shown(file) + ": " + problem.text};
  }
}

}  // namespace psm
