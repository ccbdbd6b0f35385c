// SPDX-License-Identifier: GPL-3.0-or-later
// The heat map's scale and legend, and the density of the texel grid.
#include "draw/texel_overlay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/eye_and_light.h"
#include "scene/texel_sampling.h"

namespace psm {
namespace {

using testing::HasSubstr;

const Scene kRoom = box_scene({-5, 0, -5}, {5, 2, 5});

Experiment with(EyeOverlay overlay, bool grid = false) {
  Experiment e;
  e.camera.position = {0, 3, 9};
  e.view.eye_overlay = overlay;
  e.view.texel_grid = grid;
  return e;
}

double luminance(const glm::vec3& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

TEST(HeatScale, IsLightestAtOneAndDarkerOnBothSides) {
  const HeatScale& scale = *heat_scale(EyeOverlay::texel_size);
  const auto first_coarse = std::size_t(1 - scale.first_bound);  // the band that begins at 1
  for (std::size_t i = 0; i + 1 < scale.colors.size(); ++i) {
    const double here = luminance(scale.colors[i]), next = luminance(scale.colors[i + 1]);
    if (i + 1 < first_coarse) {
      EXPECT_GT(next, here + 0.04) << i;
    }
    if (i >= first_coarse) {
      EXPECT_LT(next, here - 0.04) << i;
    }
  }
}

TEST(HeatScale, TellsUndersampledTexelsByHatchingAndByHue) {
  const HeatScale& scale = *heat_scale(EyeOverlay::texel_size);
  for (std::size_t i = 0; i < scale.colors.size(); ++i) {
    const bool coarse = scale.first_bound + int(i) - 1 >= 0;
    EXPECT_EQ(scale.hatched(i), coarse) << i;
    EXPECT_EQ(scale.colors[i].r > scale.colors[i].b, coarse) << i;
  }
  EXPECT_EQ(heat_scale(EyeOverlay::none), nullptr);
  EXPECT_EQ(heat_scale(EyeOverlay::errors), nullptr);
}

TEST(HeatLegend, NamesEachBandAndTheNumbers) {
  Analysis a = analyze(with(EyeOverlay::texel_size), kRoom);
  a.texels = TexelStatistics{1, 0.75, 2.5, 12, 0.375};
  const Legend legend = heat_legend(EyeOverlay::texel_size, a);
  ASSERT_EQ(legend.entries.size(), heat_scale(EyeOverlay::texel_size)->colors.size() + 1);
  EXPECT_EQ(legend.entries[0].text, "<1/4");
  EXPECT_EQ(legend.entries[2].text, "1/2–1");
  EXPECT_EQ(legend.entries[3].text, "1–2");
  EXPECT_EQ(legend.entries[7].text, ">16");
  ASSERT_EQ(legend.lines.size(), 1u);
  for (const char* part : {"0.75", "2.5", "12", "37.5 %"}) EXPECT_THAT(legend.lines[0], HasSubstr(part));
}

TEST(TexelOverlay, TheHeatMapIsTheEyesAlone) {
  const Analysis a = analyze(with(EyeOverlay::anisotropy), kRoom);
  for (const ViewId id : kMainViews) {
    const ViewPicture picture = describe_view(id, a, {800, 600});
    EXPECT_EQ(picture.overlay, id == ViewId::eye ? EyeOverlay::anisotropy : EyeOverlay::none);
    EXPECT_EQ(picture.legend.empty(), id != ViewId::eye);
    EXPECT_EQ(picture.texel_step, 0);
  }
}

TEST(TexelOverlay, TheGridSaysHowDenseItIs) {
  const Analysis a = analyze(with(EyeOverlay::none, true), kRoom);
  for (const ViewId id : kAllViews) {
    const ViewPicture picture = describe_view(id, a, {800, 600});
    if (id != ViewId::eye && id != ViewId::world && id != ViewId::cube) {
      EXPECT_EQ(picture.texel_step, 0);
      continue;
    }
    ASSERT_GE(picture.texel_step, 1);
    EXPECT_EQ(picture.texel_step & (picture.texel_step - 1), 0) << "a power of two";
    ASSERT_EQ(picture.legend.lines.size(), 1u);
    if (picture.texel_step > 2) {
      EXPECT_THAT(picture.legend.lines[0], HasSubstr("every " + std::to_string(picture.texel_step)));
    }
  }
}

TEST(TexelOverlay, GridLinesAreFarEnoughApartToBeRead) {
  for (const int resolution : {64, 1024, 8192}) {
    Experiment e = with(EyeOverlay::none, true);
    e.shadow.resolution = resolution;
    const Analysis a = analyze(e, kRoom);
    const glm::ivec2 size(800, 450);
    const int step = readable_texel_step(a, a.clip_from_world(), size);
    int lines = 0, readable = 0;
    for (double x = -0.95; x < 1.0; x += 0.1)
      for (double y = -0.95; y < 1.0; y += 0.1) {  // on the floor
        const ViewFrame view = camera_frame(e);
        const glm::dvec3 along = view.at(x, y, 1) - view.eye;
        const glm::dvec3 p = view.eye - view.eye.y / along.y * along;
        if (!(along.y < 0.0) || std::max(std::abs(p.x), std::abs(p.z)) > 5.0) continue;
        const double area = footprint_at(a, {p, {0, 1, 0}}, size).area;
        ++lines, readable += std::sqrt(area) * step >= 12.0;
      }
    ASSERT_GT(lines, 50);
    EXPECT_GE(readable, 2 * lines / 5) << resolution << ", every " << step;
    if (step > 1) {
      EXPECT_LT(step, resolution);
    }
  }
}

TEST(TexelOverlay, NothingVisibleHasNoGrid) {
  Experiment e = with(EyeOverlay::texel_size, true);
  e.camera.target = {0, 10, 40};
  const Analysis a = analyze(e, kRoom);
  ASSERT_TRUE(a.receivers_body.empty());
  for (const ViewId id : kAllViews) EXPECT_EQ(describe_view(id, a, {640, 480}).texel_step, 0);
}

}  // namespace
}  // namespace psm
