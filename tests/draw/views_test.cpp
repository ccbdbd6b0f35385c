// SPDX-License-Identifier: GPL-3.0-or-later
// What the four views hold, on analyses of ordinary and of hard experiments.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "draw/view.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4, glm::ivec2;
using testing::HasSubstr;

constexpr ViewId kViews[] = {ViewId::world, ViewId::cube, ViewId::map, ViewId::eye};

const Scene kRoom = box_scene({-5, 0, -5}, {5, 2, 5});

ViewPicture view_of(ViewId id, const Experiment& e, const Scene& scene = kRoom, ivec2 size = {800, 600}) {
  return describe_view(id, analyze(e, scene), size);
}

Experiment experiment_with(LightType type) {
  Experiment e;
  e.camera.position = {0, 3, 9};
  e.light.type = type;
  e.light.position = {2, 6, 1};
  return e;
}

bool has_line(const DrawList& list, Role role) {
  return std::any_of(list.lines.begin(), list.lines.end(), [&](const DrawLine& l) { return l.role == role; });
}
bool has_fill(const DrawList& list, Role role) {
  return std::any_of(list.fills.begin(), list.fills.end(), [&](const DrawFill& f) { return f.role == role; });
}
std::string label_starting(const DrawList& list, const std::string& start) {
  for (const DrawLabel& l : list.labels) {
    if (l.text.rfind(start, 0) == 0) return l.text;
  }
  return "";
}

void expect_clean(const ViewPicture& picture, const std::string& what) {
  auto good = [](const dvec4& q) {
    return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w) && q.w > 0;
  };
  for (const DrawLine& l : picture.list.lines) {
    EXPECT_TRUE(good(l.a) && good(l.b)) << what;
    EXPECT_TRUE(l.fade_a >= 0 && l.fade_a <= 1 && l.fade_b >= 0 && l.fade_b <= 1) << what;
  }
  for (const DrawFill& f : picture.list.fills) {
    EXPECT_GE(f.corners.size(), 3u) << what;
    for (const dvec4& c : f.corners) EXPECT_TRUE(good(c)) << what;
  }
  for (const DrawPoint& p : picture.list.points) EXPECT_TRUE(good(p.position)) << what;
  for (const DrawLabel& l : picture.list.labels) {
    EXPECT_TRUE(good(l.anchor)) << what;
    EXPECT_THAT(l.text, testing::Not(HasSubstr("nan"))) << what;
  }
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(std::isfinite(glm::dot(picture.clip_from_list[i], dvec4(1)))) << what;
}

TEST(WorldView, ShowsEveryRoleForEachLight) {
  for (LightType type : {LightType::directional, LightType::point, LightType::spot}) {
    const DrawList list = view_of(ViewId::world, experiment_with(type)).list;
    for (Role role :
         {Role::frustum, Role::light, Role::caster_body, Role::receivers_body, Role::map_window, Role::scene_bounds}) {
      EXPECT_TRUE(has_line(list, role)) << name_of(type) << ", role " << int(role);
    }
    EXPECT_TRUE(has_fill(list, Role::caster_body) && has_fill(list, Role::receivers_body));
    for (const char* text : {"eye", "light", "R", "H", "S", "V", "map window"}) EXPECT_NE(label_starting(list, text), "") << text;
    EXPECT_LE(list.labels.size(), 12u);
    for (Role role : {Role::light, Role::frustum}) {
      EXPECT_EQ(std::count_if(list.points.begin(), list.points.end(), [&](const DrawPoint& p) { return p.role == role; }), 1);
    }
  }
}

TEST(WorldView, SceneBoundsAreDashed) {
  for (const DrawLine& l : view_of(ViewId::world, experiment_with(LightType::point)).list.lines) {
    if (l.role != Role::scene_bounds) continue;
    EXPECT_EQ(l.style, LineStyle::dashed);
  }
}

