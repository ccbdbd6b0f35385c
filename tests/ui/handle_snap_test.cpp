// SPDX-License-Identifier: GPL-3.0-or-later
// A light dragged in the world view through the camera plane stops at w = 0 on its way, as on the sliders.
#include <algorithm>

#include "harness.h"
#include "scene/light_angles.h"
#include "ui/handles.h"

namespace psm::test {
namespace {

const std::vector<PostLight> kThroughThePlane = {PostLight::point, PostLight::directional, PostLight::inverted_point};

struct Grip {
  Bench& bench;
  HandleKind kind;
  glm::dvec2 pixel() const {
    const Rect world = bench.work_places().at("view.world");
    for (const Handle& h : handles(bench.work().images().picture(ViewId::world), bench.experiment(), world.size()))
      if (h.kind == kind) return glm::dvec2(world.min) + h.pixel;
    ADD_FAILURE() << "no such handle";
    return glm::dvec2(0.0);
  }
  /// The cases on the way, without repeats.
  std::vector<PostLight> drag(glm::dvec2 step, int steps) const {
    const glm::dvec2 start = pixel();
    std::vector<PostLight> cases = {bench.analysis().light_case.post};
    bench.press(start);
    for (int i = 1; i <= steps; ++i) {
      bench.move(start + double(i) * step);
      if (bench.analysis().light_case.post != cases.back()) cases.push_back(bench.analysis().light_case.post);
    }
    bench.release();
    return cases;
  }
};

/// The way in the picture along which w falls.
glm::dvec2 towards_zero(Bench& bench) {
  const auto& picture = bench.work().images().picture(ViewId::world);
  const glm::dvec2 size = bench.work_places().at("view.world").size();
  const auto pixel = [&](const glm::dvec3& p) {
    const glm::dvec4 clip = picture.clip_from_list * glm::dvec4(p, 1.0);
    return 0.5 * glm::dvec2(1.0 + clip.x / clip.w, 1.0 - clip.y / clip.w) * size;
  };
  const glm::dvec3 at = bench.experiment().light.position;
  return glm::normalize(pixel(at - view_forward(bench.experiment().camera)) - pixel(at));
}

TEST(HandleSnap, ALampPassesThroughDirectional) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8"});
  const Grip lamp{bench, HandleKind::light_position};
  EXPECT_EQ(lamp.drag(4.0 * towards_zero(bench), 40), kThroughThePlane);
}

TEST(HandleSnap, ASpotPassesThroughDirectional) {
  Bench bench("ground", {"light.type=spot", "light.position=-6,9,-8", "light.target=0,0,-12"});
  const Grip lamp{bench, HandleKind::light_position};
  EXPECT_EQ(lamp.drag(4.0 * towards_zero(bench), 40), kThroughThePlane);
}

TEST(HandleSnap, TheSunPassesThroughDirectional) {
  Bench bench("ground");
  EXPECT_EQ((Grip{bench, HandleKind::sun}.drag({-5.0, 0.0}, 16)), kThroughThePlane);
}

TEST(HandleSnap, AltFrees) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-8"});
  const Grip lamp{bench, HandleKind::light_position};
  bench.input().key(key::alt, true);
  const auto cases = lamp.drag(4.0 * towards_zero(bench), 40);
  bench.input().key(key::alt, false);
  bench.settle();
  EXPECT_EQ(cases, (std::vector<PostLight>{PostLight::point, PostLight::inverted_point}));
}

TEST(HandleSnap, AClickMovesNothing) {
  Bench bench("ground", {"light.type=point", "light.position=-6,9,-0.02"});
  const Experiment before = bench.experiment();
  bench.click(Grip{bench, HandleKind::light_position}.pixel());
  EXPECT_EQ(bench.experiment(), before);
}

}  // namespace
}  // namespace psm::test
