// SPDX-License-Identifier: GPL-3.0-or-later
// Number boxes: a click types, a drag changes, Tab goes on.
#include "harness.h"

namespace psm::test {
namespace {

TEST(NumberBox, AClickTypesAndItsKeysFireNoShortcuts) {
  Bench bench;
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.7));
  const LightSettings light = bench.experiment().light;
  bench.click(bench.at("camera.position.y"));
  bench.key('R');
  EXPECT_EQ(bench.experiment().light, light) << "R resets while a number is typed";
  bench.type("12.5");
  bench.key(key::enter);
  EXPECT_EQ(bench.experiment().camera.position.y, 12.5);
}

TEST(NumberBox, KeysRightAfterTheClickAreForTheField) {
  Bench bench;
  const glm::dvec2 box = bench.at("camera.position.y");
  bench.drag(bench.at("theta", 0.44), bench.at("theta", 0.7));
  const LightSettings light = bench.experiment().light;
  bench.press(box);
  bench.input().mouse_button(0, false);
  bench.input().key('R', true);
  bench.input().key('R', false);
  bench.input().text('7');
  bench.settle();
  bench.key(key::enter);
  EXPECT_EQ(bench.experiment().light, light);
  EXPECT_EQ(bench.experiment().camera.position.y, 7.0);
}

TEST(NumberBox, TabGoesToTheNextComponent) {
  Bench bench;
  bench.click(bench.at("camera.position.x"));
  bench.type("1.5");
  bench.key(key::tab);
  bench.type("2.5");
  bench.key(key::tab);
  bench.type("3.5");
  bench.key(key::enter);
  EXPECT_EQ(bench.experiment().camera.position, glm::dvec3(1.5, 2.5, 3.5));
}

TEST(NumberBox, ADragChangesTheValueAndTypesNothing) {
  Bench bench;
  const double before = bench.experiment().camera.position.y;
  bench.drag(bench.at("camera.position.y", 0.3), bench.at("camera.position.y", 0.9));
  EXPECT_NE(bench.experiment().camera.position.y, before);
  bench.key('R');
  EXPECT_EQ(bench.experiment().camera.position.y, before) << "shortcuts are back after a drag";
}

}  // namespace
}  // namespace psm::test