TEST(WorldView, TheVanishingPlaneIsDrawnOnThePlane) {
  Experiment e = experiment_with(LightType::point);
  e.shadow.technique = Technique::uniform;
  const Analysis a = analyze(e, kRoom);
  ASSERT_TRUE(a.vanishing_plane);
  const DrawList list = describe_view(ViewId::world, a, {800, 600}).list;
  ASSERT_TRUE(has_fill(list, Role::vanishing_plane));
  EXPECT_EQ(label_starting(list, "vanishing"), "vanishing plane c = 0");
  const double norm = glm::length(dvec3(*a.vanishing_plane));
  for (const DrawFill& f : list.fills) {
    if (f.role != Role::vanishing_plane) continue;
    for (const dvec4& c : f.corners) EXPECT_NEAR(glm::dot(*a.vanishing_plane, c) / norm, 0.0, 1e-9);
  }
}

TEST(WorldView, APlaneAtInfinityIsNotDrawn) {
  Experiment e;
  e.shadow.technique = Technique::uniform;
  EXPECT_FALSE(has_line(view_of(ViewId::world, e).list, Role::vanishing_plane));
}

TEST(WorldView, RaysEndOnTheReceiversAndComeFromTheLight) {
  for (LightType type : {LightType::directional, LightType::point}) {
    const Analysis a = analyze(experiment_with(type), kRoom);
    int rays = 0;
    for (const DrawLine& l : describe_view(ViewId::world, a, {800, 600}).list.lines) {
      if (l.role != Role::light || !l.arrow) continue;
      ++rays;
      const dvec3 travel = glm::normalize(dvec3(l.b) - dvec3(l.a));
      const dvec3 to_light = glm::normalize(dvec3(a.light) - a.light.w * dvec3(l.b));
      EXPECT_NEAR(glm::dot(travel, to_light), -1.0, 1e-9);
    }
    EXPECT_GE(rays, 3);
    EXPECT_LE(rays, 6);
  }
}

TEST(CubeView, FrustumCornersAreAtOne) {
  const DrawList list = view_of(ViewId::cube, Experiment{}).list;
  int edges = 0;
  for (const DrawLine& l : list.lines) {
    if (l.role != Role::frustum || l.arrow) continue;
    ++edges;
    EXPECT_EQ(glm::abs(dvec3(l.a)), dvec3(1.0));
    EXPECT_EQ(glm::abs(dvec3(l.b)), dvec3(1.0));
  }
  EXPECT_EQ(edges, 12);
  EXPECT_NE(label_starting(list, "near"), "");
  EXPECT_NE(label_starting(list, "far"), "");
  for (const char* axis : {"x'", "y'", "z'"}) EXPECT_EQ(label_starting(list, axis), axis);
}

TEST(CubeView, TheInfinityPlaneIsWhereTheProjectionPutsIt) {
  for (double far : {2.0, 10.1, 1000.0, std::numeric_limits<double>::infinity()}) {
    Experiment e;
    e.camera.near = 0.1;
    e.camera.far = far;
    const double expected = std::isinf(far) ? 1.0 : (far + 0.1) / (far - 0.1);
    int corners = 0;
    for (const DrawFill& f : view_of(ViewId::cube, e).list.fills) {
      if (f.role != Role::infinity) continue;
      for (const dvec4& c : f.corners) EXPECT_NEAR(c.z / c.w, expected, 1e-12);
      corners += int(f.corners.size());
    }
    EXPECT_EQ(corners, 4) << far;
  }
  Experiment e;
  e.camera.near = 1;
  e.camera.far = 101;
  EXPECT_EQ(label_starting(view_of(ViewId::cube, e).list, "∞ plane"), "∞ plane z' = 1.02");
}

TEST(CubeView, NothingIsDrawnBeyondThreeCubes) {
  Experiment e = experiment_with(LightType::point);
  e.light.position = {1, 4, 14};
  const DrawList list = view_of(ViewId::cube, e).list;
  for (const DrawLine& l : list.lines) {
    for (const dvec4& p : {l.a, l.b}) EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(dvec3(p) / p.w), dvec3(3.0 + 1e-9))));
  }
  for (const DrawFill& f : list.fills) {
    for (const dvec4& p : f.corners) EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(dvec3(p) / p.w), dvec3(3.0 + 1e-9))));
  }
}

