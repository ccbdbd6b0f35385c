// SPDX-License-Identifier: GPL-3.0-or-later
// A and B in the window: two techniques in one view.
#include "ui/comparison.h"

#include "harness.h"

namespace psm::test {
namespace {

constexpr Modifiers kShift{false, true, false};

std::vector<std::string> eye_alone(const std::string& technique, std::vector<std::string> more = {}) {
  std::vector<std::string> overrides{"view.maximised=eye", "shadow.resolution=64", "shadow.technique=" + technique};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

/// The columns of the window from `begin` to before `end`, in the rows from `top` to `bottom`.
Image part(const Image& image, int begin, int end, int top, int bottom) {
  Image out{end - begin, bottom - top, {}};
  for (int y = top; y < bottom; ++y) {
    const auto row = image.rgba.begin() + std::ptrdiff_t(y) * image.width * 4;
    out.rgba.insert(out.rgba.end(), row + begin * 4, row + end * 4);
  }
  return out;
}

Image screen_of(const std::vector<std::string>& overrides, Rect& eye) {
  Bench bench("ground", overrides);
  bench.move({1.0, 1.0});
  eye = bench.work_places().at("view.eye");
  return bench.screen();
}

TEST(Comparison, EitherSideOfTheLineIsThatTechniquesPicture) {
  Rect eye;
  const Image a = screen_of(eye_alone("gmnpr"), eye), b = screen_of(eye_alone("uniform"), eye);
  const Image both = screen_of(eye_alone("gmnpr", {"view.compare=uniform", "view.split=0.4"}), eye);
  const int line = eye.min.x + int(0.4 * eye.size().x), margin = 15;
  const int top = eye.min.y + eye.size().y / 3, bottom = eye.max.y;  // below the names
  const auto left = [&](const Image& image) { return part(image, eye.min.x, line - margin, top, bottom); };
  const auto right = [&](const Image& image) { return part(image, line + margin, eye.max.x, top, bottom); };
  EXPECT_EQ(differing_pixels(left(both), left(a)), 0u);
  EXPECT_EQ(differing_pixels(right(both), right(b)), 0u);
  EXPECT_GT(differing_pixels(right(a), right(b), 8), 20u) << "else the test could not tell them apart";
}

TEST(Comparison, KeyBShowsTheUniformMapBesideAndTakesItAwayAgain) {
  Bench bench("ground", {"shadow.technique=psm"});
  EXPECT_EQ(bench.work().comparison().images(), nullptr);
  bench.key('B');
  EXPECT_EQ(bench.experiment().view.compare, Technique::uniform);
  ASSERT_NE(bench.work().comparison().analysis(), nullptr);
  EXPECT_EQ(bench.work().comparison().analysis()->technique_used, Technique::uniform);
  EXPECT_EQ(bench.analysis().technique_used, Technique::psm);
  bench.key('B');
  EXPECT_EQ(bench.experiment().view.compare, std::nullopt);
  EXPECT_EQ(bench.work().comparison().images(), nullptr);
}

TEST(Comparison, BFollowsTheExperimentAndRestsWithIt) {
  Bench bench("ground", {"view.compare=uniform"});
  bench.move({1.0, 1.0});
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.7));
  ASSERT_NE(bench.work().comparison().analysis(), nullptr);
  Experiment second = bench.experiment();
  second.shadow.technique = Technique::uniform;
  const Analysis wanted = analyze(second, bench.work().model().scene());
  EXPECT_EQ(bench.work().comparison().analysis()->map_from_world, wanted.map_from_world);
  const auto drawn = bench.work().views_drawn();
  bench.move({2.0, 2.0});
  EXPECT_EQ(bench.work().views_drawn(), drawn);
  bench.work().open("chessboard");
  bench.settle();
  EXPECT_EQ(bench.work().comparison().images(), nullptr) << "what was opened compares nothing";
}

TEST(Comparison, TheLineIsDraggedAndUndoneLikeAnyView) {
  Bench bench("ground", eye_alone("gmnpr", {"view.compare=uniform"}));
  const Rect eye = bench.work_places().at("view.eye");
  const CameraSettings camera = bench.experiment().camera;
  bench.drag(bench.at("split.eye"), {eye.min.x + 0.25 * eye.size().x, 0.5 * (eye.min.y + eye.max.y)});
  EXPECT_NEAR(bench.experiment().view.split, 0.25, 0.01);
  EXPECT_EQ(bench.experiment().camera, camera) << "the drag is the line's alone";
  bench.drag(bench.at("split.eye"), {eye.min.x - 500.0, 100.0});
  EXPECT_EQ(bench.experiment().view.split, 0.0);
  bench.key('Z', {true, false, false});
  EXPECT_NEAR(bench.experiment().view.split, 0.25, 0.01);
  bench.key('Z', {true, false, false});
  EXPECT_EQ(bench.experiment().view.split, 0.5);
}

TEST(Comparison, SideBySideBothHalvesTurnTheSameCamera) {
  Bench bench("ground", eye_alone("gmnpr", {"view.compare=uniform"}));
  const Rect whole = bench.work_places().at("view.eye");
  bench.key('B', kShift);
  EXPECT_EQ(bench.experiment().view.compare_layout, CompareLayout::side_by_side);
  const Rect half = bench.work_places().at("view.eye");
  EXPECT_NEAR(half.size().x, whole.size().x / 2, 10);
  EXPECT_EQ(bench.work().comparison().images()->size(ViewId::eye), half.size());
  const CameraSettings before = bench.experiment().camera;
  const glm::dvec2 in_b(0.25 * half.max.x + 0.75 * whole.max.x, 0.5 * (whole.min.y + whole.max.y));
  bench.drag(in_b, in_b + glm::dvec2(40.0, 0.0));
  EXPECT_NE(bench.experiment().camera, before);
}

TEST(Comparison, TheNamesStayOnTheirSidesOfTheLineInFrontOfAClass) {
  for (const char* split : {"0.2", "0.5", "0.8"}) {
    Bench bench("ground", {"view.compare=minimax_frustum", "view.tiles=eye,cube,world,body", std::string("view.split=") + split});
    bench.key(key::f11);
    bench.key('4');
    const Rect eye = bench.work_places().at("view.eye");
    const double line = eye.min.x + bench.experiment().view.split * eye.size().x;
    const Rect a = bench.work_places().at("compare.A"), b = bench.work_places().at("compare.B");
    EXPECT_TRUE(a.min.x >= eye.min.x && a.max.x <= line) << split;
    EXPECT_TRUE(b.min.x >= line && b.max.x <= eye.max.x) << split;
  }
}

TEST(Comparison, EachSidesLabelsKeepClearOfTheOtherAndOfItsName) {
  Bench bench("ground", {"view.compare=psm", "view.split=0.4"});
  const auto shown = [&](const ViewImages& images, ViewId id) { return images.picture(id).shown; };
  const ViewImages &a = bench.work().images(), &b = *bench.work().comparison().images();
  EXPECT_EQ(shown(a, ViewId::world).columns, glm::dvec2(0.0, 0.4));
  EXPECT_EQ(shown(b, ViewId::world).columns, glm::dvec2(0.4, 1.0));
  EXPECT_EQ(shown(a, ViewId::world).covered.size(), 1u);
  EXPECT_EQ(shown(b, ViewId::map).covered.size(), 1u);
  EXPECT_EQ(shown(a, ViewId::cube), ShownPart());
  const Rect world = bench.work_places().at("view.world"), line = bench.work_places().at("split.world");
  const glm::dvec2 grip(line.min + line.size() / 2), there = grip + glm::dvec2(0.3 * world.size().x, 0.0);
  bench.drag(grip, there);
  EXPECT_NEAR(shown(a, ViewId::world).columns.y, 0.7, 0.02);
  bench.key('B');
  EXPECT_EQ(shown(bench.work().images(), ViewId::world), ShownPart());
}

TEST(Comparison, TwoMapsNeverShareAPicture) {
  ViewSettings view;
  EXPECT_TRUE(is_split(ViewId::eye, view));
  EXPECT_FALSE(is_split(ViewId::map, view));
  EXPECT_FALSE(is_split(ViewId::cube, view));
  view.compare_layout = CompareLayout::side_by_side;
  EXPECT_FALSE(is_split(ViewId::eye, view));
}

}  // namespace
}  // namespace psm::test
