// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of damaged files, the same ones in every run: each is either refused with one line or read into a scene whose every
// index and number is good. Worth most under the asan preset. PSMLAB_FUZZ_ROUNDS=N asks for N times as many.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "gltf_test_support.h"

namespace psm {
namespace {

using test::TempFolder;

/// Engine numbers are the same everywhere, distributions are not: so modulo.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  std::size_t below(std::size_t n) { return n ? engine_() % n : 0; }

 private:
  std::mt19937 engine_;
};

void flip_bits(std::string& bytes, Dice& dice) {
  for (std::size_t n = 1 + dice.below(4); n > 0 && !bytes.empty(); --n) {
    char& c = bytes[dice.below(bytes.size())];
    c = char(std::uint8_t(c) ^ 1u << dice.below(8));
  }
}

void cut(std::string& bytes, Dice& dice) {
  const std::size_t first = dice.below(bytes.size() + 1);
  bytes.erase(first, dice.below(3) ? dice.below(40) : std::string::npos);
}

void repeat_a_part(std::string& bytes, Dice& dice) {
  const std::string part = bytes.substr(dice.below(bytes.size() + 1), 1 + dice.below(60));
  bytes.insert(dice.below(bytes.size() + 1), part);
}

/// One number of the text becomes one that readers stumble over, or another number of the text.
void swap_number(std::string& text, Dice& dice) {
  static const char* const odd[] = {"-1",         "0",
                                    "1",          "2",
                                    "3",          "255",
                                    "65535",      "65536",
                                    "2147483647", "-0",
                                    "2147483648", "4294967295",
                                    "4294967296", "9007199254740991",
                                    "1e300",      "-1e30",
                                    "0.5",        "18446744073709551615",
                                    "[]",         "{}",
                                    "null",       "\"\"",
                                    "5120",       "5126",
                                    "1e-300"};
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t first = text.find_first_of("0123456789", i);
    if (first == std::string::npos) break;
    i = std::min(text.find_first_not_of("0123456789.", first), text.size());
    const char before = first ? text[first - 1] : ' ';
    if (before == ' ' || before == ':' || before == ',' || before == '[') numbers.emplace_back(first, i - first);
  }
  if (numbers.empty()) return;
  const auto [first, size] = numbers[dice.below(numbers.size())];
  const auto [other, other_size] = numbers[dice.below(numbers.size())];
  const std::string value = dice.below(3) ? odd[dice.below(std::size(odd))] : text.substr(other, other_size);
  text.replace(first, size, value);
}

void damage(std::string& text, Dice& dice) {
  for (std::size_t n = 1 + dice.below(3); n > 0; --n) {
    const std::size_t kind = dice.below(10);
    if (kind < 6) swap_number(text, dice);
    if (kind == 6 || kind == 7) flip_bits(text, dice);
    if (kind == 8) cut(text, dice);
    if (kind == 9) repeat_a_part(text, dice);
  }
}

std::uint32_t u32_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t value;
  std::memcpy(&value, &bytes[offset], 4);
  return value;
}

void put_u32(std::string& bytes, std::size_t offset, std::size_t value) {
  const auto narrowed = std::uint32_t(value);
  std::memcpy(&bytes[offset], &narrowed, 4);
}

/// Half of the time the JSON chunk alone, with the lengths put right, so that the damage gets past the container.
void damage_glb(std::string& bytes, Dice& dice) {
  if (dice.below(2)) return dice.below(4) ? flip_bits(bytes, dice) : cut(bytes, dice);
  const std::size_t size = u32_at(bytes, 12);
  std::string text = bytes.substr(20, size);
  damage(text, dice);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  bytes.replace(20, size, text);
  put_u32(bytes, 12, text.size());
  put_u32(bytes, 8, bytes.size());
}

/// Texture, colours, camera, light, lines and points in one small .glb.
std::string small_glb() {
  Scene scene;
  scene.textures.push_back({2, 2, std::vector<std::uint8_t>(16, 77), Wrap::repeat, Wrap::clamp, true});
  scene.materials.push_back({glm::vec4(1.0f), 0, 0.5f, true});
  Mesh mesh;
  mesh.name = "all";
  mesh.positions = {{1e7, 0, 0}, {1e7 + 1, 0, 0}, {1e7, 1, 0}};
  mesh.normals.assign(3, glm::vec3(0, 0, 1));
  mesh.texcoords.assign(3, glm::vec2(0.5f));
  mesh.colors.assign(3, glm::vec4(0.5f));
  mesh.triangles = {0, 1, 2};
  mesh.lines = {0, 1};
  mesh.points = {2};
  scene.meshes.push_back(mesh);
  update_bounds(scene);
  scene.camera = CameraSettings{};
  scene.light = LightSettings{LightType::spot, {0, 1, 0}, {0, 4, 0}, {0, 0, 0}, 60};
  const TempFolder folder;
  EXPECT_FALSE(write_glb(scene, folder.path() / "small.glb"));
  return test::bytes_of(folder.path() / "small.glb");
}

