// SPDX-License-Identifier: GPL-3.0-or-later
// Errors by cause on small pictures made by hand, and texel sizes on a ground whose answers are known.
#include "measure/shadow_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <tuple>

#include "measure/distance_transform.h"
#include "scenes.h"

namespace psm {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// '#' dark, '.' lit, '^' away, ' ' unseen.
std::vector<Lit> truth_of(const std::string& text) {
  std::vector<Lit> out;
  for (const char c : text) out.push_back(c == '#' ? Lit::dark : c == '.' ? Lit::lit : c == '^' ? Lit::away : Lit::unseen);
  return out;
}

/// '#' dark, '.' lit, 'o' outside, ' ' unseen.
std::vector<MapVerdict> verdicts_of(const std::string& text) {
  std::vector<MapVerdict> out;
  for (const char c : text)
    out.push_back(c == '#' ? MapVerdict::dark : c == '.' ? MapVerdict::lit : c == 'o' ? MapVerdict::outside : MapVerdict::unseen);
  return out;
}

/// One letter a pixel: Outside, Resolution, Acne, Leak, '-' none.
std::string causes(const std::string& truth, const std::string& map, std::vector<float> m, int width) {
  const auto errors = find_errors(truth_of(truth), verdicts_of(map), m, width, int(truth.size()) / width);
  std::string out;
  for (const ErrorCause cause : errors) out += "-ORAL"[int(cause)];
  return out;
}
std::string causes(const std::string& truth, const std::string& map, float m) {
  return causes(truth, map, std::vector<float>(truth.size(), m), int(truth.size()));
}

TEST(ErrorCauses, NoneWhereMapAndTruthAgree) { EXPECT_EQ(causes("..##^ ..", "..##.#..", 1), "--------"); }

TEST(ErrorCauses, WithinItsOwnTexelOfAChangeIsResolution) {
  // The truth changes between pixels 5 and 6; both are at distance 0 from the change.
  EXPECT_EQ(causes("......####", ".#########", 1.0f), "-AAARR----");
  EXPECT_EQ(causes("......####", ".#########", 0.2f), "-AAARR----");  // at least one pixel
  EXPECT_EQ(causes("......####", ".#########", 2.5f), "-AARRR----");
  EXPECT_EQ(causes("......####", ".#########", kInfinite), "-RRRRR----");
  EXPECT_EQ(causes("......####", ".........#", 1.0f), "------RRL-");
  EXPECT_EQ(causes("......####", ".#.......#", {1, 9, 1, 1, 1, 1, 1, 1, 2, 1}, 10), "-R----RRR-");
}

TEST(ErrorCauses, WithoutAnyChangeNothingIsResolution) {
  EXPECT_EQ(causes("....", ".##.", kInfinite), "-AA-");
  EXPECT_EQ(causes("####", "#..#", kInfinite), "-LL-");
}

TEST(ErrorCauses, OutsideComesFirstAndIsLit) { EXPECT_EQ(causes("...###", ".oooo#", 1.0f), "---OO-"); }

TEST(ErrorCauses, ASilhouetteAgainstTheSkyIsNoChangeButTheTerminatorIs) {
  EXPECT_EQ(causes("...   ###", ".##   ..#", 1.0f), "-AA---LL-");
  EXPECT_EQ(causes("...^^^", ".##.#.", 1.0f), "-RR---");
  EXPECT_EQ(causes("###^^^", ".##...", 1.0f), "L-----");  // both dark
}

TEST(ErrorCauses, PixelsThatTheEyePassDidNotSeeAreNotJudged) { EXPECT_EQ(causes("..##", "  .#", 1.0f), "--R-"); }

TEST(ErrorCauses, DistancesRunAcrossRowsToo) {
  const std::string truth =
      "####"
      "####"
      "####"
      "...#";
  const std::string map =
      ".###"
      "####"
      "####"
      "...#";
  EXPECT_EQ(causes(truth, map, std::vector<float>(16, 1.9f), 4).substr(0, 4), "L---");
  EXPECT_EQ(causes(truth, map, std::vector<float>(16, 2.0f), 4).substr(0, 4), "R---");
}

TEST(ErrorCauses, AreCounted) {
  const std::vector<Lit> truth = truth_of("......####^ ");
  const std::vector<ErrorCause> errors = find_errors(truth, verdicts_of(".##..#..o###"), std::vector<float>(12, 1.0f), 12, 1);
  const ShadowError e = count_errors(truth, errors);
  EXPECT_EQ(e.compared, 10u);
  EXPECT_EQ(e.wrongly_dark, 3u);
  EXPECT_EQ(e.wrongly_lit, 3u);
  EXPECT_EQ(e.by_cause[std::size_t(ErrorCause::resolution)], 3u);
  EXPECT_EQ(e.by_cause[std::size_t(ErrorCause::acne)], 2u);
  EXPECT_EQ(e.by_cause[std::size_t(ErrorCause::outside)], 1u);
  EXPECT_DOUBLE_EQ(e.fraction(), 0.6);
  EXPECT_EQ(count_errors({}, {}).fraction(), 0.0);
}

TEST(DistanceTransform, IsTheNearestPixelsDistance) {
  std::mt19937 random(5);
  for (const auto& [width, height, share] : {std::tuple(31, 17, 40), {1, 9, 4}, {13, 1, 5}, {20, 20, 400}, {7, 5, 1000000}}) {
    std::vector<float> image(std::size_t(width * height), kInfinite);
    for (float& pixel : image)
      if (random() % unsigned(share) == 0) pixel = 0;
    std::vector<float> expected(image.size(), kInfinite);
    for (int i = 0; i < width * height; ++i)
      for (int j = 0; j < width * height; ++j)
        if (image[std::size_t(j)] == 0) {
          const int dx = i % width - j % width, dy = i / width - j / width;
          expected[std::size_t(i)] = std::min(expected[std::size_t(i)], float(dx * dx + dy * dy));
        }
    spread_squared_distances(image, width, height);
    EXPECT_EQ(image, expected) << width << " " << height;
  }
}

TEST(TexelStatistics, CountWhatIsSeenInTheLight) {
  EXPECT_FALSE(texel_statistics({0, 0}));
  const auto s = texel_statistics({0, 0.5f, 1, 2, 0, 4});
  ASSERT_TRUE(s);
  EXPECT_DOUBLE_EQ(s->m_mean, 1.875);
  EXPECT_DOUBLE_EQ(s->m_p50, 1);
  EXPECT_DOUBLE_EQ(s->m_max, 4);
  EXPECT_DOUBLE_EQ(s->undersampled_fraction, 0.5);
  const auto infinite = texel_statistics({1, kInfinite});
  ASSERT_TRUE(infinite);
  EXPECT_TRUE(std::isinf(infinite->m_max) && std::isinf(infinite->m_mean));
  EXPECT_DOUBLE_EQ(infinite->undersampled_fraction, 0.5);
}

// ---- the one-scene table ------------------------------------------------------------------------------------------------

Experiment one_scene(Technique technique, double theta_deg) {
  Experiment x;
  x.camera.position = {0, 1.7, 0};
  x.camera.target = {0, 1.7, -1};
  x.camera.vertical_fov_deg = 60;
  x.camera.near = 1;
  x.camera.far = 100;
  x.image = {640, 360};
  x.shadow.technique = technique;
  x.shadow.resolution = 1024;
  x.light.to_light = {0, std::sin(glm::radians(theta_deg)), -std::cos(glm::radians(theta_deg))};
  return x;
}

/// 95th percentile of m over the ground's pixels.
double p95(Technique technique, double theta_deg) {
  Scene scene = empty_scene();
  add_box(scene, {-100, -10, -100}, {100, 0, 100});
  const Experiment x = one_scene(technique, theta_deg);
  const RayTracer tracer(scene);
  const Analysis analysis = analyze(x, scene, visible_points(tracer, x));
  EXPECT_EQ(analysis.technique_used, technique);
  const VisibleImage image = see(tracer, x, x.image.width, x.image.height);
  const std::vector<Lit> truth = trace_light(tracer, image, x);
  EXPECT_EQ(std::count(truth.begin(), truth.end(), Lit::dark), 0);
  const auto lit = std::count(truth.begin(), truth.end(), Lit::lit);
  EXPECT_NEAR(double(lit), 112000, 500);
  return texel_statistics(texel_sizes(image, analysis))->m_p95;
}

struct TableRow {
  double theta_deg, uniform, lispsm_reference;
};

class OneSceneTable : public ::testing::TestWithParam<TableRow> {};
INSTANTIATE_TEST_SUITE_P(Rows, OneSceneTable,
                         ::testing::Values(TableRow{90, 20.5, 3.58}, TableRow{75, 20.5, 3.66}, TableRow{60, 20.6, 3.76},
                                           TableRow{45, 20.7, 3.88}, TableRow{35, 20.7, 4.01}, TableRow{30, 20.8, 4.10},
                                           TableRow{20, 21.1, 4.39}, TableRow{10, 22.1, 5.18}, TableRow{5, 25.0, 6.57},
                                           TableRow{1, 60.6, 14.2}));

TEST_P(OneSceneTable, IsMet) {
  const TableRow row = GetParam();
  EXPECT_NEAR(p95(Technique::uniform, row.theta_deg), row.uniform, 0.01 * row.uniform);
  EXPECT_NEAR(p95(Technique::lispsm_reference, row.theta_deg), row.lispsm_reference, 0.01 * row.lispsm_reference);
}

}  // namespace
}  // namespace psm
