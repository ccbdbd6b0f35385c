// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/experiment_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "random_experiment.h"

namespace psm {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::RandomExperiment;
using ::testing::StartsWith;

/// A folder of this test's own, gone afterwards.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "psmlab-test-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~Folder() { fs::remove_all(path_); }
  fs::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t entries() const { return std::size_t(std::distance(fs::directory_iterator(path_), fs::directory_iterator())); }

 private:
  fs::path path_;
};

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

Result<LoadedExperiment> parse(const std::string& json, const std::vector<std::string>& overrides = {}) {
  return parse_experiment(json, "test.psm.json", ".", overrides);
}

std::string refusal(const std::string& json) {
  const auto loaded = parse(json);
  return loaded ? "" : loaded.error().text;
}

void expect_same_members(const Experiment& a, const Experiment& b) {
  for (const Field& field : experiment_fields())
    if (field.applies(b)) {
      EXPECT_EQ(value_text(field, a), value_text(field, b)) << field.path;
    }
}

TEST(ExperimentFile, RandomExperimentsRoundTripBitForBit) {
  RandomExperiment random(3);
  for (int round = 0; round < 200; ++round) {
    const Experiment wanted = random();
    const std::string text = experiment_to_json(wanted);
    const auto loaded = parse(text);
    ASSERT_TRUE(loaded) << loaded.error().text << "\n" << text;
    expect_same_members(loaded->experiment, wanted);
    EXPECT_EQ(experiment_to_json(loaded->experiment), text);
  }
}

TEST(ExperimentFile, EmptyObjectIsTheDefault) {
  const auto empty = parse("{}"), none = load_experiment("", {});
  ASSERT_TRUE(empty);
  ASSERT_TRUE(none);
  EXPECT_EQ(empty->experiment, none->experiment);
  EXPECT_EQ(none->experiment.scene.source, "chessboard");
  EXPECT_GT(none->scene.triangle_count(), 100u);
}

TEST(ExperimentFile, AByteOrderMarkIsNoError) { EXPECT_TRUE(parse("\xEF\xBB\xBF{\"psmlab\": 1}")); }

TEST(ExperimentFile, FileGoesOverTheSceneAndOverridesOverTheFile) {
  const auto scene = builtin_scene("chessboard");
  ASSERT_TRUE(scene && scene->camera && scene->light);
  const auto loaded = parse(R"({"camera": {"vertical_fov_deg": 41, "near": 0.25}})", {"camera.near=0.5", "shadow.technique=psm"});
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->experiment.camera.vertical_fov_deg, 41);
  EXPECT_EQ(loaded->experiment.camera.near, 0.5);
  EXPECT_EQ(loaded->experiment.camera.position, scene->camera->position);
  EXPECT_EQ(loaded->experiment.light, *scene->light);
  EXPECT_EQ(loaded->experiment.shadow.technique, Technique::psm);
}

TEST(ExperimentFile, AnotherSceneBringsItsOwnCameraFirst) {
  const auto ground = builtin_scene("ground");
  ASSERT_TRUE(ground && ground->camera);
  const auto by_file = parse(R"({"camera": {"near": 0.01}, "scene": {"source": "ground"}})");
  const auto by_flag = load_experiment("", {"camera.near=0.01", "scene.source=ground"});
  ASSERT_TRUE(by_file && by_flag);
  EXPECT_EQ(by_file->experiment, by_flag->experiment);
  EXPECT_EQ(by_file->experiment.camera.position, ground->camera->position);
  EXPECT_EQ(by_file->experiment.camera.near, 0.01);
  EXPECT_EQ(by_file->scene.id, "ground");
}

TEST(ExperimentFile, SettingTheTypeDropsTheOtherTypesMembers) {
  const auto loaded = load_experiment("chessboard", {"light.type=directional"});
  ASSERT_TRUE(loaded);
  const std::string text = experiment_to_json(loaded->experiment);
  EXPECT_THAT(text, HasSubstr("\"to_light\""));
  EXPECT_EQ(text.find("cone_deg"), std::string::npos);
  EXPECT_EQ(text.find("\"position\""), text.rfind("\"position\""));  // the camera's alone
}

