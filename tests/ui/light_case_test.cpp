// SPDX-License-Identifier: GPL-3.0-or-later
// The light through the camera plane, dragged in the real frame loop: the badge changes its word, the picture keeps its shadows.
#include <algorithm>
#include <cmath>

#include "harness.h"
#include "ui/handles.h"

namespace psm::test {
namespace {

/// Shadows on the grey ground: neither lit ground nor brown posts nor the pale sky.
std::size_t shadowed_pixels(const Image& eye) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < eye.rgba.size(); i += 4) {
    const int r = eye.rgba[i], g = eye.rgba[i + 1], b = eye.rgba[i + 2];
    count += std::abs(r - g) <= 6 && std::abs(g - b) <= 6 && r >= 80 && r <= 150;
  }
  return count;
}

/// What one step of a drag must keep to: shadows there, none suddenly gone or doubled, and a picture at rest that stays the same.
class ShadowWatch {
 public:
  explicit ShadowWatch(Bench& bench) : bench_(bench) { last_ = shadowed_pixels(bench.view(ViewId::eye)); }
  void check(const std::string& where) {
    const std::size_t now = shadowed_pixels(bench_.view(ViewId::eye));
    EXPECT_GT(now, 100u) << where << ": the shadows are gone";
    EXPECT_LT(std::max(now, last_), 2 * std::min(now, last_) + 100) << where << ": the shadows jump";
    last_ = now;
    const Image first = bench_.screen();
    bench_.work().wake();
    bench_.frame();
    EXPECT_EQ(differing_pixels(first, bench_.screen()), 0u) << where << ": a frame without input changes the window";
    bench_.settle();
  }

 private:
  Bench& bench_;
  std::size_t last_;
};

/// Names of the cases in the order in which they came up, without repeats.
void note_case(std::vector<PostLight>& cases, const Analysis& analysis) {
  const auto& c = analysis.light_case;
  const PostLight shown = c.within_half_texel ? PostLight::directional : c.post;
  if (cases.empty() || cases.back() != shown) cases.push_back(shown);
}

const std::vector<PostLight> kThroughThePlane = {PostLight::point, PostLight::directional, PostLight::inverted_point};

/// Drags a slider's grab from where it is to `to` (a part of its width), pixel by pixel where the case changes.
std::vector<PostLight> drag_slider(Bench& bench, const std::string& slider, double from, double to, int steps) {
  std::vector<PostLight> cases;
  ShadowWatch watch(bench);
  note_case(cases, bench.analysis());
  bench.press(bench.at(slider, from));
  for (int i = 1; i <= steps; ++i) {
    const double part = from + (to - from) * i / steps;
    bench.move(bench.at(slider, part));
    note_case(cases, bench.analysis());
    watch.check(slider + " at " + std::to_string(part));
  }
  bench.release();
  return cases;
}

TEST(LightCase, DepthSliderTakesAPointLightThroughTheCameraPlane) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8", "shadow.technique=psm"});
  EXPECT_EQ(bench.analysis().light_case.post, PostLight::point);
  EXPECT_EQ(drag_slider(bench, "depth", 0.68, 0.30, 20), kThroughThePlane);
  EXPECT_LT(bench.analysis().light_case.w, 0.0);
  EXPECT_EQ(bench.work().model().history().undo_count(), 1u) << "a drag is one entry";
}

TEST(LightCase, ThetaSliderTurnsTheSunThroughTheImagePlane) {
  Bench bench("ground", {"shadow.technique=gmnpr"});
  EXPECT_EQ(bench.analysis().light_case.post, PostLight::point);
  EXPECT_EQ(drag_slider(bench, "theta", 0.44, 0.60, 16), kThroughThePlane);
}

TEST(LightCase, BadgeSaysDirectionalWithinHalfATexel) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-1e-5", "shadow.resolution=1024"});
  ASSERT_NE(bench.analysis().light_case.w, 0.0);
  EXPECT_TRUE(bench.analysis().light_case.within_half_texel);
  EXPECT_NE(light_case_text(bench.analysis()).find("directional"), std::string::npos);
}

TEST(LightCase, SnapsToZeroAndAltFrees) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8"});
  const double middle = 0.5, beside = middle + 3.0 / (bench.at("depth", 1.0).x - bench.at("depth", 0.0).x);
  bench.drag(bench.at("depth", 0.7), bench.at("depth", beside));
  EXPECT_EQ(bench.analysis().light_case.post, PostLight::directional) << bench.analysis().light_case.w;
  bench.input().key(key::alt, true);
  bench.drag(bench.at("depth", beside), bench.at("depth", beside + 0.01));
  bench.input().key(key::alt, false);
  bench.settle();
  EXPECT_EQ(bench.analysis().light_case.post, PostLight::point);
}

TEST(LightCase, TheSunIsDraggedInTheWorldView) {
  Bench bench("ground");
  const Rect world = bench.work_places().at("view.world");
  const auto all = handles(bench.work().images().picture(ViewId::world), bench.experiment(), world.size());
  const auto sun = std::find_if(all.begin(), all.end(), [](const Handle& h) { return h.kind == HandleKind::sun; });
  ASSERT_NE(sun, all.end());
  const glm::dvec2 start = glm::dvec2(world.min) + sun->pixel;
  ShadowWatch watch(bench);
  std::vector<PostLight> cases;
  bench.press(start);
  for (int i = 1; i <= 12; ++i) {
    bench.move(start + glm::dvec2(0.0, 4.0 * i));
    note_case(cases, bench.analysis());
    watch.check("step " + std::to_string(i));
  }
  bench.release();
  EXPECT_EQ(cases.front(), PostLight::point);
  EXPECT_EQ(cases.back(), PostLight::inverted_point);
  EXPECT_EQ(bench.work().model().history().undo_count(), 1u);
}

TEST(LightCase, TheLampIsDraggedInTheWorldView) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8"});
  const Rect world = bench.work_places().at("view.world");
  const auto all = handles(bench.work().images().picture(ViewId::world), bench.experiment(), world.size());
  const auto lamp = std::find_if(all.begin(), all.end(), [](const Handle& h) { return h.kind == HandleKind::light_position; });
  ASSERT_NE(lamp, all.end());
  const glm::dvec2 start = glm::dvec2(world.min) + lamp->pixel;
  const glm::dvec3 before = bench.experiment().light.position;
  bench.drag(start, start + glm::dvec2(20.0, 0.0));
  const auto& picture = bench.work().images().picture(ViewId::world);
  const glm::dvec4 clip = picture.clip_from_list * glm::dvec4(bench.experiment().light.position, 1.0);
  EXPECT_NE(bench.experiment().light.position, before);
  EXPECT_NEAR((0.5 + 0.5 * clip.x / clip.w) * world.size().x, lamp->pixel.x + 20.0, 0.5) << "the lamp follows the mouse";
}

}  // namespace
}  // namespace psm::test