TEST(CubeView, RaysOfAnInvertedLightConvergeOnIt) {
  Experiment e = experiment_with(LightType::point);
  e.camera.near = 1;
  e.camera.far = 30;
  e.light.position = {1, 4, 14};  // behind the eye
  const Analysis a = analyze(e, kRoom);
  ASSERT_EQ(a.light_case.post, PostLight::inverted_point);
  const dvec4 l = a.clip_from_world() * a.light;
  const dvec3 light = dvec3(l) / l.w;
  int arriving = 0;
  for (const DrawLine& line : describe_view(ViewId::cube, a, {800, 600}).list.lines) {
    if (line.role != Role::light || !line.arrow || line.style == LineStyle::dashed) continue;
    const dvec3 end(line.b), travel = glm::normalize(end - dvec3(line.a));
    if (glm::any(glm::greaterThan(glm::abs(end), dvec3(1.0 + 1e-9)))) continue;  // the pieces that leave
    EXPECT_NEAR(glm::dot(travel, glm::normalize(light - end)), 1.0, 1e-6);
    ++arriving;
  }
  EXPECT_GE(arriving, 3);
}

// PSM 2002, Figure 7: after the shift the cube is the shifted frustum, H lies in front of the eye, and V inside the cube.
TEST(CubeView, ShowsTheShiftedSpace) {
  Experiment x;
  x.camera = {{0, 1.5, 0}, {0, 1.5, -1}, {0, 1, 0}, 60, 0.5, 20};
  x.light.to_light = {0.1, 0.4, 1};
  x.shadow.technique = Technique::psm_divided;
  const Analysis a = analyze(x, kRoom);
  ASSERT_GT(a.camera_shift, 0.0);
  for (const glm::dvec3& p : a.caster_body.vertices) EXPECT_GT((a.cube_from_world * glm::dvec4(p, 1)).w, 0.0);
  for (const glm::dvec4& p : a.frustum_corners) {
    const glm::dvec4 q = a.cube_from_world * p;
    for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(q[i] / q.w), 1.0 + 1e-12);
  }
  const ViewPicture picture = describe_view(ViewId::cube, a, {800, 600});
  EXPECT_NE(picture.title.find("moved back"), std::string::npos);
  EXPECT_EQ(picture.cube_from_world, a.cube_from_world);
}

TEST(CubeView, LightIsNamedByItsCase) {
  Experiment e = experiment_with(LightType::point);
  e.light.position = {0, 3, 0};
  EXPECT_THAT(label_starting(view_of(ViewId::cube, e).list, "l'"), HasSubstr("(point)"));
  e.light.position = {0, 3, 14};
  EXPECT_THAT(label_starting(view_of(ViewId::cube, e).list, "l'"), HasSubstr("(inverted point)"));
  e = Experiment{};
  e.camera.position = {0, 1, 9};
  e.light.to_light = {0, 1, 0};
  EXPECT_THAT(label_starting(view_of(ViewId::cube, e).list, "l'"), HasSubstr("(directional)"));
}

TEST(MapView, ReceiversFillTheWindow) {
  const ViewPicture picture = view_of(ViewId::map, experiment_with(LightType::spot));
  EXPECT_EQ(picture.scene, ScenePicture::map_depth);
  EXPECT_EQ(picture.title, "Shadow map 1024 x 1024");
  dvec3 low(1e9), high(-1e9);
  for (const DrawLine& l : picture.list.lines) {
    if (l.role != Role::receivers_body) continue;
    low = glm::min(low, dvec3(l.a));
    high = glm::max(high, dvec3(l.a));
  }
  EXPECT_NEAR(low.x, -1, 1e-6);
  EXPECT_NEAR(low.y, -1, 1e-6);
  EXPECT_NEAR(high.x, 1, 1e-6);
  EXPECT_NEAR(high.y, 1, 1e-6);
  EXPECT_TRUE(has_line(picture.list, Role::frustum) && has_line(picture.list, Role::texel_grid) &&
              has_line(picture.list, Role::map_window));
}

TEST(MapView, PanAndZoomKeepTheMapSquare) {
  Experiment e;
  e.view.map_center = {0.5, -0.25};
  e.view.map_zoom = 4;
  for (ivec2 size : {ivec2(900, 600), ivec2(600, 900)}) {
    const glm::dmat4 m = view_of(ViewId::map, e, kRoom, size).clip_from_list;
    EXPECT_EQ(m * dvec4(0.5, -0.25, 0, 1), dvec4(0, 0, 0, 1));
    EXPECT_NEAR(m[0][0] * size.x, m[1][1] * size.y, 1e-9);
  }
}

