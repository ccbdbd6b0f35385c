// SPDX-License-Identifier: GPL-3.0-or-later
// What the glTF tests share: a folder that vanishes, the files in data/, and meshes by name.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "scene/scene.h"

namespace psm::test {

class TempFolder {
 public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "psm_gltf_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::filesystem::path data_file(const std::string& name) {
  return std::filesystem::path(PSMLAB_TEST_DATA) / "scene" / "data" / name;
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline Scene read_or_fail(const std::filesystem::path& file) {
  Result<Scene> scene = read_gltf(file);
  if (scene) return *scene;
  ADD_FAILURE() << scene.error().text;
  return {};
}

inline const Mesh& mesh_named(const Scene& scene, const std::string& name) {
  static const Mesh none;
  for (const Mesh& mesh : scene.meshes)
    if (mesh.name == name) return mesh;
  ADD_FAILURE() << "no mesh is called " << name;
  return none;
}

inline const Note* note_of(const Scene& scene, const std::string& code) {
  for (const Note& note : scene.notes)
    if (note.code == code) return &note;
  return nullptr;
}

/// The corner of triangle `t`, going through the indices.
inline glm::dvec3 corner(const Mesh& mesh, std::size_t t, std::size_t c) {
  return mesh.positions.at(mesh.triangles.at(3 * t + c));
}

/// Of all triangles; for flat meshes its direction is the side that is the front.
inline glm::dvec3 area_vector(const Mesh& mesh) {
  glm::dvec3 sum(0.0);
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t)
    sum += 0.5 * glm::cross(corner(mesh, t, 1) - corner(mesh, t, 0), corner(mesh, t, 2) - corner(mesh, t, 0));
  return sum;
}

}  // namespace psm::test
