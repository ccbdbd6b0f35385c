// SPDX-License-Identifier: GPL-3.0-or-later
// Primitives to world-space meshes.
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "scene/gltf_reader.h"

namespace psm::gltf {
namespace {

constexpr std::size_t kListed = 4;  // how many of several attributes of a kind are looked at

/// One primitive on its way to a Mesh.
struct Reading {
  Source& source;
  const tinygltf::Primitive& primitive;
  std::string place;  // "meshes[0].primitives[1]"
  std::size_t vertex_count = 0;
  std::vector<glm::dvec3> positions, normals;  // of the mesh, later of the world
  bool flipped = false;                        // mirrored by its transformation: triangles turn round

  std::optional<int> attribute(const std::string& name) const {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? std::nullopt : std::optional(found->second);
  }
  std::string path(const std::string& name) const { return place + ".attributes." + name; }
};

/// The numbers of an attribute, as many elements as there are vertices; empty where the primitive has none.
std::vector<double> attribute_numbers(const Reading& r, const std::string& name, const std::vector<std::string>& formats) {
  const auto accessor = r.attribute(name);
  if (!accessor) return {};
  require_format(r.source, *accessor, r.path(name), formats);
  if (accessor_count(r.source, *accessor) != r.vertex_count)
    fail(r.path(name), "has " + std::to_string(accessor_count(r.source, *accessor)) + " elements; POSITION has " +
                           std::to_string(r.vertex_count));
  return read_numbers(r.source, *accessor);
}

std::vector<glm::dvec3> triples(const std::vector<double>& numbers) {
  std::vector<glm::dvec3> out(numbers.size() / 3);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  return out;
}

bool all_finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

void require_positions_within_reach(const Reading& r, const char* space) {
  for (std::size_t i = 0; i < r.positions.size(); ++i)
    if (!within_reach(r.positions[i]))
      fail(r.path("POSITION"), "has no usable position " + std::to_string(i) + space + "; allowed are finite numbers up to 1e30");
}

void read_positions_and_normals(Reading& r) {
  r.positions = triples(
      attribute_numbers(r, "POSITION",
                        {"VEC3 FLOAT", "VEC3 BYTE", "VEC3 BYTE normalized", "VEC3 UNSIGNED_BYTE", "VEC3 UNSIGNED_BYTE normalized",
                         "VEC3 SHORT", "VEC3 SHORT normalized", "VEC3 UNSIGNED_SHORT", "VEC3 UNSIGNED_SHORT normalized"}));
  require_positions_within_reach(r, "");
  r.normals = triples(attribute_numbers(r, "NORMAL", {"VEC3 FLOAT", "VEC3 BYTE normalized", "VEC3 SHORT normalized"}));
}

void read_texcoords(const Reading& r, const TexcoordSource& from, Mesh& mesh) {
  const auto numbers =
      attribute_numbers(r, "TEXCOORD_" + std::to_string(from.set),
                        {"VEC2 FLOAT", "VEC2 BYTE", "VEC2 BYTE normalized", "VEC2 UNSIGNED_BYTE", "VEC2 UNSIGNED_BYTE normalized",
                         "VEC2 SHORT", "VEC2 SHORT normalized", "VEC2 UNSIGNED_SHORT", "VEC2 UNSIGNED_SHORT normalized"});
  mesh.texcoords.resize(numbers.size() / 2);
  bool finite = true;
  for (std::size_t i = 0; i < mesh.texcoords.size(); ++i) {
    glm::dvec3 uv(numbers[2 * i], numbers[2 * i + 1], 1.0);
    if (from.uv_from_texcoord) uv = *from.uv_from_texcoord * uv;
    const bool usable = std::abs(uv.x) <= kLargestCoordinate && std::abs(uv.y) <= kLargestCoordinate;
    finite = finite && usable;
    mesh.texcoords[i] = usable ? glm::vec2(uv) : glm::vec2(0.0f);
  }
  if (!finite) r.source.notes.add("gltf_texcoords", r.place + " has texture coordinates that are not numbers; they count as 0.");
}

void read_colors(const Reading& r, Mesh& mesh) {
  const auto numbers =
      attribute_numbers(r, "COLOR_0",
                        {"VEC3 FLOAT", "VEC4 FLOAT", "VEC3 UNSIGNED_BYTE normalized", "VEC4 UNSIGNED_BYTE normalized",
                         "VEC3 UNSIGNED_SHORT normalized", "VEC4 UNSIGNED_SHORT normalized"});
  const std::size_t components = numbers.size() / r.vertex_count;
  mesh.colors.assign(components ? r.vertex_count : 0, glm::vec4(1.0f));
  for (std::size_t i = 0; i < mesh.colors.size(); ++i)
    for (std::size_t c = 0; c < components; ++c) {
      const double value = numbers[i * components + c];
      mesh.colors[i][int(c)] = std::isnan(value) ? 1.0f : float(std::clamp(value, 0.0, 1.0));
    }
}

/// Transposed inverse up to a positive factor; defined for singular matrices too.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0.0 ? -1.0 * cofactors : cofactors;
}

/// A matrix with entries near 1, so that products of entries neither overflow nor vanish.
glm::dmat3 scaled_linear_part(const glm::dmat4& m) {
  double largest = 0.0;
  for (int c = 0; c < 3; ++c)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[c][row]));
  return largest > 0.0 ? glm::dmat3(m) / largest : glm::dmat3(m);
}