TEST(ExperimentFile, AMemberThatMeansNothingIsNoted) {
  const auto loaded = parse(R"({"light": {"type": "directional", "cone_deg": 20}})");
  ASSERT_TRUE(loaded);
  const auto& notes = loaded->scene.notes;
  ASSERT_FALSE(notes.empty());
  EXPECT_EQ(notes.back().code, "member_dropped");
  EXPECT_THAT(notes.back().text, HasSubstr("light.cone_deg"));
}

TEST(ExperimentFile, BadJsonIsRefusedWithPlaceAndRemedy) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "not JSON"},
      {"{", "line 1"},
      {"[]", "not an object"},
      {"3", "not an object"},
      {"{} {}", "not JSON"},
      {"\x89PNG\r\n\x1a\n", "not JSON"},
      {"{\"camera\": {\"near\": NaN}}", "not JSON"},
      {R"({"psmlab": 2})", "psmlab: 2 is not allowed"},
      {R"({"psmlab": "1"})", "psmlab: \"1\" is not allowed"},
      {R"({"camera": 5})", "camera: 5 is not allowed; allowed: an object"},
      {R"({"camera": null})", "camera: null"},
      {R"({"kamera": {}})", "kamera: no such member; allowed: scene, camera"},
      {R"({"camera": {"fov": 60}})", "camera.fov: no such member"},
      {R"({"camera.near": 1})", "camera.near: no such member"},
      {R"({"camera": {"near": 0}})", "camera.near: 0 is not allowed; allowed: a number in ["},
      {R"({"camera": {"near": "0.1"}})", "camera.near: \"0.1\" is not allowed"},
      {R"({"camera": {"near": "inf"}})", "camera.near: \"inf\""},
      {R"({"camera": {"near": true}})", "camera.near: true"},
      {R"({"camera": {"near": 1e999}})", "camera.near: "},
      {R"({"camera": {"near": 1, "near": 2}})", "camera.near: given twice"},
      {R"({"camera": {"position": [1, 2]}})", "camera.position: [1,2]"},
      {R"({"camera": {"position": [1, 2, "3"]}})", "camera.position"},
      {R"({"camera": {"position": [1, 2, "inf"]}})", "camera.position"},
      {R"({"camera": {"position": {"x": 1}}})", "camera.position"},
      {R"({"camera": {"up": [0, 0, 0]}})", "camera.up: [0,0,0]"},
      {R"({"camera": {"vertical_fov_deg": 180}})", "(0, 180)"},
      {R"({"image": {"width": 1.5}})", "image.width: 1.5"},
      {R"({"image": {"width": 1e30}})", "image.width"},
      {R"({"light": {"type": "sun"}})", "one of: directional, point, spot"},
      {R"({"light": {"type": 1}})", "light.type: 1"},
      {R"({"shadow": {"plane": "auto"}})", "shadow.plane: \"auto\" is not allowed; allowed: null, or four numbers"},
      {R"({"shadow": {"camera_shift": null}})", "shadow.camera_shift: null is not allowed; allowed: auto, in_front, inside, or"},
      {R"({"scene": {"source": ""}})", "scene.source"},
      {R"({"scene": {"source": "no_such_scene"}})", "scene.source: "},
      {R"({"camera": {"near": 2, "far": 1}})", "camera.far: 1 is not allowed; allowed: a number greater than camera.near (2)"},
  };
  for (const auto& [json, expected] : cases) {
    const std::string text = refusal(json);
    EXPECT_THAT(text, StartsWith("test.psm.json: ")) << json;
    EXPECT_THAT(text, HasSubstr(expected)) << json;
    EXPECT_EQ(text.find('\n'), std::string::npos) << json;
    EXPECT_LT(text.size(), 500u) << json;
  }
}

TEST(ExperimentFile, DeepNestingIsRefused) {
  EXPECT_THAT(refusal(std::string(1000000, '[')), HasSubstr("nested too deeply"));
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_THAT(refusal(objects), HasSubstr("nested too deeply"));
}

TEST(ExperimentFile, CutOffAnywhereItIsRefusedOrWhole) {
  Experiment experiment;
  const std::string text = experiment_to_json(experiment);
  const std::string whole = text.substr(0, text.rfind('}') + 1);
  for (std::size_t length = 0; length < whole.size(); length += 7) EXPECT_NE(refusal(whole.substr(0, length)), "") << length;
  EXPECT_EQ(refusal(whole), "");
}

