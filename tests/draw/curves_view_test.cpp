// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/curves_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw/view.h"
#include "scene/experiment_file.h"
#include "text_boxes.h"

namespace psm {
namespace {

using ::testing::HasSubstr;

constexpr glm::ivec2 kSize(900, 600);

ViewPicture curves_of(const std::vector<std::string>& overrides, glm::ivec2 size = kSize, double scale = 1.0) {
  const auto loaded = load_experiment("ground", overrides);
  EXPECT_TRUE(loaded) << loaded.error().text;
  return describe_view(ViewId::curves, analyze(loaded->experiment, loaded->scene), size, scale);
}

std::string kind_text(CurveKind kind) {
  Experiment e;
  e.view.curve = kind;
  return "view.curve=" + value_text(*find_field("view.curve"), e);
}

bool says(const ViewPicture& picture, const std::string& text) {
  return std::any_of(picture.list.texts.begin(), picture.list.texts.end(),
                     [&](const DrawText& t) { return t.text.find(text) != std::string::npos; });
}

void expect_on_page(const ViewPicture& picture, const std::string& what) {
  ASSERT_FALSE(picture.list.lines.empty()) << what;
  const auto check = [&](const glm::dvec4& p) {
    const glm::dvec4 q = picture.clip_from_list * p;
    ASSERT_TRUE(std::isfinite(q.x + q.y + q.z)) << what;
    ASSERT_LE(std::max(std::abs(q.x), std::abs(q.y)), 1.0 + 1e-9) << what;
  };
  for (const DrawLine& line : picture.list.lines) check(line.a), check(line.b);
  for (const DrawPoint& point : picture.list.points) check(point.position);
  for (const DrawText& text : picture.list.texts) check(text.position);
}

TEST(CurvesView, StaysOnItsPageWhateverTheExperiment) {
  for (std::size_t i = 0; i < kCurveKinds; ++i)
    for (const char* other : {"shadow.technique=gmnpr", "shadow.technique=psm", "light.type=point", "camera.far=inf",
                              "camera.target=0,1000,0.01", "light.to_light=0,0,1"}) {
      const std::string kind = kind_text(CurveKind(i));
      expect_on_page(curves_of({kind, other}), kind + " " + other);
    }
}

TEST(CurvesView, TheCursorStandsAtTheLightsAngle) {
  const auto loaded = load_experiment("ground", {});
  const Analysis a = analyze(loaded->experiment, loaded->scene);
  const ViewPicture picture = describe_view(ViewId::curves, a, kSize);
  ASSERT_TRUE(picture.chart);
  const double x = picture.chart->x.at(folded(curve_setting(a).theta_deg));
  EXPECT_TRUE(std::any_of(picture.list.lines.begin(), picture.list.lines.end(), [&](const DrawLine& l) {
    return l.role == Role::light && std::abs(l.a.x - x) < 1e-9 && std::abs(l.b.x - x) < 1e-9;
  }));
  // A point on each curve that exists there.
  const auto reading = read_curves(a.experiment.view.curve, curve_setting(a), {folded(curve_setting(a).theta_deg), 0.0});
  EXPECT_EQ(reading.rows.front().warp, Warp::gmnpr) << "the current one first";
  for (const CurveReading::Row& row : reading.rows) {
    if (!picture.chart->y.contains(row.value)) continue;
    const double y = picture.chart->y.at(row.value);
    EXPECT_TRUE(std::any_of(picture.list.points.begin(), picture.list.points.end(), [&](const DrawPoint& p) {
      return std::abs(p.position.x - x) < 1e-6 && std::abs(p.position.y - y) < 1e-6;
    })) << display_name(row.warp);
  }
}

TEST(CurvesView, NamesTheCriticalAngles) {
  const ViewPicture strength = curves_of({"view.curve=rho", "view.curve_range=papers"});
  EXPECT_TRUE(says(strength, "θ = φ = 30°"));
  EXPECT_TRUE(says(strength, "27.69°"));
  const ViewPicture error = curves_of({"view.curve=F_max", "view.curve_range=papers"});
  EXPECT_TRUE(says(error, "GMNPR worse than uniform: 17.22°"));
  EXPECT_TRUE(says(error, "(papers)"));
}

TEST(CurvesView, LabelsKeepApartAndTheCurrentOneStaysWhereThereIsNoRoom) {
  for (const glm::ivec2 size : {glm::ivec2(900, 600), glm::ivec2(420, 260)}) {
    const ViewPicture picture = curves_of({"view.curve=rho", "shadow.technique=minimax_frustum"}, size);
    std::vector<double> heights;
    bool current = false;
    for (const DrawText& text : picture.list.texts) {
      if (text.position.x <= picture.chart->x.to()) continue;
      heights.push_back(text.position.y);
      current |= text.text == display_name(Warp::minimax_frustum);
    }
    EXPECT_TRUE(current);
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_GE(heights[i] - heights[i - 1], 19.0 - 1e-9);
  }
}

TEST(CurvesView, NoTextIsCutOrStandsOverAnother) {
  for (std::size_t i = 0; i < kCurveKinds; ++i)
    for (const glm::ivec2 size : {glm::ivec2(480, 270), glm::ivec2(640, 360), glm::ivec2(1024, 768)}) {
      const std::string kind = kind_text(CurveKind(i));
      testing::expect_readable(testing::texts_on(curves_of({kind}, size), size), size, kind);
    }
}

TEST(CurvesView, LargerTypeTakesMoreRoom) {
  const ViewPicture small = curves_of({}, kSize, 1.0), large = curves_of({}, kSize, 2.0);
  EXPECT_LT(large.chart->x.to() * 2.0, small.chart->x.to()) << "in pixels";
}

TEST(CurvesView, TheSurfacesLinesLieWhereTheyShould) {
  CurveSetting setting;
  setting.current = Warp::gmnpr;
  const Chart chart = curve_chart(CurveKind::surface, setting);
  ASSERT_GE(chart.levels.size(), 4u);
  for (const ChartLevel& level : chart.levels) {
    const double wanted = std::stod(level.label);
    for (std::size_t i = 0; i < level.segments.size(); i += 17) {
      const glm::dvec2 p = level.segments[i][0];
      EXPECT_NEAR(curve_value(CurveKind::surface, setting.range, p.x, p.y, Warp::gmnpr) / wanted, 1.0, 2e-3) << level.label;
    }
  }
}

}  // namespace
}  // namespace psm