void place_rigid(Reading& r, const glm::dmat4& world_from_node) {
  const glm::dmat3 linear = scaled_linear_part(world_from_node), normals = normal_matrix(linear);
  for (auto& p : r.positions) p = glm::dvec3(world_from_node * glm::dvec4(p, 1.0));
  for (auto& n : r.normals) n = normals * n;
  r.flipped = glm::determinant(linear) < 0.0;
}

// ---- skins -----------------------------------------------------------------------------------------------------------

/// World from bind space, for each joint.
std::vector<glm::dmat4> joint_matrices(const Reading& r, const NodeGraph& graph, int skin_index) {
  const auto& skin = r.source.model.skins[std::size_t(skin_index)];
  const std::string place = at("skins", std::size_t(skin_index)) + ".inverseBindMatrices";
  std::vector<double> inverse_bind;
  if (skin.inverseBindMatrices >= 0) {
    require_format(r.source, skin.inverseBindMatrices, place, {"MAT4 FLOAT"});
    if (accessor_count(r.source, skin.inverseBindMatrices) < skin.joints.size())
      fail(place, "has " + std::to_string(accessor_count(r.source, skin.inverseBindMatrices)) + " matrices for " +
                      std::to_string(skin.joints.size()) + " joints");
    inverse_bind = read_numbers(r.source, skin.inverseBindMatrices);
    if (!all_finite(inverse_bind)) fail(place, "has numbers that are not finite");
  }
  std::vector<glm::dmat4> matrices;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    glm::dmat4 inverse(1.0);
    for (int i = 0; !inverse_bind.empty() && i < 16; ++i) inverse[i / 4][i % 4] = inverse_bind[16 * j + std::size_t(i)];
    matrices.push_back(graph.world_from_node[std::size_t(skin.joints[j])] * inverse);
  }
  return matrices;
}

/// One sum of weighted joint matrices for each vertex, over all sets JOINTS_n, WEIGHTS_n. Empty without such attributes.
std::vector<glm::dmat4> blended_matrices(const Reading& r, const std::vector<glm::dmat4>& joints) {
  std::vector<glm::dmat4> blended;
  std::vector<double> total(r.vertex_count, 0.0);
  for (std::size_t set = 0; set < kListed; ++set) {
    const std::string joints_name = "JOINTS_" + std::to_string(set), weights_name = "WEIGHTS_" + std::to_string(set);
    const auto indices = attribute_numbers(r, joints_name, {"VEC4 UNSIGNED_BYTE", "VEC4 UNSIGNED_SHORT"});
    const auto weights =
        attribute_numbers(r, weights_name, {"VEC4 FLOAT", "VEC4 UNSIGNED_BYTE normalized", "VEC4 UNSIGNED_SHORT normalized"});
    if (indices.empty() || weights.empty()) break;
    blended.resize(r.vertex_count, glm::dmat4(0.0));
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (!(weights[i] > 0.0)) continue;  // unused slots may hold any joint
      if (!std::isfinite(weights[i])) fail(r.path(weights_name), "has a weight that is not finite");
      if (indices[i] >= double(joints.size()))
        fail(r.path(joints_name),
             "holds joint " + std::to_string(int(indices[i])) + "; the skin has " + std::to_string(joints.size()));
      blended[i / 4] += weights[i] * joints[std::size_t(indices[i])];
      total[i / 4] += weights[i];
    }
  }
  for (std::size_t i = 0; i < blended.size(); ++i)
    blended[i] = total[i] > 0.0 ? blended[i] / total[i] : (joints.empty() ? glm::dmat4(1.0) : joints[0]);
  return blended;
}