TEST(MapView, SixMapsAreAContactSheet) {
  Experiment e = experiment_with(LightType::point);
  e.light.position = {0, 1, 0};
  const Analysis a = analyze(e, kRoom);
  ASSERT_TRUE(a.cube_maps_from_world);
  const ViewPicture picture = describe_view(ViewId::map, a, {900, 600});
  EXPECT_THAT(picture.title, HasSubstr("Six maps of 90°"));
  ASSERT_EQ(picture.list.labels.size(), 6u);
  EXPECT_EQ(picture.list.labels[4].text, "+z");
  EXPECT_LT(glm::distance(dvec3(picture.list.labels[4].anchor), dvec3(0.0, 0.3 * 2.0 / 3.0 - 2.0 / 3.0, 0.0)), 1e-12);
  EXPECT_NEAR(picture.clip_from_list[0][0] * 900, picture.clip_from_list[1][1] * 600, 1e-9) << "cells are square";
}

TEST(MapView, TwoMapsStandSideBySideWithOneWindow) {
  Experiment e;
  e.camera = {{0, 1.5, 0}, {0, 1.5, -1}, {0, 1, 0}, 60, 0.5, 20};
  e.light.to_light = {0.1, 0.4, 1};
  e.shadow.technique = Technique::psm_two_maps;
  const ViewPicture picture = view_of(ViewId::map, e);
  EXPECT_EQ(picture.title, "Two maps 1024 x 1024");
  EXPECT_LT(label_starting(picture.list, "w > 0").size(), 30u);
  EXPECT_LT(label_starting(picture.list, "w < 0").size(), 30u);
  std::vector<double> left, right;
  for (const DrawLine& l : picture.list.lines) {
    for (const dvec4& p : {l.a, l.b})
      EXPECT_LE(std::max(std::abs(p.x), 2 * std::abs(p.y)), p.w * (1 + 1e-6)) << "within the sheet";
    if (l.role == Role::receivers_body) (l.a.x + l.b.x < 0.0 ? left : right).push_back(l.a.x);
  }
  ASSERT_GE(left.size(), 3u);
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) EXPECT_NEAR(left[i] + 1.0, right[i], 1e-12);
}

TEST(Titles, SayWhyTheMapIsNotTheOneAskedFor) {
  Experiment e = experiment_with(LightType::point);
  e.light.position = {0, 1, 0};
  EXPECT_EQ(view_of(ViewId::map, e).title, "Six maps of 90°, not gmnpr: light in R");
  EXPECT_EQ(view_of(ViewId::eye, e).title, "Eye, six maps, not gmnpr: light in R");
  e = Experiment{};
  e.camera.position = {0, 1, 4};
  e.camera.target = {0, 1, 0};
  e.light.to_light = {0, 0.01, 1};
  e.shadow.technique = Technique::glpr;
  EXPECT_EQ(view_of(ViewId::map, e).title, "Shadow map 1024 x 1024, uniform, not glpr");
  EXPECT_EQ(view_of(ViewId::eye, e).title, "Eye, uniform, not glpr");
}

TEST(EyeView, LetterboxesToTheImage) {
  Experiment e;
  e.image = {1600, 800};
  const ViewPicture wide = view_of(ViewId::eye, e, kRoom, {800, 800});
  EXPECT_EQ(wide.image_rect, dvec4(-1, -0.5, 1, 0.5));
  const ViewPicture tall = view_of(ViewId::eye, e, kRoom, {1600, 400});
  EXPECT_EQ(tall.image_rect, dvec4(-0.5, -1, 0.5, 1));
  const Analysis a = analyze(e, kRoom);
  const dvec4 corner = wide.clip_from_world * a.frustum_corners[2];
  EXPECT_NEAR(corner.x / corner.w, 1, 1e-9);
  EXPECT_NEAR(corner.y / corner.w, 0.5, 1e-9);
}

