// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that print: help, version, scenes, analyze.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "run_program.h"
#include "scene/experiment.h"
#include "scene/scene.h"

namespace psm::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

TEST(Help, IsPrintedForEveryCommand) {
  for (const char* command : {"", "analyze", "curves", "render", "scenes"}) {
    std::vector<std::string> arguments{command, "--help"};
    if (arguments[0].empty()) arguments.erase(arguments.begin());
    const Outcome run = run_program(arguments);
    EXPECT_EQ(run.code, 0) << command;
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("psmlab"));
    EXPECT_THAT(run.out, HasSubstr("--help"));
    EXPECT_THAT(run.out, HasSubstr(command));
  }
}

TEST(Version, IsOneLine) {
  const Outcome run = run_program({"--version"});
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(is_one_line(run.out));
  EXPECT_THAT(run.out, ::testing::MatchesRegex("psmlab [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Streams, AClosedOneIsAFailureNotACrash) {
  for (const char* line :
       {"scenes >&-", "analyze >&-", "--version >&-", "curves --n 1 --f 2 --phi-deg 30 --theta-deg 0:90:0.001 >&-",
        "scenes > /dev/full", "analyze > /dev/full"}) {
    const Outcome run = run_shell(line);
    EXPECT_EQ(run.code, 1) << line;
  }
  EXPECT_EQ(run_shell("analyze no_such_scene 2>&-").code, 2);
  const Outcome piped = run_shell("curves --n 1 --f 2 --phi-deg 30 --theta-deg 0:90:0.001 | head -n 1");
  EXPECT_EQ(piped.code, 0);
  EXPECT_TRUE(is_one_line(piped.out));
}

TEST(Scenes, AreListedAndWritten) {
  const Folder folder;
  const Outcome list = run_program({"scenes"}), write = run_program({"scenes", "--write", folder / "made/here"});
  EXPECT_EQ(list.code, 0);
  EXPECT_EQ(write.code, 0) << write.err;
  for (const std::string& id : builtin_scene_ids()) {
    EXPECT_THAT(list.out, HasSubstr(id + "\n"));
    const std::string file = folder / ("made/here/" + id + ".glb");
    EXPECT_THAT(write.out, HasSubstr(file + "\n"));
    const Outcome direct = run_program({"analyze", id}), again = run_program({"analyze", file});
    ASSERT_EQ(direct.code, 0) << direct.err;
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(json::parse(direct.out)["scene"]["triangles"], json::parse(again.out)["scene"]["triangles"]);
  }
}

glm::dvec4 vector_of(const json& list) { return {list[0], list[1], list[2], list.size() > 3 ? double(list[3]) : 1.0}; }

/// Rows of the JSON as rows here.
struct Matrix {
  glm::dvec4 rows[4];
  explicit Matrix(const json& list) {
    for (int i = 0; i < 4; ++i) rows[i] = vector_of(list[std::size_t(i)]);
  }
  glm::dvec4 operator*(const glm::dvec4& x) const {
    return {glm::dot(rows[0], x), glm::dot(rows[1], x), glm::dot(rows[2], x), glm::dot(rows[3], x)};
  }
  /// The size that the rounding of component i is measured by.
  double scale(int i, const glm::dvec4& x) const { return glm::length(rows[i]) * glm::length(x); }
};

glm::dvec4 light_of(const json& experiment) {
  const json& light = experiment["light"];
  if (light["type"] == "directional") {
    glm::dvec4 l = vector_of(light["to_light"]);
    return l.w = 0, l;
  }
  return vector_of(light["position"]);
}

void expect_light_at_the_far_end(const Matrix& map, const glm::dvec4& light) {
  const glm::dvec4 image = map * light;
  for (const int i : {0, 1, 3}) EXPECT_LE(std::abs(image[i]), 1e-12 * map.scale(i, light)) << "component " << i;
  EXPECT_LT(image.z, 0.0);
}

void expect_tight_window(const Matrix& map, const json& receivers) {
  glm::dvec2 low(1e300), high(-1e300);
  for (const json& vertex : receivers["vertices"]) {
    const glm::dvec4 image = map * vector_of(vertex);
    EXPECT_GT(image.w, 0.0);
    const glm::dvec2 uv(image.x / image.w, image.y / image.w);
    low = glm::min(low, uv), high = glm::max(high, uv);
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(low[i], -1.0, 1e-9);
    EXPECT_NEAR(high[i], 1.0, 1e-9);
  }
}

const std::vector<std::string> kLights[] = {
    {"light.type=directional", "light.to_light=0.3,1,0.2"},  {"light.type=directional", "light.to_light=0,1,0"},
    {"light.type=directional", "light.to_light=0.2,0.5,-1"}, {"light.type=point", "light.position=3,9,2"},
    {"light.type=point", "light.position=0,6,30"},           {"light.type=spot"},
};

class Analyze : public ::testing::TestWithParam<std::string> {};

TEST_P(Analyze, KeepsTheRulesOfTheMap) {
  for (const char* scene : {"chessboard", "ground"}) {
    for (const std::vector<std::string>& light : kLights) {
      std::vector<std::string> arguments{"analyze", scene, "--set", "shadow.technique=" + GetParam()};
      for (const std::string& member : light) arguments.insert(arguments.end(), {"--set", member});
      SCOPED_TRACE(std::string(scene) + " " + ::testing::PrintToString(light));
      const Outcome run = run_program(arguments);
      ASSERT_EQ(run.code, 0) << run.err;
      EXPECT_EQ(run.err, "");
      const json analysis = json::parse(run.out);
      EXPECT_EQ(run.out.find("nan"), std::string::npos);
      for (const json& note : analysis["notes"]) EXPECT_NE(note["code"], "not_a_number") << note;
      const json& map = analysis["matrices"]["map_from_world"];
      EXPECT_EQ(map.is_null(), analysis["light_case"]["inside_receivers"].get<bool>());
      EXPECT_EQ(map.is_null(), !analysis["matrices"]["cube_maps_from_world"].is_null());
      if (map.is_null()) continue;
      expect_light_at_the_far_end(Matrix(map), light_of(analysis["experiment"]));
      expect_tight_window(Matrix(map), analysis["receivers_body"]);
    }
  }
}

/// All but the paper's own constructions, which are there to show what keeping the rules is worth.
std::vector<std::string> techniques_that_keep_the_rules() {
  std::vector<std::string> names = technique_names();
  std::erase(names, "psm_recipe");
  std::erase(names, "psm_divided");
  std::erase(names, "psm_two_maps");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Techniques, Analyze, ::testing::ValuesIn(techniques_that_keep_the_rules()));

TEST(AnalyzeOutput, HasEveryMemberOfTheContract) {
  const json analysis = json::parse(run_program({"analyze"}).out);
  for (const char* name :
       {"psmlab", "experiment", "light_case", "scene", "theta_deg", "phi_deg", "n", "f", "rho", "lambda", "camera_shift",
        "technique_used", "notes", "matrices", "vanishing_plane", "caster_body", "receivers_body", "error"})
    EXPECT_TRUE(analysis.contains(name)) << name;
  for (const char* name : {"world", "post", "w", "light_post", "naive_order", "inside_receivers", "inside_frustum"})
    EXPECT_TRUE(analysis["light_case"].contains(name)) << name;
  for (const char* name :
       {"view_from_world", "clip_from_view", "map_from_world", "map_beyond_from_world", "cube_maps_from_world"})
    EXPECT_TRUE(analysis["matrices"].contains(name)) << name;
  for (const char* name : {"F_near", "F_far", "F_max", "E_max_line", "E_max_frustum", "storage_factor", "texels"})
    EXPECT_TRUE(analysis["error"].contains(name)) << name;
  EXPECT_EQ(analysis["psmlab"], 1);
  std::string codes;
  for (const json& note : analysis["notes"]) codes += note["code"].get<std::string>() + " ";
  EXPECT_EQ(analysis["caster_body"].is_null(), codes.find("caster_body_not_computed") != std::string::npos);
}

TEST(AnalyzeOutput, HasTexelStatisticsWhenAskedTo) {
  const std::vector<std::string> small{"analyze", "--set", "image.width=64", "--set", "image.height=36"};
  EXPECT_TRUE(json::parse(run_program(small).out)["error"]["texels"].is_null());
  std::vector<std::string> asked = small;
  asked.push_back("--texels");
  const json texels = json::parse(run_program(asked).out)["error"]["texels"];
  for (const char* name : {"m_mean", "m_p50", "m_p95", "m_max", "undersampled_fraction"})
    EXPECT_TRUE(texels[name].is_number()) << name;
  EXPECT_LE(texels["m_p50"], texels["m_p95"]);
  EXPECT_LE(texels["m_p95"], texels["m_max"]);
  EXPECT_GT(texels["m_p50"], 0.0);
}

TEST(AnalyzeOutput, SaysWhyThereAreNoTexelStatistics) {
  // From below, the ground's lit side is not to be seen.
  const json analysis =
      json::parse(run_program({"analyze", "ground", "--texels", "--set", "light.type=directional", "--set",
                               "light.to_light=0,-1,0", "--set", "camera.position=0,900,0", "--set", "camera.target=0,901,1"})
                      .out);
  EXPECT_TRUE(analysis["error"]["texels"].is_null());
  EXPECT_THAT(analysis["notes"].dump(), testing::HasSubstr("texels_none"));
}

TEST(AnalyzeOutput, ReadsBackAsTheSameExperiment) {
  const Folder folder;
  const Outcome first = run_program({"analyze", "ground", "--set", "camera.far=inf", "--set", "shadow.plane=1,2,3,-0.1"});
  const json analysis = json::parse(first.out);
  EXPECT_EQ(analysis["experiment"]["camera"]["far"], "inf");
  std::ofstream(folder / "x.psm.json") << analysis["experiment"].dump();
  const Outcome again = run_program({"analyze", folder / "x.psm.json"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.out, first.out);
}

TEST(AnalyzeOutput, IsTheSameEveryTime) { EXPECT_EQ(run_program({"analyze"}).out, run_program({"analyze", "chessboard"}).out); }

TEST(AnalyzeOutput, ALightInsideTheReceiversHasSixMaps) {
  const json probe = json::parse(run_program({"analyze", "ground"}).out);
  glm::dvec4 middle(0);
  const json& vertices = probe["receivers_body"]["vertices"];
  for (const json& vertex : vertices) middle += vector_of(vertex) / double(vertices.size());
  std::string position = "light.position=";
  for (int i = 0; i < 3; ++i) position += (i ? "," : "") + number_text(middle[i]);
  const Outcome run = run_program({"analyze", "ground", "--set", "light.type=point", "--set", position});
  ASSERT_EQ(run.code, 0) << run.err;
  const json analysis = json::parse(run.out);
  EXPECT_TRUE(analysis["matrices"]["map_from_world"].is_null());
  EXPECT_EQ(analysis["matrices"]["cube_maps_from_world"].size(), 6u);
  EXPECT_TRUE(analysis["light_case"]["inside_receivers"].get<bool>());
}

}  // namespace
}  // namespace psm::testing