/// Where the joints put the mesh; the node's own transformation does not count (glTF 2.0, section 3.7.3.1).
bool place_skinned(Reading& r, const NodeGraph& graph, int skin) {
  const auto blended = blended_matrices(r, joint_matrices(r, graph, skin));
  if (blended.empty()) return false;
  std::size_t mirrored = 0;
  for (std::size_t i = 0; i < r.positions.size(); ++i) {
    const glm::dmat3 linear = scaled_linear_part(blended[i]);
    r.positions[i] = glm::dvec3(blended[i] * glm::dvec4(r.positions[i], 1.0));
    if (!r.normals.empty()) r.normals[i] = normal_matrix(linear) * r.normals[i];
    mirrored += glm::determinant(linear) < 0.0;
  }
  r.flipped = 2 * mirrored > r.positions.size();
  r.source.notes.add("gltf_skin", "Skinned meshes stand as the file's nodes pose their joints; they do not move.");
  return true;
}

// ---- putting a mesh together -----------------------------------------------------------------------------------------

std::vector<std::uint32_t> indices_of(Reading& r) {
  std::vector<std::uint32_t> indices;
  if (r.primitive.indices < 0) {
    indices.resize(r.vertex_count);
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = std::uint32_t(i);
    return indices;
  }
  const std::string place = r.place + ".indices";
  require_format(r.source, r.primitive.indices, place, {"SCALAR UNSIGNED_BYTE", "SCALAR UNSIGNED_SHORT", "SCALAR UNSIGNED_INT"});
  indices = read_indices(r.source, r.primitive.indices);
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= r.vertex_count)
      fail(place, "holds " + std::to_string(indices[i]) + " (index " + std::to_string(i) + "); allowed are 0 to " +
                      std::to_string(r.vertex_count - 1));
  return indices;
}

void turn_round(std::vector<std::uint32_t>& triangles) {
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) std::swap(triangles[i + 1], triangles[i + 2]);
}

/// Unit normals as floats; false if one of them is zero or no number.
bool take_normals(const std::vector<glm::dvec3>& normals, Mesh& mesh) {
  mesh.normals.reserve(normals.size());
  for (const auto& n : normals) {
    const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    if (!(largest > 0.0) || !std::isfinite(n.x + n.y + n.z)) return false;
    mesh.normals.push_back(glm::vec3(glm::normalize(n / largest)));
  }
  return true;
}

void finish_normals(const Reading& r, Mesh& mesh) {
  const bool usable = take_normals(r.normals, mesh);
  if (usable && (!mesh.normals.empty() || mesh.triangles.empty())) return;
  if (!usable) r.source.notes.add("gltf_normals", r.place + " has normals of no direction; its faces are drawn flat.");
  r.source.budget.add_vertices(mesh.triangles.size(), r.place);
  make_flat_normals(mesh);
}

void note_leftovers(const Reading& r, std::size_t index_count) {
  const int mode = r.primitive.mode;
  const std::size_t left = mode == TINYGLTF_MODE_TRIANGLES ? index_count % 3 : (mode == TINYGLTF_MODE_LINE ? index_count % 2 : 0);
  if (left)
    r.source.notes.add("gltf_leftover", r.place + " has " + std::to_string(index_count) + " indices; the last " +
                                            std::to_string(left) + " make no whole primitive and are left out.");
}

void read_primitive(Reading& r, const NodeGraph& graph, int node_index, const std::vector<TexcoordSource>& texcoords,
                    Scene& scene) {
  const auto position = r.attribute("POSITION");
  if (!position) return r.source.notes.add("gltf_position", r.place + " has no POSITION and is left out.");
  r.vertex_count = accessor_count(r.source, *position);

  const auto& node = r.source.model.nodes[std::size_t(node_index)];
  Mesh mesh;
  mesh.name = node.name.empty() ? r.source.model.meshes[std::size_t(node.mesh)].name : node.name;
  mesh.material = r.primitive.material >= 0 ? r.primitive.material : int(scene.materials.size()) - 1;
  read_positions_and_normals(r);
  read_texcoords(r, texcoords[std::size_t(mesh.material)], mesh);
  read_colors(r, mesh);
  if (node.skin < 0 || !place_skinned(r, graph, node.skin)) place_rigid(r, graph.world_from_node[std::size_t(node_index)]);
  require_positions_within_reach(r, " in the world");
  if (!r.primitive.targets.empty()) r.source.notes.add("gltf_morph", "Meshes with morph targets are shown in their base shape.");

  const auto indices = indices_of(r);
  note_leftovers(r, indices.size());
  add_topology(r.primitive.mode, indices, mesh);
  if (r.flipped) turn_round(mesh.triangles);
  mesh.positions = std::move(r.positions);
  finish_normals(r, mesh);
  if (!mesh.triangles.empty() || !mesh.lines.empty() || !mesh.points.empty()) scene.meshes.push_back(std::move(mesh));
}

