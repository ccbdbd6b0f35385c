// SPDX-License-Identifier: GPL-3.0-or-later
// Sliders in the real frame loop: what a click, a drag and the keys do to the value.
#include <imgui.h>

#include "harness.h"

namespace psm::test {
namespace {

/// The part of the slider's width at which its grab is.
double grab_part(double place, const Rect& slider) {
  const double grab = 0.7 * ImGui::GetStyle().GrabMinSize, width = slider.size().x;
  return (2.0 + 0.5 * grab + place * (width - 4.0 - grab)) / width;
}

/// A slider without marks to snap to.
struct FovSlider {
  explicit FovSlider(Bench& b) : bench(b) { bench.at(name); }
  double degrees() const { return bench.experiment().camera.vertical_fov_deg; }
  glm::dvec2 grab(double pixels_off) const {
    const Rect rect = bench.work_places().at(name);
    return bench.at(name, grab_part((degrees() - 1.0) / 178.0, rect)) + glm::dvec2(pixels_off, 0.0);
  }
  double per_pixel() const { return 178.0 / (bench.work_places().at(name).size().x - 4.0 - 0.7 * ImGui::GetStyle().GrabMinSize); }
  static constexpr const char* name = "camera.vertical_fov_deg";
  Bench& bench;
};

TEST(Slider, AClickOnTheGrabChangesNothing) {
  Bench bench;
  const FovSlider fov(bench);
  const Experiment before = bench.experiment();
  for (double off : {-3.0, 0.0, 2.0}) {
    bench.click(fov.grab(off));
    EXPECT_EQ(bench.experiment(), before) << off << " pixels beside the grab's middle";
  }
  EXPECT_EQ(bench.work().model().history().undo_count(), 0u);
}

TEST(Slider, TheGrabKeepsThePlaceAtWhichItWasTaken) {
  Bench bench;
  const FovSlider fov(bench);
  const double before = fov.degrees();
  const glm::dvec2 start = fov.grab(3.0);
  bench.drag(start, start + glm::dvec2(-20.0, 0.0));
  EXPECT_NEAR(fov.degrees(), before - 20.0 * fov.per_pixel(), 0.5 * fov.per_pixel());
}

TEST(Slider, AClickBesideTheGrabBringsItThere) {
  Bench bench;
  const FovSlider fov(bench);
  bench.click(bench.at(fov.name, grab_part(0.8, bench.work_places().at(fov.name))));
  EXPECT_NEAR(fov.degrees(), 1.0 + 0.8 * 178.0, fov.per_pixel());
}

TEST(Slider, KeysActOnTheSliderThatWasClicked) {
  Bench bench;
  const FovSlider fov(bench);
  bench.click(fov.grab(0.0));
  const double before = fov.degrees();
  const struct {
    int key;
    double step;
  } presses[] = {{key::right, 1.78}, {key::right, 1.78}, {key::left, -1.78}, {key::page_up, 17.8}, {key::page_down, -17.8}};
  double wanted = before;
  for (const auto& press : presses) {
    bench.key(press.key);
    wanted += press.step;
    EXPECT_NEAR(fov.degrees(), wanted, 1e-9) << press.key;
  }
  EXPECT_EQ(bench.work().model().history().undo_count(), 5u);
  bench.key(key::home);
  EXPECT_EQ(fov.degrees(), 1.0);
  bench.key(key::end);
  EXPECT_EQ(fov.degrees(), 179.0);
}

TEST(Slider, KeysLeaveASliderWithoutFocusAlone) {
  Bench bench;
  const FovSlider fov(bench);
  const double before = fov.degrees();
  bench.click(fov.grab(0.0));
  bench.click(bench.at("view.cube"));
  bench.key(key::right);
  bench.key(key::end);
  EXPECT_EQ(fov.degrees(), before);
}

}  // namespace
}  // namespace psm::test
