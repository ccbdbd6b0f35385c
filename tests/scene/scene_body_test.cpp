// SPDX-License-Identifier: GPL-3.0-or-later
// S in its two grains, on the built-in scenes and on scenes of little extent.
#include <gtest/gtest.h>

#include "math/shadow_map.h"
#include "scene/analysis.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4;

Experiment experiment_of(const Scene& scene, SceneBody grain) {
  Experiment x;
  if (scene.camera) x.camera = *scene.camera;
  if (scene.light) x.light = *scene.light;
  x.shadow.scene_body = grain;
  return x;
}

const Note* find_note(const Analysis& a, const std::string& code) {
  for (const Note& n : a.notes)
    if (n.code == code) return &n;
  return nullptr;
}

bool holds(const ConvexBody& body, const dvec3& p) {
  return std::all_of(body.planes.begin(), body.planes.end(), [&](const Plane& q) { return exact_side(q, dvec4(p, 1)) >= 0; });
}

/// Two walls side by side, aslant in their box: the hull is thin where the box is not.
Scene wall_aslant() {
  Scene scene;
  scene.materials.resize(1);
  const auto add = [&](std::vector<dvec3> corners) {
    Mesh mesh;
    mesh.positions = std::move(corners);
    mesh.triangles = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
  };
  add({{-5, 0, 0}, {5, 0, -10}, {5, 2, -10}, {-5, 2, 0}});
  add({{-5, 0, 1}, {5, 0, -9}, {5, 2, -9}, {-5, 2, 1}});
  update_bounds(scene);
  return scene;
}

// The map's window touches R, whichever S made R.
void expect_window_touches(const Analysis& a) {
  ASSERT_TRUE(a.map_from_world);
  Range<double> u, v;
  for (const dvec3& p : a.receivers_body.vertices) {
    const dvec4 q = *a.map_from_world * dvec4(p, 1);
    u.add(q.x / q.w), v.add(q.y / q.w);
  }
  for (const auto& r : {u, v}) {
    EXPECT_NEAR(r.min, -1, 1e-9);
    EXPECT_NEAR(r.max, 1, 1e-9);
  }
}

TEST(SceneBody, HullOfABuiltInSceneHoldsWhatMattersInsideTheBox) {
  for (const std::string& id : builtin_scene_ids()) {
    SCOPED_TRACE(id);
    const Scene scene = *builtin_scene(id);
    const Analysis box = analyze(experiment_of(scene, SceneBody::box), scene);
    const Analysis hull = analyze(experiment_of(scene, SceneBody::hull), scene);
    EXPECT_EQ(box.scene_body_used, SceneBody::box);
    EXPECT_EQ(hull.scene_body_used, SceneBody::hull);
    EXPECT_LE(hull.scene_body.volume(), box.scene_body.volume() * (1 + 1e-12));
    EXPECT_TRUE(id == "ceiling" || hull.scene_body.volume() < 0.999 * box.scene_body.volume()) << "a hall fills its box";
    EXPECT_LE(hull.receivers_body.volume(), box.receivers_body.volume() * (1 + 1e-12));
    EXPECT_LE(hull.depth_body.volume(), box.depth_body.volume() * (1 + 1e-12));
    const Note* note = find_note(hull, "scene_body_hull");
    ASSERT_TRUE(note);
    EXPECT_GT(*note->value, 0);
    EXPECT_LE(*note->value, 1 + 1e-12);
    expect_window_touches(hull);
    for (const Mesh& mesh : scene.meshes)
      for (const dvec3& p : mesh.positions) ASSERT_TRUE(!holds(box.caster_body, p) || holds(hull.scene_body, p));
  }
}

TEST(SceneBody, CastersOutOfReachDoNotCount) {
  Scene scene = wall_aslant();
  Mesh behind = scene.meshes[0];
  for (dvec3& p : behind.positions) p += dvec3(0, -3, 40);  // behind the eye, and not towards the sun
  scene.meshes.push_back(behind);
  update_bounds(scene);
  Experiment x = experiment_of(scene, SceneBody::hull);
  x.camera = {{0, 1, 5}, {0, 1, -5}, {0, 1, 0}, 60, 0.1, 100};
  x.light.to_light = {0.2, 1, -0.3};
  const Analysis with = analyze(x, scene), without = analyze(x, wall_aslant());
  for (const dvec3& p : behind.positions) EXPECT_FALSE(holds(with.scene_body, p));
  for (const Mesh& mesh : wall_aslant().meshes)
    for (const dvec3& p : mesh.positions) EXPECT_TRUE(holds(with.scene_body, p));
  EXPECT_GT(without.scene_body.volume(), 0);
}

