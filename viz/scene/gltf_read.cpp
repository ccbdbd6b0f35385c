// SPDX-License-Identifier: GPL-3.0-or-later
// read_gltf: the parts in their order, and the one place where what they refuse becomes an InputError.
#include <tiny_gltf.h>

#include <algorithm>
#include <limits>
#include <new>

#include "scene/gltf_reader.h"

namespace psm {
namespace gltf {
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t(4) << 30;
constexpr std::uint64_t kMostMeshes = 1'000'000, kMostVertices = 50'000'000, kMostIndices = 300'000'000, kMostPixels = 1 << 28;

void charge(std::uint64_t& total, std::uint64_t count, std::uint64_t limit, const std::string& place, const char* what) {
  total += std::min(count, limit + 1);
  if (total > limit)
    fail(place, std::string("brings the scene, with all its instances, above ") + std::to_string(limit) + " " + what +
                    ", the most that is read");
}

SharedBytes load_buffer(const BufferSource& buffer, std::size_t index, const Container& container, UriReader& uris) {
  const std::string place = at("buffers", index);
  if (!buffer.uri && (index != 0 || !container.bin))
    fail(place, "has no uri; only the first buffer of a .glb with a binary chunk may lack one");
  SharedBytes bytes = buffer.uri ? uris.read(*buffer.uri, place + ".uri") : container.bin;
  if (bytes->size() < buffer.byte_length)
    fail(place + ".byteLength",
         "is " + std::to_string(buffer.byte_length) + "; the data has " + std::to_string(bytes->size()) + " bytes");
  // What is past the declared length is not the buffer's.
  if (bytes->size() > buffer.byte_length)
    bytes =
        std::make_shared<const SharedBytes::element_type>(bytes->begin(), bytes->begin() + std::ptrdiff_t(buffer.byte_length));
  return bytes;
}

std::string one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return printable(text, 200);
}

void parse_model(const std::string& json, tinygltf::Model& model) {
  if (json.size() > std::numeric_limits<unsigned>::max()) throw Problem{"has more than 4 GB of JSON"};
  tinygltf::TinyGLTF parser;
  std::string error, warning;
  if (!parser.LoadASCIIFromString(&model, &error, &warning, json.c_str(), unsigned(json.size()), ""))
    throw Problem{"is not usable glTF: " + one_line(error)};
}

void build_scene(Source& source, Scene& scene) {
  check_accessors(source);
  const NodeGraph graph = walk_nodes(source.model);
  charge_meshes(source, graph);
  const auto texcoords = read_materials(source, scene);
  for (const int node : graph.order) read_node_meshes(source, graph, node, texcoords, scene);
  if (scene.meshes.empty())
    throw Problem{"has nothing to show: no whole triangle, line or point hangs in the nodes of its scene"};
  update_bounds(scene);
  read_camera_and_light(source, graph, scene);
}

Scene read_scene(const std::filesystem::path& file) {
  const Container container = open_container(read_file(file, kLargestFile), file);
  const CheckedDocument document = check_document(container.json);
  UriReader uris(file.parent_path());
  tinygltf::Model model;
  parse_model(document.json, model);
  Source source{model, {}, document.images, uris, {}, {}};
  for (std::size_t i = 0; i < document.buffers.size(); ++i)
    source.buffers.push_back(load_buffer(document.buffers[i], i, container, uris));

  Scene scene;
  scene.id = file.filename().string();
  if (document.animated) source.notes.add("gltf_animation", "The file's animations are not played.");
  build_scene(source, scene);
  scene.notes = source.notes.take();
  return scene;
}

}  // namespace

void Notes::add(const std::string& code, const std::string& text) {
  if (count_[code]++ == 0) notes_.push_back({code, text, std::nullopt, std::nullopt});
}

std::vector<Note> Notes::take() {
  for (Note& note : notes_)
    if (const int more = count_[note.code] - 1; more > 0 && note.text.find('[') != std::string::npos)
      note.text += " (And " + std::to_string(more) + " more like this.)";
  return std::move(notes_);
}

void Budget::add_mesh(const std::string& place) { charge(meshes_, 1, kMostMeshes, place, "meshes"); }
void Budget::add_vertices(std::uint64_t count, const std::string& place) {
  charge(vertices_, count, kMostVertices, place, "vertices");
}
void Budget::add_indices(std::uint64_t count, const std::string& place) {
  charge(indices_, count, kMostIndices, place, "indices");
}
void Budget::add_pixels(std::uint64_t count, const std::string& place) {
  charge(pixels_, count, kMostPixels, place, "texture pixels");
}

}  // namespace gltf

Result<Scene> read_gltf(const std::filesystem::path& file) {
  const std::string name = gltf::shown(file) + ": ";
  try {
    return gltf::read_scene(file);
  } catch (const gltf::Problem& problem) {
    return InputError{name + problem.text};
  } catch (const std::bad_alloc&) {
    return InputError{name + "does not fit into memory"};
  } catch (const std::exception& error) {
    return InputError{name + "is not usable glTF: " + gltf::printable(error.what(), 200)};
  }
}

}  // namespace psm
