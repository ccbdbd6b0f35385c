// SPDX-License-Identifier: GPL-3.0-or-later
// One texel and its two rays: Figure 2 of PSM 2002 in numbers, and what each view shows of it.
#include "draw/probe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/projective.h"
#include "scene/texel_sampling.h"

namespace psm {
namespace {

using glm::dvec2, glm::dvec3, glm::dvec4;

const Scene kRoom = box_scene({-5, 0, -5}, {5, 2, 5});
const SurfacePoint kFloor{{1, 0, 2}, {0, 1, 0}};

Experiment seen_from_above(LightType type = LightType::point) {
  Experiment e;
  e.camera.position = {1, 3, 6};
  e.camera.target = {1, 0, 2};
  e.light.type = type;
  e.light.position = {-2, 4, 2};
  return e;
}

Probe probe_of(const Analysis& a, const SurfacePoint& at = kFloor) {
  const auto probe = make_probe(a, at, std::nullopt, true);
  EXPECT_TRUE(probe.has_value());
  return probe.value_or(Probe{});
}

TEST(Probe, HasDistancesAndAnglesOfTheTwoRays) {
  const Probe p = probe_of(analyze(seen_from_above(), kRoom));
  EXPECT_DOUBLE_EQ(p.r_i, 5.0);  // a triangle of 3, 4 and 5 on either side
  EXPECT_DOUBLE_EQ(p.r_s, 5.0);
  EXPECT_NEAR(std::cos(p.alpha), 4.0 / 5.0, 1e-14);
  EXPECT_NEAR(std::cos(p.beta), 3.0 / 5.0, 1e-14) << "between the view direction and the normal";
  EXPECT_NEAR(p.pixel, 2.0 * std::tan(glm::radians(30.0)) / 720, 1e-18);
  EXPECT_NEAR(p.d, p.beam / 5.0 * (3.0 / 4.0) / p.pixel, 1e-9 * p.d);
  EXPECT_TRUE(std::isinf(probe_of(analyze(seen_from_above(LightType::directional), kRoom)).r_s));
}

/// Light, view and normal in one plane, texels wide in that plane only: there the paper's formula is exact.
TEST(Probe, FormulaAndMeasureAgreeInThePapersOwnPlane) {
  Experiment e = seen_from_above(LightType::directional);
  e.light.to_light = {0, 4, -3};
  Analysis a = analyze(e, kRoom);
  // 8 texels a unit across the light in the plane of view and light, 80 a unit across that plane.
  const dvec3 l = glm::normalize(e.light.to_light), x(1, 0, 0), y = glm::cross(x, l);
  const double n = e.shadow.resolution;
  a.map_from_world = from_rows<double>({x * (160 / n), 0}, {y * (16 / n), 0}, {-l * 0.01, 0}, {0, 0, 0, 1});
  const Probe p = probe_of(a);
  EXPECT_NEAR(p.beam, 1.0 / 8.0, 1e-12);
  EXPECT_NEAR(p.d, p.size.m, 1e-9 * p.size.m);
}

TEST(Probe, FootprintIsTheTexelOnTheReceiversPlane) {
  for (const LightType type : {LightType::directional, LightType::point, LightType::spot}) {
    for (const Technique technique : {Technique::uniform, Technique::psm, Technique::gmnpr}) {
      Experiment e = seen_from_above(type);
      e.shadow.technique = technique;
      const Analysis a = analyze(e, kRoom);
      const Probe p = probe_of(a);
      ASSERT_TRUE(p.inside_map);
      ASSERT_EQ(p.footprint.size(), 4u);
      const dvec2 steps[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(p.footprint[i].y, 0.0, 1e-9);
        const dvec4 q = *a.map_from_world * dvec4(p.footprint[i], 1);
        const dvec2 texel = (dvec2(q) / q.w * 0.5 + 0.5) * double(e.shadow.resolution);
        EXPECT_LT(glm::length(texel - dvec2(p.texel) - steps[i]), 1e-6) << name_of(type) << " " << name_of(technique);
      }
    }
  }
}

/// The polygon as the eye sees it has m as its largest extent: the Jacobian against finite differences.
TEST(Probe, MeasuredSizeIsThatOfThePolygonOnTheImage) {
  const Analysis a = analyze(seen_from_above(), kRoom);
  const Probe p = probe_of(a);
  const auto pixel = [&](const dvec3& x) {
    const dvec4 q = a.clip_from_world() * dvec4(x, 1);
    return 0.5 * dvec2(1280, 720) * dvec2(q) / q.w;
  };
  const dvec2 u = pixel(p.footprint[1]) - pixel(p.footprint[0]), v = pixel(p.footprint[3]) - pixel(p.footprint[0]);
  const double largest = (std::hypot(u.x + v.y, u.y - v.x) + std::hypot(u.x - v.y, u.y + v.x)) / 2;
  EXPECT_NEAR(largest, p.size.m, 0.01 * p.size.m);
  const double towards = std::atan2(2 * (u.x * u.y + v.x * v.y), dot(u, u) + dot(v, v) - 2 * (u.y * u.y + v.y * v.y)) / 2;
  const auto numbers = probe_numbers(p);
  const auto shown = std::find_if(numbers.begin(), numbers.end(), [](const auto& line) { return line.first == "orientation"; });
  ASSERT_NE(shown, numbers.end());
  EXPECT_NEAR(std::stod(shown->second), glm::degrees(towards), 1.0);
}

TEST(Probe, AnUnlitSideAndAGrazingLightHaveNoFormula) {
  const Analysis a = analyze(seen_from_above(LightType::directional), kRoom);
  const Probe away = probe_of(a, {kFloor.position, {0, -1, 0}});
  EXPECT_FALSE(away.lit_side);
  EXPECT_TRUE(std::isinf(away.d));
  const dvec3 l = glm::normalize(dvec3(a.light));
  const Probe grazing = probe_of(a, {kFloor.position, perpendicular(l)});
  EXPECT_TRUE(grazing.footprint.empty() || std::isfinite(glm::length(grazing.footprint[0])));
  for (const ViewId id : kAllViews) probe_list(grazing, id, a, {640, 480});
}

TEST(Probe, NeedsAMap) {
  Analysis a = analyze(seen_from_above(), kRoom);
  a.map_from_world.reset();
  a.cube_maps_from_world.reset();
  EXPECT_FALSE(make_probe(a, kFloor, std::nullopt, true));
}

void expect_clean(const DrawList& list) {
  const auto good = [](const dvec4& q) { return std::isfinite(q.x + q.y + q.z + q.w) && q.w > 0; };
  for (const DrawLine& l : list.lines) EXPECT_TRUE(good(l.a) && good(l.b));
  for (const DrawPoint& p : list.points) EXPECT_TRUE(good(p.position));
  for (const DrawLabel& l : list.labels) EXPECT_TRUE(good(l.anchor));
}

bool says(const DrawList& list, const std::string& start) {
  return std::any_of(list.labels.begin(), list.labels.end(), [&](const DrawLabel& l) { return l.text.rfind(start, 0) == 0; });
}

TEST(ProbeList, ShowsTheTexelInEveryView) {
  for (const LightType type : {LightType::directional, LightType::point, LightType::spot}) {
    const Analysis a = analyze(seen_from_above(type), kRoom);
    const auto probe = make_probe(a, kFloor, dvec3(0.5, 1, 2), true);
    ASSERT_TRUE(probe);
    EXPECT_TRUE(probe_list(*probe, ViewId::body, a, {800, 600}).lines.empty());
    for (const ViewId id : kMainViews) {
      const DrawList list = probe_list(*probe, id, a, {800, 600});
      expect_clean(list);
      EXPECT_GE(std::count_if(list.lines.begin(), list.lines.end(), [](const DrawLine& l) { return l.role == Role::texel_grid; }),
                4)
          << name_of(id);
      EXPECT_TRUE(says(list, id == ViewId::map ? "texel " : "m = ")) << name_of(id);
    }
    const DrawList world = probe_list(*probe, ViewId::world, a, {800, 600});
    for (const char* text : {"rₛ = ", "rᵢ = ", "α = ", "β = ", "occluder"}) EXPECT_TRUE(says(world, text)) << text;
  }
}

TEST(ProbeList, SixMapsHaveTheirTexelOnTheSheet) {
  Experiment e = seen_from_above();
  e.light.position = {0, 1, 0};
  const Analysis a = analyze(e, kRoom);
  ASSERT_TRUE(a.cube_maps_from_world);
  const Probe probe = probe_of(a);
  ASSERT_TRUE(probe.inside_map);
  const DrawList list = probe_list(probe, ViewId::map, a, {800, 600});
  ASSERT_FALSE(list.labels.empty());
  const auto back = on_map(a, dvec2(list.labels[0].anchor));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->layer, probe.layer);
  const double n = e.shadow.resolution;
  EXPECT_LT(glm::length((back->center * 0.5 + 0.5) * n - (dvec2(probe.texel) + 0.5)), 1e-6);
}

TEST(ProbeList, BesideTheMapIsNoTexel) {
  const Analysis a = analyze(seen_from_above(), kRoom);
  EXPECT_TRUE(on_map(a, {0.2, -0.9}));
  EXPECT_FALSE(on_map(a, {1.2, 0.0}));
}

}  // namespace
}  // namespace psm