TEST(ExperimentFile, MissingAndOddFilesAreRefused) {
  Folder folder;
  const auto refused = [](const fs::path& file) {
    const auto loaded = load_experiment(file.string(), {});
    return loaded ? std::string() : loaded.error().text;
  };
  EXPECT_THAT(refused(folder / "none.psm.json"), HasSubstr("none.psm.json: cannot be read: No such file"));
  fs::create_directory(folder / "folder.psm.json");
  EXPECT_THAT(refused(folder / "folder.psm.json"), HasSubstr("is a folder"));
  write(folder / "big.psm.json", std::string((16u << 20) + 1, ' '));
  EXPECT_THAT(refused(folder / "big.psm.json"), HasSubstr("16 MiB"));
  EXPECT_THAT(refused("no_such_scene"), HasSubstr("chessboard"));
  EXPECT_NE(refused(folder / "none.glb"), "");
}

TEST(ExperimentFile, OverridesAreNamedAsTheFlag) {
  const auto refused = [](const char* text) { return load_experiment("", {text}).error().text; };
  EXPECT_THAT(refused("camera.near=0"), StartsWith("--set camera.near: 0 is not allowed"));
  EXPECT_THAT(refused("camera.near=1e9"), StartsWith("--set camera.far: "));
  EXPECT_THAT(refused("scene.source=nothing.glb"), StartsWith("--set scene.source: "));
}

TEST(ExperimentFile, ScenePathsFollowTheFile) {
  Folder folder;
  fs::create_directory(folder / "a");
  fs::create_directory(folder / "b");
  const auto scene = builtin_scene("ground");
  ASSERT_TRUE(scene);
  ASSERT_FALSE(write_glb(*scene, folder / "a/ground.glb"));
  write(folder / "a/one.psm.json", R"({"scene": {"source": "ground.glb"}})");
  const auto loaded = load_experiment((folder / "a/one.psm.json").string(), {});
  ASSERT_TRUE(loaded) << loaded.error().text;
  ASSERT_FALSE(save_experiment(*loaded, folder / "b/two.psm.json"));
  EXPECT_THAT(contents(folder / "b/two.psm.json"), HasSubstr("\"../a/ground.glb\""));
  const auto again = load_experiment((folder / "b/two.psm.json").string(), {});
  ASSERT_TRUE(again) << again.error().text;
  EXPECT_EQ(again->scene.triangle_count(), loaded->scene.triangle_count());
  expect_same_members(again->experiment, [&] {
    Experiment moved = loaded->experiment;
    moved.scene.source = "../a/ground.glb";
    return moved;
  }());
}

TEST(ExperimentFile, WritingIsWholeOrNotAtAll) {
  Folder folder;
  ASSERT_FALSE(write_file_atomically(folder / "x", "one"));
  ASSERT_FALSE(write_file_atomically(folder / "x", "two"));
  EXPECT_EQ(contents(folder / "x"), "two");
  EXPECT_EQ(folder.entries(), 1u);

  fs::create_directory(folder / "taken");
  const auto refused = [](const fs::path& file) { return write_file_atomically(file, "three").value_or(InputError{}).text; };
  EXPECT_THAT(refused(folder / "taken"), HasSubstr("it is a folder"));
  EXPECT_THAT(refused(folder / "none/x"), HasSubstr("No such file or directory"));
  EXPECT_THAT(refused(folder / "x/y"), HasSubstr("cannot be written"));
  EXPECT_THAT(refused("/proc/psmlab"), HasSubstr("cannot be written"));
  EXPECT_THAT(refused("/dev/null"), HasSubstr("not a plain file"));
  EXPECT_NE(refused(""), "");
  EXPECT_EQ(folder.entries(), 2u);
  EXPECT_EQ(contents(folder / "x"), "two");
}

TEST(ExperimentFile, ALinkStaysALink) {
  Folder folder;
  write(folder / "real", "old");
  fs::create_symlink("real", folder / "link");
  ASSERT_FALSE(write_file_atomically(folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(contents(folder / "real"), "new");
}

TEST(ExperimentFile, AnInvalidExperimentIsNotSaved) {
  Folder folder;
  LoadedExperiment loaded;
  loaded.experiment.camera.far = loaded.experiment.camera.near;
  const auto error = save_experiment(loaded, folder / "x.psm.json");
  ASSERT_TRUE(error);
  EXPECT_THAT(error->text, HasSubstr("camera.far"));
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace psm