TEST(SceneBody, AutoTakesTheHullWhereItShrinksTheReceivers) {
  const Scene fence = wall_aslant();
  Experiment x = experiment_of(fence, SceneBody::automatic);
  x.camera = {{0, 1, 5}, {0, 1, -5}, {0, 1, 0}, 60, 0.1, 100};
  const Analysis a = analyze(x, fence);
  EXPECT_EQ(a.scene_body_used, SceneBody::hull);
  ASSERT_TRUE(find_note(a, "scene_body_hull"));
  EXPECT_LE(*find_note(a, "scene_body_hull")->value, *find_note(a, "scene_body_hull")->limit);
  Scene cube = box_scene(dvec3(-3), dvec3(3));
  cube.meshes[0].positions.clear();
  for (int i = 0; i < 8; ++i) cube.meshes[0].positions.emplace_back(i & 1 ? 3 : -3, i & 2 ? 3 : -3, i & 4 ? 3 : -3);
  update_bounds(cube);
  const Analysis b = analyze(x, cube);  // a box's hull is the box
  EXPECT_EQ(b.scene_body_used, SceneBody::box);
  ASSERT_TRUE(find_note(b, "scene_body_box"));
  EXPECT_GT(*find_note(b, "scene_body_box")->value, *find_note(b, "scene_body_box")->limit);
}

// The light in the box's empty corner: with the box it is among its receivers, with the hull one map does.
TEST(SceneBody, ALightInTheEmptyCornerOfTheBoxIsOutsideTheHull) {
  const Scene fence = wall_aslant();
  Experiment x = experiment_of(fence, SceneBody::box);
  x.camera = {{0, 1, 5}, {0, 1, -5}, {0, 1, 0}, 60, 0.1, 100};
  x.light.type = LightType::point;
  x.light.position = {1, 1.5, -1};
  EXPECT_TRUE(analyze(x, fence).cube_maps_from_world);
  x.shadow.scene_body = SceneBody::hull;
  const Analysis a = analyze(x, fence);
  EXPECT_TRUE(a.map_from_world);
  EXPECT_FALSE(a.light_case.inside_receivers);
}

// Along the y axis the walls' hull is a parallelogram of area 10 in a box of 10 x 11.
TEST(SceneBody, TheNumberIsTheAreaThatTheLightSees) {
  const Scene walls = wall_aslant();
  Experiment x = experiment_of(walls, SceneBody::hull);
  x.camera = {{0, 1, 50}, {0, 1, 0}, {0, 1, 0}, 60, 0.1, 100};
  x.light.to_light = {0, 1, 0};
  const Analysis a = analyze(x, walls);
  ASSERT_TRUE(find_note(a, "scene_body_hull"));
  EXPECT_NEAR(*find_note(a, "scene_body_hull")->value, 10.0 / 110.0, 1e-12);
}

TEST(SceneBody, EmptyFlatAndSinglePointScenesAreResults) {
  Scene nothing;
  nothing.materials.resize(1);
  update_bounds(nothing);
  Scene flat = box_scene({-5, 0, -9}, {5, 0, 0});
  const Scene scenes[] = {nothing, flat, box_scene({0, 1, -3}, {0, 1, -3}), box_scene({-2, 0, -6}, {3, 2, -1})};
  for (const Scene& scene : scenes)
    for (const SceneBody grain : {SceneBody::box, SceneBody::hull, SceneBody::automatic})
      for (const LightType light : {LightType::directional, LightType::point, LightType::spot}) {
        Experiment x = experiment_of(scene, grain);
        x.camera = {{0, 1, 2}, {0, 0.5, -5}, {0, 1, 0}, 60, 0.1, 100};
        x.light.type = light;
        const Analysis a = analyze(x, scene);
        EXPECT_TRUE(a.map_from_world || a.cube_maps_from_world);
        EXPECT_FALSE(a.scene_body.empty());
        EXPECT_EQ(analysis_to_json(a, scene).find("nan,"), std::string::npos);
        EXPECT_EQ(grain == SceneBody::box, !find_note(a, "scene_body_box") && !find_note(a, "scene_body_hull"));
      }
}

}  // namespace
}  // namespace psm
