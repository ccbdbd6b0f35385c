// SPDX-License-Identifier: GPL-3.0-or-later
// The whole analysis: what the contract promises of its matrices, on random experiments, and the hard cases it must survive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "math/shadow_map.h"
#include "scene/analysis.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4, glm::dmat4;

const Scene kGround = box_scene({-100, -10, -200}, {100, 0, 0});
const Scene kRoom = box_scene({-4, 0, -5}, {4, 3, 5});

Experiment standing(Technique t = Technique::psm) {
  Experiment x;
  x.camera = {{0, 1.7, 0}, {0, 1.7, -1}, {0, 1, 0}, 60, 1, 100};
  x.shadow.technique = t;
  return x;
}

bool has_note(const Analysis& a, const std::string& code) {
  return std::any_of(a.notes.begin(), a.notes.end(), [&](const Note& n) { return n.code == code; });
}

bool finite(const dmat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

bool inside(const ConvexBody& body, dvec3 p, double tolerance) {
  return std::all_of(body.planes.begin(), body.planes.end(),
                     [&](const Plane& q) { return glm::dot(q, dvec4(p, 1)) >= -tolerance * glm::length(dvec3(q)); });
}

void expect_contract(const Analysis& a) {
  ASSERT_NE(a.map_from_world.has_value(), a.cube_maps_from_world.has_value());
  if (a.cube_maps_from_world) {
    EXPECT_TRUE(a.light_case.inside_receivers);
    for (const dmat4& m : *a.cube_maps_from_world) {
      ASSERT_TRUE(finite(m));
      const dvec4 q = m * a.light;
      EXPECT_LT(q.z, 0);
    }
    return;
  }
  const dmat4& M = *a.map_from_world;
  ASSERT_TRUE(finite(M));
  if (a.technique_used == Technique::psm_recipe || a.technique_used == Technique::psm_divided ||
      a.technique_used == Technique::psm_two_maps)
    return;  // they break the rule
  const dvec4 light = a.light.w == 0 ? dvec4(safe_normalize(dvec3(a.light)), 0) : a.light;
  const dvec4 Ml = M * light;
  EXPECT_LT(Ml.z, 0);
  for (const int i : {0, 1, 3}) EXPECT_LE(std::abs(Ml[i]), 1e-12 * glm::length(row(M, i)) * glm::length(light));
  if (a.receivers_body.empty()) return;
  const bool padded = has_note(a, "window_padded");
  const bool near_distance = has_note(a, "light_near_distance");
  Range<double> u, v, z, w;
  for (const dvec3& p : a.receivers_body.vertices) {
    const dvec4 q = M * dvec4(p, 1);
    ASSERT_GT(q.w, 0);
    u.add(q.x / q.w), v.add(q.y / q.w), w.add(q.w);
  }
  for (const dvec3& p : a.depth_body.vertices) {
    const dvec4 q = M * dvec4(p, 1);
    if (near_distance && q.w < 1e-3) continue;  // the light itself, or as good as it
    ASSERT_GT(q.w, 0);
    z.add(q.z / q.w);
  }
  if (near_distance && a.experiment.light.type == LightType::point) {  // only for a light among the casters, or as good as it
    EXPECT_TRUE(inside(a.scene_body, dvec3(a.light), 1e-12) || w.min < 1e-4);
  }
  const double tight = 1e-9 + 1e-14 / w.min;  // rounding grows towards the vanishing plane
  if (!padded) {
    for (const auto& r : {u, v}) {
      EXPECT_NEAR(r.min, -1, tight);
      EXPECT_NEAR(r.max, 1, tight);
    }
  }
  EXPECT_LE(z.max, 1 + tight);
  EXPECT_GE(z.min, -1 - tight);
  if (!has_note(a, "depth_padded")) {
    EXPECT_NEAR(z.max, 1, tight);
    if (!near_distance) {
      EXPECT_NEAR(z.min, -1, tight);
    }
  }
}

class Random {
 public:
  explicit Random(unsigned seed) : rng_(seed) {}
  double in(double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng_); }
  dvec3 point(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  int index(int n) { return int(rng_() % unsigned(n)); }

 private:
  std::mt19937_64 rng_;
};

Experiment random_experiment(Random& r) {
  Experiment x;
  x.camera.position = r.point(6);
  x.camera.target = r.point(3);
  x.camera.vertical_fov_deg = r.in(20, 100);
  x.camera.near = std::pow(10, r.in(-3, 0));
  x.camera.far = r.index(5) == 0 ? std::numeric_limits<double>::infinity() : x.camera.near * std::pow(10, r.in(0.5, 4));
  x.light.type = LightType(r.index(3));
  x.light.to_light = r.point(1);
  x.light.position = r.point(r.index(2) ? 4 : 12);
  x.light.target = r.point(3);
  x.light.cone_deg = r.in(5, 150);
  x.shadow.technique = Technique(r.index(8));
  x.shadow.near_fit = r.index(3) ? NearFit::bounds : NearFit::off;
  x.shadow.warp_range = r.index(3) ? WarpRange::receivers : WarpRange::frustum;
  return x;
}

TEST(Analyze, RandomExperimentsKeepTheContract) {
  Random r(1);
  int single = 0, six = 0, empty = 0;
  for (int round = 0; round < 6000; ++round) {
    const Experiment x = random_experiment(r);
    const Analysis a = analyze(x, kRoom);
    SCOPED_TRACE(::testing::Message() << "round " << round << " " << name_of(x.shadow.technique) << " " << name_of(x.light.type));
    expect_contract(a);
    if (::testing::Test::HasFailure()) return;
    (a.receivers_body.empty() ? empty : a.map_from_world ? single : six)++;
  }
  EXPECT_GT(single, 2000);
  EXPECT_GT(six, 50);
  EXPECT_GT(empty, 50);
}

TEST(Analyze, SameInputsSameBits) {
  Random r(2);
  for (int i = 0; i < 50; ++i) {
    const Experiment x = random_experiment(r);
    EXPECT_EQ(analysis_to_json(analyze(x, kRoom), kRoom), analysis_to_json(analyze(x, kRoom), kRoom));
  }
}

/// Largest distance in the map between two mappings, over the first one's receivers.
double map_distance(const Analysis& a, const Analysis& b) {
  double d = 0;
  for (const dvec3& p : a.receivers_body.vertices) {
    const dvec4 q = *a.map_from_world * dvec4(p, 1), r = *b.map_from_world * dvec4(p, 1);
    d = std::max(d, glm::length(dvec3(q) / q.w - dvec3(r) / r.w));
  }
  return d;
}

Analysis sun_at(double theta_deg, Technique t) {
  Experiment x = standing(t);
  const double a = theta_deg / 57.29577951308232;
  x.light.to_light = {0.1 * std::sin(a), std::sin(a), -std::cos(a)};
  return analyze(x, kGround);
}

TEST(Analyze, ContinuousThroughTheCameraPlaneAndTheCriticalAngle) {
  for (const Technique t : {Technique::uniform, Technique::psm, Technique::lispsm, Technique::lispsm_reference, Technique::gmnpr,
                            Technique::minimax, Technique::minimax_frustum}) {
    for (double theta = 5; theta < 175; theta += 0.5) {
      EXPECT_LT(map_distance(sun_at(theta, t), sun_at(theta + 1e-7, t)), 1e-4) << name_of(t) << " " << theta;
    }
    const double phi_deg = *sun_at(30, Technique::gmnpr).phi * 57.29577951308232;
    for (const double theta : {90.0, phi_deg})
      EXPECT_LT(map_distance(sun_at(theta - 1e-8, t), sun_at(theta + 1e-8, t)), 1e-5) << name_of(t) << " " << theta;
  }
}

TEST(Analyze, LightDraggedThroughTheCameraPlane) {
  Experiment x = standing();
  x.light.type = LightType::point;
  std::optional<Analysis> last;
  for (double z = -0.5; z <= 0.5; z += 1e-3) {
    x.light.position = {6, 20, z};
    const Analysis a = analyze(x, kGround);
    expect_contract(a);
    const PostLight expected = z < -1e-9 ? PostLight::point : z > 1e-9 ? PostLight::inverted_point : PostLight::directional;
    EXPECT_EQ(a.light_case.post, expected) << z;
    EXPECT_EQ(a.light_case.reversed_order, z > 1e-9);
    if (last) {
      EXPECT_LT(map_distance(*last, a), 0.05) << z;
    }
    last = a;
  }
  x.light.position = {6, 20, 0};
  EXPECT_EQ(analyze(x, kGround).light_case.post, PostLight::directional);
}

TEST(Analyze, RecedingEyeTendsToTheUniformMap) {
  Experiment x = standing();
  x.light.to_light = {0.2, 1, -0.4};
  double last = 1e9;
  for (const double shift : {1e2, 1e4, 1e6, 1e8}) {
    x.shadow.camera_shift = shift;
    const dmat4 M = *analyze(x, kGround).map_from_world;
    const Analysis a = analyze(x, kGround);
    Range<double> c = value_range<double>(row(M, 3), a.receivers_body.vertices);
    EXPECT_LT(c.max / c.min - 1, last);
    last = c.max / c.min - 1;
  }
  EXPECT_LT(last, 1e-5);
}

// The authors' LiSPSM code is left out: its strength does not depend on the angle.
TEST(Analyze, LightAlongTheViewIsTheUniformMap) {
  for (const Technique t :
       {Technique::psm, Technique::lispsm, Technique::glpr, Technique::gmnpr, Technique::minimax, Technique::minimax_frustum}) {
    Experiment x = standing(t);
    x.camera.target = {0, 1.2, -1};
    x.light.to_light = x.camera.position - x.camera.target;
    const Analysis a = analyze(x, box_scene(dvec3(-500), dvec3(500)));
    const Range<double> c = value_range<double>(row(*a.map_from_world, 3), a.receivers_body.vertices);
    EXPECT_NEAR(c.max / c.min, 1, 1e-6) << name_of(t);
  }
}

TEST(Analyze, GlprFallsBackByNameBelowPhi) {
  const Analysis a = sun_at(10, Technique::glpr);
  EXPECT_EQ(a.technique_used, Technique::uniform);
  EXPECT_TRUE(has_note(a, "glpr_needs_theta_above_phi"));
  EXPECT_EQ(sun_at(80, Technique::glpr).technique_used, Technique::glpr);
}

TEST(Analyze, WorseThanUniformIsSaid) {
  Experiment x = standing(Technique::gmnpr);
  x.camera.far = 800;
  const double theta = 20 / 57.29577951308232;
  x.light.to_light = {0, std::sin(theta), -std::cos(theta)};
  const Analysis a = analyze(x, box_scene({-1000, -1, -1000}, {1000, 1.6, 1000}));
  EXPECT_NEAR(*a.far, 800, 1e-9);
  EXPECT_TRUE(a.worse_than_uniform);
  EXPECT_TRUE(has_note(a, "worse_than_uniform"));
  x.light.to_light = {0, 1, 0};
  EXPECT_FALSE(analyze(x, box_scene({-1000, -1, -1000}, {1000, 1.6, 1000})).worse_than_uniform);
}

TEST(Analyze, CasterBodyHoldsTheReceiversAndTheirCasters) {
  Random r(6);
  for (int round = 0; round < 1000; ++round) {
    const Analysis a = analyze(random_experiment(r), kRoom);
    if (a.receivers_body.empty()) continue;
    ASSERT_FALSE(a.caster_body.empty());
    for (const dvec3& p : a.receivers_body.vertices) EXPECT_TRUE(inside(a.caster_body, p, 1e-9));
    for (const dvec3& p : a.depth_body.vertices) EXPECT_TRUE(inside(a.caster_body, p, 1e-9));
    EXPECT_LE(a.depth_body.volume(), a.caster_body.volume() * (1 + 1e-9));
  }
}

TEST(Analyze, ScaleDoesNotMatter) {
  Random r(5);
  for (int round = 0; round < 200; ++round) {
    const Experiment x = random_experiment(r);
    const Analysis a = analyze(x, kRoom);
    for (const double scale : {0x1p-20, 0x1p20}) {
      Experiment y = x;
      for (dvec3* p : {&y.camera.position, &y.camera.target, &y.light.position, &y.light.target}) *p *= scale;
      y.camera.near *= scale, y.camera.far *= scale;
      y.light.to_light *= 1e30;
      const Analysis b = analyze(y, box_scene(kRoom.bounds.min * scale, kRoom.bounds.max * scale));
      EXPECT_EQ(a.technique_used, b.technique_used);
      EXPECT_EQ(a.light_case.post, b.light_case.post);
      ASSERT_EQ(a.map_from_world.has_value(), b.map_from_world.has_value());
      if (!a.map_from_world || a.receivers_body.empty()) continue;
      ASSERT_EQ(a.receivers_body.vertices.size(), b.receivers_body.vertices.size());
      for (const dvec3& p : a.receivers_body.vertices) {
        const dvec4 q = *a.map_from_world * dvec4(p, 1), s = *b.map_from_world * dvec4(p * scale, 1);
        EXPECT_LT(glm::length(dvec3(q) / q.w - dvec3(s) / s.w), 1e-6);
      }
    }
  }
}

// The one-scene table with the sun behind the viewer: where the measured 95 % of m is above the uniform map's, the note says so.
TEST(Analyze, SunBehindLosesToUniformAtSmallAnglesOnly) {
  for (const Technique t : {Technique::psm, Technique::lispsm, Technique::gmnpr, Technique::lispsm_reference}) {
    for (const auto& [theta, loses] : {std::pair{1.0, true}, {5.0, true}, {20.0, false}, {60.0, false}, {90.0, false}}) {
      Experiment x = standing(t);
      x.image = {640, 360};
      const double a = theta / 57.29577951308232;
      x.light.to_light = {0, std::sin(a), std::cos(a)};
      EXPECT_EQ(has_note(analyze(x, kGround), "worse_than_uniform_texels"), loses) << name_of(t) << " " << theta;
    }
  }
}

TEST(Analyze, AForcedShiftThatNothingUsesIsSaid) {
  Experiment x = standing(Technique::gmnpr);
  x.shadow.camera_shift = 3.0;
  EXPECT_TRUE(has_note(analyze(x, kGround), "camera_shift_unused"));
  x.shadow.technique = Technique::psm;
  EXPECT_EQ(analyze(x, kGround).camera_shift, 3.0);
}

double nearest_depth(const Analysis& a, const dvec3& eye) {
  double nearest = 1e300;
  for (const dvec3& p : a.caster_body.vertices) nearest = std::min(nearest, eye.z - p.z);  // standing() looks along -z
  return nearest;
}

TEST(Analyze, BothMinimalShiftsAreThereByName) {
  for (const Technique t : {Technique::psm, Technique::psm_divided, Technique::psm_recipe}) {
    Experiment x = standing(t);
    x.light.to_light = {0.1, 0.5, 1};
    const auto shift = [&](const CameraShift& s) { return x.shadow.camera_shift = s, analyze(x, kGround).camera_shift; };
    const double in_front = shift(ShiftRule::in_front), inside = shift(ShiftRule::inside);
    const Analysis a = analyze(x, kGround);
    EXPECT_NEAR(nearest_depth(a, x.camera.position) + in_front, *a.near, 1e-9) << name_of(t);
    EXPECT_GT(inside, in_front) << name_of(t);
    EXPECT_EQ(shift(ShiftRule::automatic), t == Technique::psm           ? 0.0
                                           : t == Technique::psm_divided ? in_front
                                                                         : inside)
        << name_of(t);
    EXPECT_EQ(shift(2.5), 2.5) << name_of(t);
  }
}

// PSM 2002, section 4.2: the second map is there exactly where casters may stand behind the eye.
TEST(Analyze, TwoMapsWhereCastersMayStandBehindTheEye) {
  Experiment x = standing(Technique::psm_two_maps);
  x.light.to_light = {0.1, 0.2, 1};
  const Analysis two = analyze(x, kRoom);
  ASSERT_TRUE(two.map_from_world && two.map_beyond_from_world);
  EXPECT_TRUE(two.reversed_depth);
  EXPECT_EQ(two.technique_used, Technique::psm_two_maps);
  EXPECT_EQ(two.camera_shift, 0.0);
  EXPECT_FALSE(has_note(two, "one_map_enough"));
  for (const dvec3& p : two.receivers_body.vertices) {
    const dvec4 front = *two.map_from_world * dvec4(p, 1), beyond = *two.map_beyond_from_world * dvec4(p, 1);
    EXPECT_LE(std::abs(front.z), front.w * (1 + 1e-9));
    EXPECT_GT(beyond.z, beyond.w) << "a receiver lies before what the second map holds";
  }
  x.light.to_light = {0.1, 0.2, -1};
  const Analysis one = analyze(x, kRoom);
  EXPECT_TRUE(one.map_from_world && !one.map_beyond_from_world);
  EXPECT_TRUE(has_note(one, "one_map_enough"));
  EXPECT_FALSE(one.reversed_depth);
  x.shadow.camera_shift = ShiftRule::inside;
  EXPECT_TRUE(has_note(analyze(x, kRoom), "camera_shift_unused"));
}

TEST(Analyze, TighteningTheDepthRangeRescuesPsm) {
  Experiment x = standing();
  x.camera.near = 0.1;
  x.light.to_light = {0.1, 1, -0.5};
  const Scene low = box_scene({-100, -2, -100}, {100, 0, 0});
  const Analysis tight = analyze(x, low);
  x.shadow.near_fit = NearFit::off;
  const Analysis loose = analyze(x, low);
  const auto spread = [](const Analysis& a) {
    const Range<double> c = value_range<double>(row(*a.map_from_world, 3), a.receivers_body.vertices);
    return c.max / c.min;
  };
  EXPECT_GT(*tight.near, 1.0);
  EXPECT_EQ(*loose.near, 0.1);
  EXPECT_NE(spread(tight), spread(loose));
}

struct HardCase {
  const char* name;
  std::function<void(Experiment&)> set;
  Scene scene = kRoom;
};

TEST(Analyze, HardCasesStayFinite) {
  const auto point = [](dvec3 p) { return [p](Experiment& x) { x.light.type = LightType::point, x.light.position = p; }; };
  const auto sun = [](dvec3 l) { return [l](Experiment& x) { x.light.to_light = l; }; };
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<HardCase> cases = {
      {"light at the eye", point({0, 1.7, 0})},
      {"light a hair in front", point({0, 1.7, -1e-6})},
      {"light a hair behind", point({0, 1.7, 1e-6})},
      {"light in the camera plane", point({3, 1.7, 0})},
      {"light in R", point({0, 1, -3})},
      {"light on a face of R", point({0, 0, -3})},
      {"light on a corner of S", point({4, 3, 5})},
      {"light just outside S", point({0, 3 + 1e-9, -3})},
      {"sun straight up", sun({0, 1, 0})},
      {"sun straight down", sun({0, -1, 0})},
      {"sun along the view", sun({0, 0, -1})},
      {"sun behind", sun({0, 0, 1})},
      {"tiny light vector", sun({1e-30, 2e-30, -1e-30})},
      {"huge light vector", sun({1e30, 2e30, -1e30})},
      {"infinite far", [&](Experiment& x) { x.camera.far = inf; }},
      {"infinite far, no fit", [&](Experiment& x) { x.camera.far = inf, x.shadow.near_fit = NearFit::off; }},
      {"nothing visible",
       [](Experiment& x) {
         x.camera.target = {0, 50, -1};
       }},
      {"nothing visible, point light inside",
       [](Experiment& x) {
         x.camera.position = {0, 50, 0}, x.camera.target = {0, 60, -1}, x.light.type = LightType::point,
         x.light.position = {0, 1, 0};
       }},
      {"spot inside the frustum",
       [](Experiment& x) {
         x.light.type = LightType::spot, x.light.position = {0, 1, -3}, x.light.target = {0, 0, -4};
       }},
      {"flat scene", sun({0.3, 1, 0.2}), box_scene({-5, 0, -9}, {5, 0, 0})},
      {"flat scene, light in its plane", sun({1, 0, 0}), box_scene({-5, 0, -9}, {5, 0, 0})},
      {"scene is a point", sun({0.3, 1, 0.2}), box_scene({0, 1.7, -3}, {0, 1.7, -3})},
      {"spot on a scene without extent",
       [](Experiment& x) {
         x.light.type = LightType::spot, x.light.position = {0, 1.7, -3}, x.light.target = {0, 1, -3};
       },
       box_scene({0, 1.7, -3}, {0, 1.7, -3})},
      {"scene is a line", sun({0.3, 1, 0.2}), box_scene({0, 1.7, -3}, {0, 1.7, -5})},
      {"far from the origin", [](Experiment& x) { x.camera.position += 6.4e6, x.camera.target += 6.4e6; },
       box_scene(kRoom.bounds.min + 6.4e6, kRoom.bounds.max + 6.4e6)},
  };
  for (const HardCase& c : cases)
    for (int t = 0; t < 13; ++t) {
      SCOPED_TRACE(::testing::Message() << c.name << ", " << name_of(Technique(t)));
      Experiment x = standing(Technique(t));
      x.camera.near = 0.1;
      c.set(x);
      const Analysis a = analyze(x, c.scene);
      if (std::string(c.name).find("origin") != std::string::npos) {
        EXPECT_TRUE(finite(*a.map_from_world));  // roundings of 6.4e6 are larger than the contract's tolerance
      } else {
        expect_contract(a);
      }
      EXPECT_THAT(analysis_to_json(a, c.scene), ::testing::Not(::testing::ContainsRegex("[^a-z]nan")));
    }
}

TEST(Analyze, LightInsideTheReceiversGetsSixMaps) {
  Experiment x = standing();
  x.camera.near = 0.1;
  x.light.type = LightType::point;
  x.light.position = {0, 1, -3};
  const Analysis a = analyze(x, kRoom);
  EXPECT_TRUE(a.cube_maps_from_world && !a.map_from_world && a.light_case.inside_receivers && a.light_case.inside_frustum);
  x.light.position = {0, 1, 3};  // inside S, behind the eye
  const Analysis b = analyze(x, kRoom);
  EXPECT_TRUE(b.map_from_world && !b.light_case.inside_receivers);
  EXPECT_TRUE(has_note(b, "light_near_distance"));
}

}  // namespace
}  // namespace psm
