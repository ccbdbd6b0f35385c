// SPDX-License-Identifier: GPL-3.0-or-later
// The heat map and the grid as drawn, against the texels as the processor computes them; and the error view against its counts.
#include <algorithm>
#include <cmath>
#include <set>

#include "draw/texel_overlay.h"
#include "gl/error_view.h"
#include "gl/traced_overlay.h"
#include "gl_fixture.h"
#include "scene/texel_sampling.h"

namespace psm {
namespace {

constexpr glm::ivec2 kSize(320, 180);

class TexelView : public GlTest {
 protected:
  TexelView() : scene_(*builtin_scene("ground")), tracer_(scene_) {
    experiment_.camera = *scene_.camera;
    experiment_.light = *scene_.light;
    experiment_.image = {kSize.x, kSize.y};
  }

  Image eye(const Analysis& analysis) {
    ViewPicture picture = describe_view(ViewId::eye, analysis, kSize);
    picture.title.clear();
    picture.legend = {};
    picture.list = {};
    return draw(scene_, analysis, picture, kSize);
  }

  /// A silhouette runs through pixels whose middle sees nothing.
  static bool beside_seen(const std::vector<Lit>& truth, glm::ivec2 at) {
    for (int y = std::max(0, at.y - 1); y <= std::min(kSize.y - 1, at.y + 1); ++y)
      for (int x = std::max(0, at.x - 1); x <= std::min(kSize.x - 1, at.x + 1); ++x)
        if (truth[std::size_t(y) * kSize.x + std::size_t(x)] != Lit::unseen) return true;
    return false;
  }

  Scene scene_;
  RayTracer tracer_;
  Experiment experiment_;
};

TEST_P(TexelView, heat_map_is_warm_exactly_where_texels_are_larger_than_pixels) {
  experiment_.view.eye_overlay = EyeOverlay::texel_size;
  for (const Technique technique : {Technique::uniform, Technique::psm, Technique::gmnpr}) {
    for (const int resolution : {128, 512}) {
      experiment_.shadow.technique = technique, experiment_.shadow.resolution = resolution;
      const Analysis analysis = analyze(experiment_, scene_);
      const Image image = eye(analysis);
      const VisibleImage seen = see(tracer_, experiment_, kSize.x, kSize.y);
      const std::vector<Lit> truth = trace_light(tracer_, seen, experiment_);
      const std::vector<float> m = texel_sizes(seen, analysis);
      int compared = 0, agreed = 0, warm = 0;
      for (std::size_t i = 0; i < m.size(); ++i) {
        if (m[i] <= 0 || std::abs(std::log2(m[i])) < 0.1) continue;  // the contour has neither colour
        const glm::ivec3 color = pixel(image, int(i) % kSize.x, int(i) / kSize.x);
        const bool is_warm = color.r > color.b;
        ++compared, agreed += is_warm == (m[i] > 1), warm += is_warm;
      }
      ASSERT_GT(compared, 5000);
      EXPECT_GT(agreed, compared * 98 / 100) << name_of(technique) << " " << resolution << ": " << warm << " of " << compared;
    }
  }
}

TEST_P(TexelView, heat_map_has_the_band_of_each_pixel) {
  experiment_.view.eye_overlay = EyeOverlay::anisotropy;  // no hatching, and no contour within its bands
  const Analysis analysis = analyze(experiment_, scene_);
  const HeatScale& scale = *heat_scale(EyeOverlay::anisotropy);
  const Image image = eye(analysis);
  const VisibleImage seen = see(tracer_, experiment_, kSize.x, kSize.y);
  const std::vector<Lit> truth = trace_light(tracer_, seen, experiment_);
  int compared = 0, agreed = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] != Lit::lit || seen.points[i].normal.y < 0.999) continue;  // upright: its tone is 1
    const double octave = std::log2(footprint_at(analysis, seen.points[i]).anisotropy);
    if (std::abs(octave - std::round(octave)) < 0.1) continue;
    const int band = std::clamp(int(std::floor(octave)) - scale.first_bound + 1, 0, int(scale.colors.size()) - 1);
    const glm::ivec3 wanted(glm::round(255.0f * scale.colors[std::size_t(band)]));
    const glm::ivec3 apart = glm::abs(pixel(image, int(i) % kSize.x, int(i) / kSize.x) - wanted);
    ++compared, agreed += std::max({apart.x, apart.y, apart.z}) <= 2;
  }
  ASSERT_GT(compared, 5000);
  EXPECT_GT(agreed, compared * 97 / 100) << "of " << compared;
}

TEST_P(TexelView, grid_lines_lie_between_texels) {
  experiment_.view.texel_grid = false;
  const Image without = eye(analyze(experiment_, scene_));
  experiment_.view.texel_grid = true;
  const Analysis analysis = analyze(experiment_, scene_);
  const Image with = eye(analysis);
  const int step = readable_texel_step(analysis, analysis.clip_from_world(), kSize);
  ASSERT_GE(step, 1);
  const VisibleImage seen = see(tracer_, experiment_, kSize.x, kSize.y);
  const std::vector<Lit> truth = trace_light(tracer_, seen, experiment_);
  int on = 0, on_drawn = 0, off = 0, off_drawn = 0, unseen_drawn = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const glm::ivec2 at(int(i) % kSize.x, int(i) / kSize.x);
    const bool drawn = pixel(with, at.x, at.y) != pixel(without, at.x, at.y);
    if (truth[i] == Lit::unseen && !beside_seen(truth, at)) unseen_drawn += drawn;
    if (truth[i] == Lit::unseen || truth[i] == Lit::away || seen.points[i].normal.y < 0.999) continue;
    const glm::dvec4 q = *analysis.map_from_world * glm::dvec4(seen.points[i].position, 1);
    const glm::dvec2 lines = (glm::dvec2(q) / q.w * 0.5 + 0.5) * double(experiment_.shadow.resolution) / double(step);
    const auto footprint = footprint_at(analysis, seen.points[i]);
    const double least = footprint.m / footprint.anisotropy * step;  // between lines, pixels
    const glm::dvec2 aside = glm::abs(lines - glm::round(lines)) * least;
    if (least < 12) continue;
    if (std::min(aside.x, aside.y) < 0.25) ++on, on_drawn += drawn;
    if (std::min(aside.x, aside.y) > 3.0) ++off, off_drawn += drawn;
  }
  EXPECT_EQ(unseen_drawn, 0);
  ASSERT_GT(on, 20);
  ASSERT_GT(off, 20);
  EXPECT_GT(on_drawn, on * 9 / 10) << "of " << on;
  EXPECT_LT(off_drawn, off / 50 + 1) << "of " << off;
}