TEST(LightCaseText, SaysCaseAndDecidingNumber) {
  Analysis a;
  a.light_case.post = PostLight::inverted_point;
  a.light_case.w = -0.12;
  a.light_case.reversed_order = true;
  EXPECT_EQ(light_case_text(a), "directional light \u2192 inverted point light  w = -0.12 < 0  naive depth order reversed");
  a.light_case.post = PostLight::directional;
  a.experiment.light.type = LightType::point;
  EXPECT_EQ(light_case_text(a), "point light \u2192 directional light  w = 0  naive depth order reversed");
  a.light_case = {};
  a.experiment.light.type = LightType::directional;
  EXPECT_EQ(light_case_text(a), "directional light  w = 0  naive depth order kept");
  a.light_case.post = PostLight::point;
  a.light_case.w = 0.0004;
  a.light_case.kappa = 0.0003;
  a.light_case.within_half_texel = true;
  a.experiment.shadow.resolution = 1000;
  EXPECT_EQ(light_case_text(a), "directional (within half a texel: |kappa| = 0.0003 < 1/(2N) = 0.0005)");
}

// ---- hard configurations ------------------------------------------------------------------------------------------

std::vector<Scene> hard_scenes() {
  return {kRoom, box_scene({-5, 0, -5}, {5, 0, 5}), box_scene({1, 1, 1}, {1, 1, 1}), box_scene({-5, 0, 100}, {5, 2, 110}),
          box_scene({-5, 0, -5}, {5, 0, -5})};
}

void expect_clean_views(const Experiment& e, const std::string& what) {
  const auto scenes = hard_scenes();
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    const Analysis a = analyze(e, scenes[s]);
    for (ViewId id : kViews)
      expect_clean(describe_view(id, a, {640, 480}), what + ", scene " + std::to_string(s) + ", view " + name_of(id));
    EXPECT_THAT(light_case_text(a), testing::Not(HasSubstr("nan"))) << what;
  }
}

TEST(HardViews, LightsInAwkwardPlaces) {
  Experiment e = experiment_with(LightType::point);
  const dvec3 eye = e.camera.position, forward = glm::normalize(e.camera.target - eye);
  const dvec3 across = glm::normalize(glm::cross(forward, e.camera.up));
  for (double far : {100.0, std::numeric_limits<double>::infinity()}) {
    e.camera.far = far;
    for (LightType type : {LightType::point, LightType::spot}) {
      e.light.type = type;
      for (const dvec3& p : {eye, eye + 2.0 * across, eye - 3.0 * forward, eye + 1e-9 * forward, dvec3(0, 1, 0), dvec3(0, 0, 0),
                             dvec3(5, 2, 5), dvec3(0, 1e9, 0)}) {
        e.light.position = p;
        e.light.target = p + dvec3(0, -1, 0.1);
        expect_clean_views(
            e, std::string(name_of(type)) + " at " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z));
      }
    }
    e.light.type = LightType::directional;
    for (const dvec3& d :
         {forward, -forward, across, dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(1e-30, 1e-30, 0), dvec3(0, 0, 1e30)}) {
      e.light.to_light = d;
      expect_clean_views(e, "directional");
    }
  }
}

TEST(HardViews, RandomExperimentsAtEveryScale) {
  std::mt19937 random(2002);
  auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (int i = 0; i < 150; ++i) {
    const double scale = i % 3 == 0 ? 1e-6 : i % 3 == 1 ? 1.0 : 1e6;
    auto point = [&] { return scale * dvec3(uniform(-8, 8), uniform(-2, 8), uniform(-8, 8)); };
    const Scene scene = box_scene(scale * dvec3(-5, 0, -5), scale * dvec3(5, uniform(0, 3), 5));
    Experiment e;
    e.camera.position = point();
    e.camera.target = point();
    e.camera.near = scale * uniform(0.01, 1);
    e.camera.far = i % 5 == 0 ? std::numeric_limits<double>::infinity() : scale * uniform(2, 200);
    e.camera.vertical_fov_deg = uniform(5, 170);
    e.light.type = LightType(random() % 3);
    e.light.position = point();
    e.light.target = point();
    e.light.to_light = point();
    e.light.cone_deg = uniform(1, 179);
    e.shadow.technique = Technique(random() % 8);
    const Analysis a = analyze(e, scene);
    for (ViewId id : kViews)
      expect_clean(describe_view(id, a, {640, 480}), "random " + std::to_string(i) + ", view " + name_of(id));
  }
}

TEST(HardViews, NothingAtAll) {
  const Analysis a;
  for (ViewId id : kViews) expect_clean(describe_view(id, a, {0, 0}), name_of(id));
}

}  // namespace
}  // namespace psm