template <class T>
bool empty_or(const std::vector<T>& values, std::size_t count) {
  return values.empty() || values.size() == count;
}

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void expect_sound(const Mesh& mesh, const Scene& scene) {
  const std::size_t count = mesh.positions.size();
  for (const auto* indices : {&mesh.triangles, &mesh.lines, &mesh.points})
    for (const std::uint32_t i : *indices) ASSERT_LT(i, count);
  ASSERT_EQ(mesh.triangles.size() % 3, 0u);
  ASSERT_EQ(mesh.lines.size() % 2, 0u);
  ASSERT_TRUE(empty_or(mesh.normals, count) && empty_or(mesh.texcoords, count) && empty_or(mesh.colors, count));
  ASSERT_TRUE(mesh.triangles.empty() || mesh.normals.size() == count);
  ASSERT_TRUE(mesh.material >= 0 && std::size_t(mesh.material) < scene.materials.size());
  for (const auto& p : mesh.positions) ASSERT_TRUE(finite(p));
  for (const auto& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-3f);
  for (const auto& t : mesh.texcoords) ASSERT_TRUE(std::isfinite(t.x) && std::isfinite(t.y));
  for (const auto& c : mesh.colors)
    ASSERT_TRUE(glm::all(glm::greaterThanEqual(c, glm::vec4(0))) && glm::all(glm::lessThanEqual(c, glm::vec4(1))));
}

void expect_sound(const Scene& scene) {
  ASSERT_FALSE(scene.materials.empty());
  ASSERT_FALSE(scene.meshes.empty());
  for (const Mesh& mesh : scene.meshes) expect_sound(mesh, scene);
  for (const Material& m : scene.materials) ASSERT_TRUE(m.texture >= -1 && m.texture < int(scene.textures.size()));
  for (const Texture& t : scene.textures) ASSERT_EQ(t.rgba.size(), std::size_t(t.width) * std::size_t(t.height) * 4);
  if (scene.camera) {
    ASSERT_TRUE(finite(scene.camera->position) && finite(scene.camera->target) && scene.camera->target != scene.camera->position);
    ASSERT_TRUE(scene.camera->near > 0 && scene.camera->far > scene.camera->near);
  }
  if (scene.light) {
    ASSERT_TRUE(finite(scene.light->to_light) && glm::length(scene.light->to_light) > 0);
    ASSERT_TRUE(finite(scene.light->position) && finite(scene.light->target));
    ASSERT_TRUE(scene.light->cone_deg > 0 && scene.light->cone_deg < 180);
  }
}

void read_damaged(const std::filesystem::path& file, int& refused, int& read) {
  const Result<Scene> scene = read_gltf(file);
  if (scene) {
    ++read;
    return expect_sound(*scene);
  }
  ++refused;
  const std::string& text = scene.error().text;
  ASSERT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7F; })) << text;
  ASSERT_LT(text.size(), 700u) << text;
}

class Fuzz : public testing::TestWithParam<const char*> {};

TEST_P(Fuzz, DamagedFilesAreRefusedOrSound) {
  const std::string name = GetParam();
  const bool glb = name == "small.glb";
  const std::string good = glb ? small_glb() : test::bytes_of(test::data_file(name));
  const TempFolder folder;
  for (const char* beside : {"checker.png", "modes buffer.bin"}) folder.write(beside, test::bytes_of(test::data_file(beside)));

  const char* more = std::getenv("PSMLAB_FUZZ_ROUNDS");
  const int rounds = 800 * (more ? std::max(1, std::atoi(more)) : 1);
  Dice dice(12345);
  int refused = 0, read = 0;
  for (int round = 0; round < rounds && !testing::Test::HasFatalFailure(); ++round) {
    SCOPED_TRACE(name + ", round " + std::to_string(round));
    std::string bytes = good;
    glb ? damage_glb(bytes, dice) : damage(bytes, dice);
    read_damaged(folder.write(glb ? "f.glb" : "f.gltf", bytes), refused, read);
  }
  EXPECT_GT(refused, rounds / 10);  // else the damage does nothing
  EXPECT_GT(read, rounds / 50);     // else it never gets deep
}

INSTANTIATE_TEST_SUITE_P(Gltf, Fuzz,
                         testing::Values("modes.gltf", "packed.gltf", "textured.gltf", "posed.gltf", "lit.gltf", "small.glb"),
                         [](const auto& test_info) {
                           std::string name = test_info.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace psm
