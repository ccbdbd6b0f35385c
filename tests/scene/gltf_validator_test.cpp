// SPDX-License-Identifier: GPL-3.0-or-later
// What write_glb writes satisfies Khronos' validator: no errors, no warnings. Needs node; npm fetches the validator into the
// build folder once. Skipped, with the reason, where either is missing.
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

#include "gltf_test_support.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
  std::string out = "'";
  for (const char c : path.string()) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

struct Outcome {
  int status = -1;
  std::string output;
};

Outcome run(const std::string& command) {
  Outcome outcome;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return outcome;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) outcome.output.append(buffer, n);
  const int status = pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

/// Where the validator lies, installed on first use; empty, with a reason, where that is not possible.
fs::path validator_folder(std::string& reason) {
  const fs::path source = test::data_file("../gltf_validator").lexically_normal();
  const fs::path folder = fs::path(PSMLAB_PROGRAM).parent_path().parent_path() / "gltf_validator";
  if (run("node --version").status != 0) return reason = "node is not installed", fs::path();
  std::error_code error;
  fs::create_directories(folder, error);
  for (const char* name : {"package.json", "package-lock.json", ".npmrc", "validate.js"})
    fs::copy_file(source / name, folder / name, fs::copy_options::overwrite_existing, error);
  if (error) return reason = "cannot write to " + folder.string() + ": " + error.message(), fs::path();
  if (fs::exists(folder / "node_modules" / "gltf-validator" / "package.json")) return folder;
  const Outcome npm = run("cd " + quoted(folder) + " && timeout 120 npm ci --ignore-scripts --no-audit --no-fund");
  if (npm.status == 0) return folder;
  return reason = "npm could not fetch gltf-validator: " + npm.output.substr(0, 300), fs::path();
}

/// Every member that write_glb can write: textures, cut-outs, colours, lines, points, a far-away mesh, a missing texcoord array.
Scene crowded_scene() {
  Scene scene;
  scene.textures.push_back({3, 1, std::vector<std::uint8_t>(12, 200), Wrap::mirror, Wrap::clamp, true});
  scene.materials.push_back({glm::vec4(0.5f, 2.0f, 0.5f, 1.0f), 0, 0.5f, true});
  scene.materials.push_back({});
  Mesh mesh;
  mesh.name = "all \"arrays\"";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}, {0, 0, 1.0 / 3.0}};
  mesh.normals.assign(4, glm::normalize(glm::vec3(1, 2, 3)));
  mesh.texcoords.assign(4, glm::vec2(0.3f, 1.7f));
  mesh.colors.assign(4, glm::vec4(1.5f, 0.1f, 0.0f, 1.0f));
  mesh.triangles = {0, 1, 2};
  mesh.lines = {0, 1, 1, 3};
  mesh.points = {3};
  scene.meshes.push_back(mesh);
  mesh.texcoords.clear();
  mesh.colors.clear();
  for (auto& p : mesh.positions) p += glm::dvec3(1e9, 0, -1e9);
  scene.meshes.push_back(mesh);
  scene.meshes.push_back({});
  update_bounds(scene);
  return scene;
}

/// Writes many files and remembers their quoted paths.
struct Files {
  test::TempFolder folder;
  std::string arguments;

  void write(const Scene& scene, const std::string& name) {
    const fs::path file = folder.path() / (name + ".glb");
    const auto error = write_glb(scene, file);
    ASSERT_FALSE(error) << error->text;
    arguments += ' ';
    arguments += quoted(file);
  }
};

void write_all(Files& files) {
  for (const std::string& id : builtin_scene_ids()) files.write(*builtin_scene(id), id);
  Scene scene = crowded_scene();
  files.write(scene, "neither camera nor light");
  scene.camera = CameraSettings{{0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 60.0, 0.1, std::numeric_limits<double>::infinity()};
  for (const LightType type : {LightType::directional, LightType::point, LightType::spot}) {
    scene.light = LightSettings{};
    scene.light->type = type;
    files.write(scene, std::string("light ") + name_of(type));
  }
  scene.camera->far = 10.0;
  scene.camera->position = {1, 2, 3};
  files.write(scene, "finite");
}

// One test, so that no two processes fetch the validator at once.
TEST(GltfValidator, HasNothingToSayAboutWhatIsWritten) {
  std::string reason;
  const fs::path validator = validator_folder(reason);
  if (validator.empty()) GTEST_SKIP() << reason;
  const std::string validate = "node " + quoted(validator / "validate.js");

  Files files;
  write_all(files);
  const Outcome good = run(validate + files.arguments);
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.output, "");

  const Outcome bad =
      run(validate + " " + quoted(files.folder.write("bad.gltf", R"({"asset": {"version": "2.0"}, "scene": 3})")));
  EXPECT_EQ(bad.status, 1) << "the validator does see errors";
  EXPECT_NE(bad.output.find("UNRESOLVED_REFERENCE"), std::string::npos) << bad.output;
}

}  // namespace
}  // namespace psm