TEST_P(TexelView, error_view_colours_each_wrong_pixel_and_counts_it) {
  experiment_.shadow.resolution = 64;
  experiment_.view.eye_overlay = EyeOverlay::errors;
  const Analysis analysis = analyze(experiment_, scene_);
  renderer_->set_scene(scene_);
  renderer_->draw_shadow_map(analysis);
  const ErrorView view = compare_with_truth(*renderer_, tracer_, analysis, kAllPixels);
  EXPECT_FALSE(view.reduced);
  ASSERT_EQ(glm::ivec2(view.image.width, view.image.height), kSize);
  std::size_t colored = 0, kinds = 0;
  for (std::size_t i = 0; i < view.image.rgba.size(); i += 4)
    colored += view.image.rgba[i] != view.image.rgba[i + 1] || view.image.rgba[i] != view.image.rgba[i + 2];
  for (const std::size_t count : view.by_kind) kinds += count;
  EXPECT_GT(colored, 0u);
  EXPECT_EQ(colored, view.errors.wrongly_lit + view.errors.wrongly_dark);
  EXPECT_EQ(colored, kinds);
  EXPECT_EQ(view.by_kind[std::size_t(ErrorKind::resolution_dark)] + view.by_kind[std::size_t(ErrorKind::acne)],
            view.errors.wrongly_dark);

  const ErrorView quick = compare_with_truth(*renderer_, tracer_, analysis, 160 * 90);
  EXPECT_TRUE(quick.reduced);
  EXPECT_EQ(glm::ivec2(quick.image.width, quick.image.height), glm::ivec2(160, 90));

  const TracedOverlay traced{view.image, error_legend(view)};
  ViewPicture eye_view = describe_view(ViewId::eye, analysis, kSize, 1.0, {{}, nullptr, &traced});
  EXPECT_EQ(std::ptrdiff_t(eye_view.legend.entries.size()),
            std::count_if(view.by_kind.begin(), view.by_kind.end(), [](std::size_t count) { return count > 0; }));
  eye_view.legend = {};
  eye_view.title.clear();
  const Image shown = draw(scene_, analysis, eye_view, kSize);
  std::size_t same = 0;
  for (std::size_t i = 0; i < shown.rgba.size(); i += 4)
    same += view.image.rgba[i + 3] == 0 || std::equal(&shown.rgba[i], &shown.rgba[i] + 3, &view.image.rgba[i]);
  EXPECT_GT(same, shown.rgba.size() / 4 * 97 / 100) << "the light's mark may cover some";
}

TEST_P(TexelView, penumbra_view_has_a_colour_for_umbra_penumbra_and_light) {
  experiment_.view.eye_overlay = EyeOverlay::penumbra;
  const auto colors = [&](double radius) {
    experiment_.light.radius = radius;
    const TracedOverlay overlay = trace_overlay(*renderer_, tracer_, analyze(experiment_, scene_), kAllPixels);
    EXPECT_EQ(glm::ivec2(overlay.image.width, overlay.image.height), kSize);
    EXPECT_EQ(overlay.legend.entries.size(), 6u);
    EXPECT_EQ(overlay.legend.lines.empty(), radius > 0.0);
    std::set<std::uint32_t> found;
    for (std::size_t i = 0; i < overlay.image.rgba.size(); i += 4) {
      const std::uint8_t* p = &overlay.image.rgba[i];
      if (p[3] != 0) found.insert(std::uint32_t(p[0] << 16 | p[1] << 8 | p[2]));
    }
    return found.size();
  };
  EXPECT_LE(colors(0.0), 3u);
  EXPECT_GE(colors(0.1), 10u);
}

TEST_P(TexelView, legend_stays_on_the_picture) {
  experiment_.view.eye_overlay = EyeOverlay::texel_size;
  experiment_.view.texel_grid = true;
  const Analysis analysis = analyze_with_statistics(experiment_, scene_, tracer_);
  ASSERT_TRUE(analysis.texels);
  ViewPicture with = describe_view(ViewId::eye, analysis, kSize), without = with;
  without.legend = {};
  const Image a = draw(scene_, analysis, with, kSize), b = draw(scene_, analysis, without, kSize);
  for (int y = 0; y < kSize.y; ++y)
    for (const int x : {0, kSize.x - 1}) EXPECT_EQ(pixel(a, x, y), pixel(b, x, y)) << x << ", " << y;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) changed += !std::equal(&a.rgba[i], &a.rgba[i] + 3, &b.rgba[i]);
  EXPECT_GT(changed, a.rgba.size() / 4 / 20);
}

INSTANTIATE_TEST_SUITE_P(profiles, TexelView, testing::Values(GlProfile::core_or_es, GlProfile::es));

}  // namespace
}  // namespace psm
