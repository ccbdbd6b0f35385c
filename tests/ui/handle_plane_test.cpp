// SPDX-License-Identifier: GPL-3.0-or-later
// The vanishing plane dragged in the world view: it becomes technique custom's own and keeps passing through the light.
#include "harness.h"
#include "ui/handles.h"

namespace psm::test {
namespace {

struct PlaneDrag {
  explicit PlaneDrag(const std::vector<std::string>& overrides) : bench("ground", overrides) {
    const auto& world = bench.work().images().picture(ViewId::world);
    const glm::ivec2 size = bench.work_places().at("view.world").size();
    const auto all = handles(world, bench.experiment(), size);
    const auto found = std::find_if(all.begin(), all.end(), [](const Handle& h) { return h.kind == HandleKind::plane; });
    if (found == all.end()) return;
    const OrbitCamera camera = view_camera(ViewId::world, bench.work().images().analysis(), double(size.x) / size.y);
    const glm::dvec4 plane = shown_vanishing_plane(bench.analysis()).value_or(glm::dvec4(0.0));
    drag = HandleDrag{*found, bench.experiment(), camera, size, found->pixel, plane};
  }
  glm::dvec4 after(glm::dvec2 way, bool vertical = false) const {
    const Experiment e = dragged(*drag, drag->start + way, vertical);
    EXPECT_EQ(e.shadow.technique, Technique::custom);
    return *e.shadow.plane;
  }
  Bench bench;
  std::optional<HandleDrag> drag;
};

glm::dvec3 normal_of(const glm::dvec4& plane) { return glm::normalize(glm::dvec3(plane)); }
double distance(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(plane, glm::dvec4(p, 1.0)) / glm::length(glm::dvec3(plane));
}

TEST(HandlePlane, ASunsMovesAlongItsNormal) {
  PlaneDrag d({});
  ASSERT_TRUE(d.drag);
  const glm::dvec4 moved = d.after({40, 10});
  EXPECT_LT(glm::length(normal_of(moved) - normal_of(d.drag->plane)), 1e-9);
  EXPECT_NEAR(glm::dot(normal_of(moved), glm::normalize(d.bench.experiment().light.to_light)), 0.0, 1e-12);
  EXPECT_GT(std::abs(distance(moved, d.drag->handle.position)), 0.01);
}

TEST(HandlePlane, WithShiftASunsTurnsAboutTheLight) {
  PlaneDrag d({});
  ASSERT_TRUE(d.drag);
  const glm::dvec4 turned = d.after({50, 0}, true);
  EXPECT_NEAR(glm::dot(normal_of(turned), normal_of(d.drag->plane)), std::cos(0.5), 1e-9);
  EXPECT_NEAR(glm::dot(normal_of(turned), glm::normalize(d.bench.experiment().light.to_light)), 0.0, 1e-12);
  EXPECT_NEAR(distance(turned, d.drag->handle.position), 0.0, 1e-9);
}

TEST(HandlePlane, ALampsTurnsAboutTheLamp) {
  PlaneDrag d({"light.type=point", "light.position=-6,9,-8"});
  ASSERT_TRUE(d.drag);
  const glm::dvec4 turned = d.after({30, -20});
  EXPECT_NEAR(distance(turned, d.bench.experiment().light.position), 0.0, 1e-9);
  EXPECT_GT(std::abs(distance(turned, d.drag->handle.position)), 0.01);
}

TEST(HandlePlane, ARefusedPlaneStaysToBeDraggedBack) {
  PlaneDrag d({"shadow.technique=custom", "shadow.plane=0,0,-1,-5", "light.to_light=0,1,0"});
  EXPECT_NE(d.bench.analysis().technique_used, Technique::custom);
  const auto& world = d.bench.work().images().picture(ViewId::world);
  const auto all = handles(world, d.bench.experiment(), d.bench.work_places().at("view.world").size());
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Handle& h) { return h.kind == HandleKind::plane; }));
}

}  // namespace
}  // namespace psm::test
