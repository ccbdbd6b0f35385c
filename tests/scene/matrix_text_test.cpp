// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/matrix_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <string>

#include "random_experiment.h"
#include "scene/experiment_file.h"

namespace psm {
namespace {

using ::testing::HasSubstr;

Analysis analysis_of(const std::string& source, const std::vector<std::string>& overrides = {}) {
  const auto loaded = load_experiment(source, overrides);
  EXPECT_TRUE(loaded);
  return analyze(loaded->experiment, loaded->scene);
}

/// What a compiler would read: the sixteen numbers of each constructor, column by column.
std::map<std::string, glm::dmat4> constructed(const std::string& text) {
  static const std::regex declaration("const \\S+ (\\w+)(?: = mat4)?\\(([^)]*)\\);"), number("[^,\\s]+");
  std::map<std::string, glm::dmat4> out;
  for (std::sregex_iterator i(text.begin(), text.end(), declaration), end; i != end; ++i) {
    const std::string body = (*i)[2];
    int at = 0;
    glm::dmat4 matrix(0.0);
    for (std::sregex_iterator n(body.begin(), body.end(), number); n != end && at < 16; ++n, ++at) {
      EXPECT_NE(n->str().find_first_of(".e"), std::string::npos) << n->str() << " is an integer in GLSL";
      matrix[at / 4][at % 4] = std::stod(n->str());
    }
    EXPECT_EQ(at, 16);
    out[(*i)[1]] = matrix;
  }
  return out;
}

glm::dvec3 divided(const glm::dvec4& p) { return glm::dvec3(p) / p.w; }

TEST(MatrixText, CppReadsBackBitForBit) {
  const Analysis a = analysis_of("chessboard");
  const auto read = constructed(matrices_text(a, MatrixLanguage::cpp, ClipConvention::opengl));
  EXPECT_EQ(read.at("view_from_world"), a.view_from_world);
  EXPECT_EQ(read.at("clip_from_view"), a.clip_from_view);
  EXPECT_EQ(read.at("map_from_world"), *a.map_from_world);
  EXPECT_EQ(read.size(), 3u);
}

TEST(MatrixText, GlslReadsBackAsTheSameFloats) {
  const Analysis a = analysis_of("chessboard");
  const auto read = constructed(matrices_text(a, MatrixLanguage::glsl, ClipConvention::d3d));
  EXPECT_EQ(glm::mat4(read.at("map_from_world")), glm::mat4(in_convention(*a.map_from_world, ClipConvention::d3d)));
}

TEST(MatrixText, JsonHasRowsAndItsConvention) {
  const std::string text = matrices_text(analysis_of("chessboard"), MatrixLanguage::json, ClipConvention::reversed_z);
  EXPECT_THAT(text, HasSubstr("\"convention\": \"reversed_z\""));
  EXPECT_THAT(text, HasSubstr("\"map_from_world\": [\n    ["));
}

TEST(MatrixText, NamesEveryMapOfItsKind) {
  const auto two = constructed(matrices_text(
      analysis_of("chessboard", {"shadow.technique=psm_two_maps", "light.type=directional", "light.to_light=0,1,3"}),
      MatrixLanguage::cpp, ClipConvention::opengl));
  EXPECT_EQ(two.count("map_beyond_from_world"), 1u);
  const auto six = constructed(matrices_text(analysis_of("chessboard", {"light.type=point", "light.position=0,0.5,0"}),
                                             MatrixLanguage::cpp, ClipConvention::opengl));
  EXPECT_EQ(six.count("map_from_world"), 0u);
  EXPECT_EQ(six.count("cube_map_5_from_world"), 1u);
}

// Hard case 34: the same (u, v) in every convention, and the depth range where each wants it.
TEST(MatrixText, ConventionsDifferInDepthAlone) {
  testing::RandomExperiment random(34);
  for (int i = 0; i < 50; ++i) {
    const Analysis a = analyze(random(), Scene());
    for (const glm::dmat4& m : {a.clip_from_view, a.map_from_world.value_or(a.cube_from_world)}) {
      const glm::dmat4 d3d = in_convention(m, ClipConvention::d3d), reversed = in_convention(m, ClipConvention::reversed_z);
      for (int column = 0; column < 4; ++column)
        for (int row : {0, 1, 3}) {
          EXPECT_EQ(d3d[column][row], m[column][row]);
          EXPECT_EQ(reversed[column][row], m[column][row]);
        }
      EXPECT_EQ(in_convention(m, ClipConvention::opengl), m);
    }
  }
}

TEST(MatrixText, EyeDepthRunsFromNearToFarAsTheConventionSays) {
  for (const double far : {1.000001, 100.0, 1e8}) {
    const Analysis a = analysis_of("chessboard", {"camera.near=1", "camera.far=" + number_text(far)});
    const auto depth = [&](ClipConvention c, double z) { return divided(eye_projection(a, c) * glm::dvec4(0, 0, -z, 1)).z; };
    const double rounding = 4e-16 * far / (far - 1.0);
    EXPECT_NEAR(depth(ClipConvention::opengl, 1), -1, 4 * rounding);
    EXPECT_NEAR(depth(ClipConvention::opengl, far), 1, 4 * rounding);
    EXPECT_NEAR(depth(ClipConvention::d3d, 1), 0, rounding);
    EXPECT_NEAR(depth(ClipConvention::d3d, far), 1, rounding);
    EXPECT_NEAR(depth(ClipConvention::reversed_z, 1), 1, rounding);
    EXPECT_NEAR(depth(ClipConvention::reversed_z, far), 0, rounding);
  }
}

TEST(MatrixText, AnInfiniteFarPlaneIsExact) {
  const Analysis a = analysis_of("chessboard", {"camera.near=0.5", "camera.far=inf"});
  EXPECT_EQ(eye_projection(a, ClipConvention::d3d)[3].z, -0.5);
  EXPECT_EQ(eye_projection(a, ClipConvention::reversed_z)[2].z, 0.0);
  EXPECT_EQ(eye_projection(a, ClipConvention::reversed_z)[3].z, 0.5);
}

}  // namespace
}  // namespace psm
