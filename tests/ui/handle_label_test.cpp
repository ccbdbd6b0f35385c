// SPDX-License-Identifier: GPL-3.0-or-later
// A handle under the mouse says its name once.
#include "harness.h"
#include "ui/handles.h"

namespace psm::test {
namespace {

void expect_names(const std::vector<std::string>& overrides) {
  Bench bench("ground", overrides);
  const auto& world = bench.work().images().picture(ViewId::world);
  const glm::ivec2 size = bench.work_places().at("view.world").size();
  for (const Handle& handle : handles(world, bench.experiment(), size)) {
    const bool target = handle.kind == HandleKind::camera_target || handle.kind == HandleKind::light_target;
    const bool patch = handle.kind == HandleKind::plane;  // named at its patch's corner
    EXPECT_EQ(is_labelled(handle, world, size), !target && !patch) << name_of(handle.kind);
  }
}

TEST(HandleLabel, TheSunIsNamedByThePicture) { expect_names({}); }
TEST(HandleLabel, ALampIsNamedByThePicture) { expect_names({"light.type=point", "light.position=-6,9,-8"}); }
TEST(HandleLabel, TargetsAreNot) { expect_names({"light.type=spot", "light.position=-6,9,-8", "light.target=0,0,-12"}); }

}  // namespace
}  // namespace psm::test
