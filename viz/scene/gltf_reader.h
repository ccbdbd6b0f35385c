// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the glTF reader, private to this folder. A file passes through them in this order:
//
//   gltf_file      bytes, the .glb container, URIs            -> JSON text, binary chunk
//   gltf_check     every JSON member that is used, checked    -> JSON text that holds nothing unchecked
//   tinygltf       that text                                  -> tinygltf::Model
//   gltf_accessor  accessors against their buffers            -> numbers
//   gltf_nodes, gltf_material, gltf_mesh, gltf_view           -> Scene
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace tinygltf {
class Model;
}

namespace psm::gltf {

using Bytes = std::vector<std::uint8_t>;
using SharedBytes = std::shared_ptr<const Bytes>;

/// What is wrong with a file. Unwinds to read_gltf, which returns it as an InputError with the file's name before it.
struct Problem {
  std::string text;
};

/// `place` is a JSON path such as "meshes[0].primitives[1].indices", `what` goes on from there.
[[noreturn]] void fail(const std::string& place, const std::string& what);

/// "meshes[3]"
std::string at(const std::string& array, std::size_t index);

/// Text of a file as it may stand in a message: one line of printable characters, not long.
std::string printable(const std::string& text, std::size_t limit = 60);

/// A file's name as it may stand in a message: whole, without control characters.
std::string shown(const std::filesystem::path& file);

// ---- gltf_file.cpp ---------------------------------------------------------------------------------------------------

/// A regular file's bytes; a Problem for folders, pipes, devices, empty files and files above `limit` bytes.
Bytes read_file(const std::filesystem::path& file, std::uint64_t limit);

struct Container {
  std::string json;
  SharedBytes bin;  // null where there is none
};
Container open_container(Bytes bytes, const std::filesystem::path& file);

/// What URIs of one glTF file stand for: data URIs, and files relative to `folder`.
class UriReader {
 public:
  explicit UriReader(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// The same file is read once, however often it is named.
  SharedBytes read(const std::string& uri, const std::string& place);

 private:
  std::filesystem::path folder_;
  std::map<std::string, SharedBytes> files_;
};

// ---- gltf_check.cpp --------------------------------------------------------------------------------------------------

struct BufferSource {
  std::uint64_t byte_length = 0;
  std::optional<std::string> uri;  // none: the binary chunk
};
struct ImageSource {
  std::optional<std::string> uri;
  int buffer_view = -1;
};

/// A document whose members have the right types, whose indices are in range, and which requires nothing that we lack.
/// `json` has neither buffers, images, animations nor extras: the reader fetches the first two itself.
struct CheckedDocument {
  std::string json;
  std::vector<BufferSource> buffers;
  std::vector<ImageSource> images;
  bool animated = false;
};
CheckedDocument check_document(const std::string& json_text);

// ---- what the later parts share --------------------------------------------------------------------------------------

/// Notes for the scene; of many with the same code the first stands for all.
class Notes {
 public:
  void add(const std::string& code, const std::string& text);
  std::vector<Note> take();

 private:
  std::vector<Note> notes_;
  std::map<std::string, int> count_;
};

/// A small file can claim a large scene (instances, strips); these bounds keep it within a few gigabytes.
class Budget {
 public:
  void add_mesh(const std::string& place);
  void add_vertices(std::uint64_t count, const std::string& place);
  void add_indices(std::uint64_t count, const std::string& place);
  void add_pixels(std::uint64_t count, const std::string& place);

 private:
  std::uint64_t meshes_ = 0, vertices_ = 0, indices_ = 0, pixels_ = 0;
};

struct Source {
  const tinygltf::Model& model;
  std::vector<SharedBytes> buffers;
  std::vector<ImageSource> images;
  UriReader& uris;
  Notes notes;
  Budget budget;
};

// ---- gltf_accessor.cpp -----------------------------------------------------------------------------------------------

/// Every buffer view within its buffer, every accessor within its view: afterwards the functions below read in bounds.
void check_accessors(const Source& source);

std::size_t accessor_count(const Source& source, int accessor);

/// Such as "VEC3 FLOAT" or "VEC2 UNSIGNED_BYTE normalized". A Problem unless the accessor's is in `allowed`.
void require_format(const Source& source, int accessor, const std::string& place, const std::vector<std::string>& allowed);

/// components * count numbers; sparse values put in, normalised integers turned into [-1, 1] or [0, 1].
std::vector<double> read_numbers(const Source& source, int accessor);

std::vector<std::uint32_t> read_indices(const Source& source, int accessor);

// ---- gltf_nodes.cpp --------------------------------------------------------------------------------------------------

struct NodeGraph {
  std::vector<glm::dmat4> world_from_node;  // of every node
  std::vector<int> order;                   // the nodes of the scene that is shown, parents first, in file order
};

/// A Problem for cycles, nodes with two parents, and places beyond 1e30.
NodeGraph walk_nodes(const tinygltf::Model& model);

constexpr double kLargestCoordinate = 1e30;
bool within_reach(const glm::dvec3& p);

// ---- gltf_image.cpp --------------------------------------------------------------------------------------------------

struct ImageSize {
  int width = 0, height = 0;
};
/// PNG and JPEG; none, with a reason, for anything else.
std::optional<ImageSize> image_size(const std::uint8_t* bytes, std::size_t size, std::string& reason);
std::optional<std::vector<std::uint8_t>> decode_image(const std::uint8_t* bytes, std::size_t size, std::string& reason);
Bytes encode_png(const Texture& texture);

// ---- gltf_material.cpp -----------------------------------------------------------------------------------------------

/// How a material's texture coordinates come from a mesh's.
struct TexcoordSource {
  int set = 0;
  std::optional<glm::dmat3> uv_from_texcoord;  // KHR_texture_transform
};

/// Fills textures and materials; the last material is glTF's default one. One TexcoordSource for each material.
std::vector<TexcoordSource> read_materials(Source& source, Scene& scene);

// ---- gltf_mesh.cpp ---------------------------------------------------------------------------------------------------

/// A Problem if all meshes with all their instances are beyond the budget: found out before any of them is read.
void charge_meshes(Source& source, const NodeGraph& graph);

/// The meshes of one node, in world space.
void read_node_meshes(Source& source, const NodeGraph& graph, int node, const std::vector<TexcoordSource>& texcoords,
                      Scene& scene);

/// Turns an index list of a glTF primitive mode into separate triangles, lines or points.
void add_topology(int mode, const std::vector<std::uint32_t>& indices, Mesh& mesh);

/// Gives each triangle its own three vertices, with its normal. Meshes without triangles lose their normals.
void make_flat_normals(Mesh& mesh);

// ---- gltf_view.cpp ---------------------------------------------------------------------------------------------------

/// The first perspective camera and the first light in the order of the nodes. Needs the scene's bounds.
void read_camera_and_light(Source& source, const NodeGraph& graph, Scene& scene);

}  // namespace psm::gltf