template <class T>
std::vector<T> gathered(const std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<T> out;
  out.reserve(values.empty() ? 0 : indices.size());
  for (std::size_t i = 0; !values.empty() && i < indices.size(); ++i) out.push_back(values[indices[i]]);
  return out;
}

/// Of a triangle of any size; a triangle without area gets some unit vector, as nothing of it is seen.
glm::vec3 face_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a;
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) largest = std::max({largest, std::abs(ab[i]), std::abs(ac[i])});
  if (!(largest > 0.0)) return {0.0f, 1.0f, 0.0f};
  const glm::dvec3 normal = glm::cross(ab / largest, ac / largest);
  const double length = glm::length(normal);
  return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

}  // namespace

void add_topology(int mode, const std::vector<std::uint32_t>& v, Mesh& mesh) {
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh.triangles.insert(mesh.triangles.end(), {a, b, c});  // strips are joined by such ones
  };
  const auto line = [&](std::uint32_t a, std::uint32_t b) { mesh.lines.insert(mesh.lines.end(), {a, b}); };
  const std::size_t n = v.size();
  switch (mode) {
    case TINYGLTF_MODE_POINTS:
      mesh.points = v;
      break;
    case TINYGLTF_MODE_LINE:
      for (std::size_t i = 0; i + 1 < n; i += 2) line(v[i], v[i + 1]);
      break;
    case TINYGLTF_MODE_LINE_LOOP:
    case TINYGLTF_MODE_LINE_STRIP:
      for (std::size_t i = 0; i + 1 < n; ++i) line(v[i], v[i + 1]);
      if (mode == TINYGLTF_MODE_LINE_LOOP && n > 2) line(v[n - 1], v[0]);
      break;
    case TINYGLTF_MODE_TRIANGLE_STRIP:
      for (std::size_t i = 0; i + 2 < n; ++i) triangle(v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]);
      break;
    case TINYGLTF_MODE_TRIANGLE_FAN:
      for (std::size_t i = 0; i + 2 < n; ++i) triangle(v[i + 1], v[i + 2], v[0]);
      break;
    default:
      for (std::size_t i = 0; i + 2 < n; i += 3) triangle(v[i], v[i + 1], v[i + 2]);
  }
}

void make_flat_normals(Mesh& mesh) {
  mesh.normals.clear();
  if (mesh.triangles.empty()) return;
  mesh.positions = gathered(mesh.positions, mesh.triangles);
  mesh.texcoords = gathered(mesh.texcoords, mesh.triangles);
  mesh.colors = gathered(mesh.colors, mesh.triangles);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) mesh.triangles[i] = std::uint32_t(i);
  mesh.normals.reserve(mesh.positions.size());
  for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3)
    mesh.normals.insert(mesh.normals.end(), 3, face_normal(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]));
}

void charge_meshes(Source& source, const NodeGraph& graph) {
  for (const int node : graph.order) {
    const int mesh = source.model.nodes[std::size_t(node)].mesh;
    if (mesh < 0) continue;
    const auto& primitives = source.model.meshes[std::size_t(mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const std::string place = at(at("meshes", std::size_t(mesh)) + ".primitives", i);
      const auto position = primitives[i].attributes.find("POSITION");
      const std::size_t vertices = position == primitives[i].attributes.end() ? 0 : accessor_count(source, position->second);
      source.budget.add_mesh(place);
      source.budget.add_vertices(vertices, place);
      const std::size_t indices = primitives[i].indices < 0 ? vertices : accessor_count(source, primitives[i].indices);
      source.budget.add_indices(3 * std::uint64_t(indices), place);  // what a strip may become
    }
  }
}

void read_node_meshes(Source& source, const NodeGraph& graph, int node, const std::vector<TexcoordSource>& texcoords,
                      Scene& scene) {
  const int mesh = source.model.nodes[std::size_t(node)].mesh;
  if (mesh < 0) return;
  const auto& primitives = source.model.meshes[std::size_t(mesh)].primitives;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    Reading reading{source, primitives[i], at(at("meshes", std::size_t(mesh)) + ".primitives", i), 0, {}, {}, false};
    read_primitive(reading, graph, node, texcoords, scene);
  }
}

}  // namespace psm::gltf
